#include "tests/fuzz/scenario_file_property.h"

#include <optional>

#include "scenarios/scenario_file.h"
#include "scenarios/validate_scenario.h"
#include "scenarios/worlds/validate_world.h"
#include "tests/scenarios/same_bits.h"

namespace touchstone {
namespace {

const auto& In(const ReadResult& read, const Scenario&) {
  return read.scenario;
}
const auto& In(const ReadResult& read, const WorldScenario&) {
  return read.world;
}

/** Returns a fault of a scenario that the reader accepted, of either kind; empty if there
 is none. */
template <class AnyScenario>
std::string FaultOfAccepting(const AnyScenario& scenario) {
  for (const Fault& fault : FaultsOf(scenario)) {
    return "accepted although " + fault.where + " " + fault.what;
  }
  const std::string written = WriteScenario(scenario);
  const ReadResult read = ReadScenario(written, "written.toml");
  const std::optional<AnyScenario>& again = In(read, scenario);
  if (!again) return "refused the written file:\n" + written;
  if (!SameBits(*again, scenario)) return "read back differently:\n" + written;
  if (WriteScenario(*again) != written) return "not stable:\n" + written;
  return "";
}

}  // namespace

std::string FaultOfReading(std::string_view text) {
  const ReadResult read = ReadScenario(text, "f.toml");
  if ((read.scenario.has_value() != read.world.has_value()) != read.diagnostics.empty()) {
    return "neither a scenario nor a diagnostic, or both";
  }
  for (const Diagnostic& diagnostic : read.diagnostics) {
    if (diagnostic.line < 1 || diagnostic.column < 1 || diagnostic.what.empty() ||
        diagnostic.expected.empty()) {
      return "a diagnostic without a place or a text: " + ToString(diagnostic);
    }
  }
  if (read.scenario) return FaultOfAccepting(*read.scenario);
  if (read.world) return FaultOfAccepting(*read.world);
  return "";
}

}  // namespace touchstone
