#include "reports/reproduce/reproduction.h"

#include <fmt/format.h>

#include "reports/reproduce/cpp_text.h"
#include "reports/reproduce/engine_code.h"
#include "reports/reproduce/fault_check.h"
#include "reports/reproduce/project_files.h"
#include "reports/text/commented.h"
#include "reports/writers/describe.h"

namespace touchstone {
namespace {

constexpr const char* kProgram = R"(//
// Exit code: 1 if the fault is there, 0 if it is gone.
// Lengths in metres; rotations are matrices, row by row.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>
#include <vector>

{includes}
namespace {{

using Vector = std::array<double, 3>;

// The engine's answer: n is the unit normal out of A into B; the separation is negative
// where they overlap; a and b are nearest points.
struct Answer {{
  bool touching = false;
  double separation = std::numeric_limits<double>::quiet_NaN();
  Vector n{{}}, a{{}}, b{{}};
}};

{definitions}
Answer Ask() {{
{ask}}}
{check_definitions}
}}  // namespace

int main() {{
  const Answer answer = Ask();
  std::printf("read as: %s, ", answer.touching ? "touching" : "apart");
  if (std::isnan(answer.separation))
    std::printf("no separation\n");
  else
    std::printf("separation %.17g\n", answer.separation);
{check}  const double allowed = {allowed};
  std::printf("%s: error %.17g, allowed %.17g\n", {measure}, error, allowed);
  std::printf("%s\n", {proof});
  const bool is_right = error <= allowed;  // A NaN is wrong.
  std::printf("%s\n", is_right ? "The fault is gone." : "The fault is there.");
  return is_right ? 0 : 1;
}}
)";

}  // namespace

Reproduction Reproduce(const ScenarioResult& result, const OracleInfo& oracle,
                       const Finding& finding) {
  const ContactQuery& query = result.scenario.contact;
  const FaultCheck check = CheckOf(finding, query, result.truth);
  const EngineCode engine = CodeOf(query, oracle);
  const std::string title =
      fmt::format("{} ({} and {})", TitleOf(oracle, finding),
                  NameOf(KindOf(query.A.shape)), NameOf(KindOf(query.B.shape)));
  const std::string bodies =
      fmt::format("A: {}. B: {}.", Describe(query.A), Describe(query.B));
  Reproduction files;
  files.program =
      Commented(title + ".", "// ") + "//\n" + Commented(bodies, "// ") +
      Commented(fmt::format("Asked: {}.", engine.call), "// ") + "//\n" +
      Commented(fmt::format("Proof: {}", finding.proof), "// ") +
      Commented(fmt::format("Truth: {}", Describe(query, result.truth)), "// ") +
      fmt::format(kProgram, fmt::arg("includes", engine.includes),
                  fmt::arg("definitions", engine.definitions),
                  fmt::arg("ask", engine.ask),
                  fmt::arg("check_definitions", check.definitions),
                  fmt::arg("check", check.statements),
                  fmt::arg("allowed", Literal(finding.tolerance)),
                  fmt::arg("measure", Quoted(NameOf(finding.measure))),
                  fmt::arg("proof", Quoted("When written: " + finding.proof)));
  files.build = BuildFile(engine);
  files.report = ReportFile(
      {.title = title, .asked = bodies, .truth = Describe(query, result.truth)}, oracle,
      engine, finding);
  return files;
}

}  // namespace touchstone
