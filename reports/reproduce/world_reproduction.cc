#include <fmt/format.h>
#include <fmt/ranges.h>

#include "reports/reproduce/cpp_text.h"
#include "reports/reproduce/project_files.h"
#include "reports/reproduce/reproduction.h"
#include "reports/reproduce/world_check.h"
#include "reports/reproduce/world_code.h"
#include "reports/text/commented.h"
#include "reports/text/counted.h"
#include "reports/text/format_vector.h"

namespace touchstone {
namespace {

constexpr const char* kProgram = R"(//
// Exit code: 1 if the fault is there, 0 if it is gone.
// SI units; rotations are matrices, row by row.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <memory>
#include <set>
#include <vector>

{includes}
namespace {{

using Vector = std::array<double, 3>;
{bodies}{definitions}
// Simulates the world up to the last of the wanted steps; returns the states after them.
std::map<int, WorldState> Simulate(const std::set<int>& wanted) {{
{simulate}}}
{check_definitions}
}}  // namespace

int main() {{
  const double allowed = {allowed};
  const std::map<int, WorldState> states = Simulate({{{steps}}});
{check}  std::printf("%s: error %.17g, allowed %.17g\n", {measure}, error, allowed);
  std::printf("%s\n", {proof});
  const bool is_right = error <= allowed;  // A NaN is wrong.
  std::printf("%s\n", is_right ? "The fault is gone." : "The fault is there.");
  return is_right ? 0 : 1;
}}
)";

std::string Describe(const World& world) {
  std::vector<std::string_view> names;
  for (const RigidBody& body : world.bodies) names.push_back(body.name);
  return fmt::format("{} ({}) under gravity {} m/s², {} of {:.6g} s.",
                     Counted(names.size(), "body", "bodies"), fmt::join(names, ", "),
                     FormatVector(world.gravity_W, 6),
                     Counted(static_cast<std::size_t>(world.steps), "step"), world.dt);
}

}  // namespace

Reproduction Reproduce(const WorldResult& result, const OracleInfo& oracle,
                       const Finding& finding) {
  const WorldScenario& scenario = result.scenario;
  const EngineCode engine = WorldCodeOf(scenario.world, oracle);
  const WorldCheck check = CheckOf(finding, scenario, result.trajectories.front());
  const std::string title = TitleOf(oracle, finding);
  const std::string asked =
      fmt::format("{}. {}", scenario.title, Describe(scenario.world));
  Reproduction files;
  files.program =
      Commented(title + ".", "// ") + "//\n" + Commented(asked, "// ") +
      Commented(scenario.source, "// ") +
      Commented(fmt::format("Simulated by {}.", engine.call), "// ") + "//\n" +
      Commented(fmt::format("Proof: {}", finding.proof), "// ") +
      Commented(fmt::format("The error is {:.9g}; allowed is {:.9g}: {}.", finding.value,
                            finding.tolerance, finding.tolerance_because),
                "// ") +
      fmt::format(kProgram, fmt::arg("includes", engine.includes),
                  fmt::arg("bodies", BodiesText(scenario.world)),
                  fmt::arg("definitions", engine.definitions),
                  fmt::arg("simulate", engine.ask),
                  fmt::arg("check_definitions", check.code.definitions),
                  fmt::arg("check", check.code.statements),
                  fmt::arg("steps", fmt::join(check.steps, ", ")),
                  fmt::arg("allowed", Literal(finding.tolerance)),
                  fmt::arg("measure", Quoted(NameOf(finding.measure))),
                  fmt::arg("proof", Quoted("When written: " + finding.proof)));
  files.build = BuildFile(engine);
  files.title = title;
  files.report = ReportOf({.asked = asked, .truth = {}}, oracle, engine, finding);
  return files;
}

}  // namespace touchstone
