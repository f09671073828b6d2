#include "tests/fuzz/contact_table_property.h"

#include "scenarios/contact_table.h"
#include "scenarios/validate_scenario.h"
#include "tests/scenarios/contact_table_text.h"
#include "tests/scenarios/same_bits.h"

namespace touchstone {

std::string FaultOfReadingTable(std::string_view text) {
  const ContactTable table = ReadContactTable(text, "f.csv");
  if (table.errors.empty() == table.scenarios.empty())
    return "neither questions nor an error, or both";
  for (const Diagnostic& error : table.errors) {
    // An empty table has no place.
    const bool has_place = error.line >= 1 && error.column >= 1;
    const bool is_whole = error.line == 0 && error.column == 0;
    const bool has_text = !error.what.empty() && !error.expected.empty();
    if (has_place == is_whole || !has_text)
      return "an error without a place or a text: " + ToString(error);
  }
  if (!table.errors.empty()) return "";
  for (const Scenario& scenario : table.scenarios) {
    for (const Fault& fault : FaultsOf(scenario))
      return "accepted although " + fault.where + " " + fault.what;
  }
  const std::string written = ContactTableText(table.scenarios);
  const ContactTable again = ReadContactTable(written, "written.csv");
  if (!again.errors.empty())
    return "refused the written table: " + ToString(again.errors.front());
  if (again.note) return "normalised twice: " + ToNote(*again.note);
  if (again.scenarios.size() != table.scenarios.size()) return "rows differ:\n" + written;
  for (std::size_t i = 0; i < table.scenarios.size(); ++i) {
    if (!SameBits(again.scenarios[i].contact, table.scenarios[i].contact))
      return "read back differently:\n" + written;
  }
  return "";
}

}  // namespace touchstone
