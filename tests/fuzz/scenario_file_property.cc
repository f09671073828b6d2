#include "tests/fuzz/scenario_file_property.h"

#include "scenarios/scenario_file.h"
#include "scenarios/validate_scenario.h"
#include "tests/scenarios/same_bits.h"

namespace touchstone {

std::string FaultOfReading(std::string_view text) {
  const ReadResult read = ReadScenario(text, "f.toml");
  if (read.scenario.has_value() != read.diagnostics.empty()) {
    return "neither a scenario nor a diagnostic, or both";
  }
  for (const Diagnostic& diagnostic : read.diagnostics) {
    if (diagnostic.line < 1 || diagnostic.column < 1 || diagnostic.what.empty() ||
        diagnostic.expected.empty()) {
      return "a diagnostic without a place or a text: " + ToString(diagnostic);
    }
  }
  if (!read.scenario) return "";
  for (const Fault& fault : FaultsOf(*read.scenario)) {
    return "accepted although " + fault.where + " " + fault.what;
  }
  const std::string written = WriteScenario(*read.scenario);
  const ReadResult again = ReadScenario(written, "written.toml");
  if (!again.scenario) return "refused what was written:\n" + written;
  if (!SameBits(*again.scenario, *read.scenario))
    return "read back otherwise:\n" + written;
  if (WriteScenario(*again.scenario) != written) return "not stable:\n" + written;
  return "";
}

}  // namespace touchstone
