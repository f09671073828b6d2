#include <fmt/format.h>

#include "scenarios/scenario_file.h"
#include "scenarios/toml/toml_text.h"
#include "scenarios/toml/write_parts.h"

namespace touchstone {
namespace {

using toml_text::Line;
using toml_text::List;
using toml_text::Number;
using toml_text::Text;
using toml_text::Truth;

std::string BodyTable(std::string_view name, const Body& body) {
  return fmt::format("\n[bodies.{}]\n", name) + BodyLines(body);
}

std::string ExpectTable(const ContactExpectation& expect) {
  std::string lines;
  if (expect.touching) lines += Line("touching", Truth(*expect.touching));
  if (expect.separation) lines += Line("separation", Number(*expect.separation));
  if (!expect.normals.empty()) lines += Line("normals", List(expect.normals));
  if (expect.contacts) lines += Line("contacts", std::to_string(*expect.contacts));
  return lines.empty() ? lines : "\n[expect]\n" + lines;
}

std::string ToleranceTable(const ToleranceOverride& tolerance) {
  return "\n[tolerance]\n" + Line("separation", Number(tolerance.separation)) +
         Line("because", Text(tolerance.because));
}

}  // namespace

std::string WriteScenario(const Scenario& scenario) {
  std::string file = HeadingLines(scenario.id, scenario.title, scenario.source) +
                     BodyTable(scenario.name_A, scenario.contact.A) +
                     BodyTable(scenario.name_B, scenario.contact.B) + "\n[contact]\n" +
                     Line("A", Text(scenario.name_A)) + Line("B", Text(scenario.name_B)) +
                     ExpectTable(scenario.expect);
  if (scenario.tolerance) file += ToleranceTable(*scenario.tolerance);
  return file + IndictmentTables(scenario.indicts);
}

}  // namespace touchstone
