#include "reports/reproduce/reproduction.h"

#include <fmt/format.h>

#include "reports/clusters/measure_words.h"
#include "reports/reproduce/cpp_text.h"
#include "reports/reproduce/engine_code.h"
#include "reports/reproduce/fault_check.h"
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

std::string TitleOf(const OracleInfo& oracle, const Finding& finding,
                    const std::string& pair) {
  return fmt::format("{} {} {} ({})", oracle.library, oracle.version,
                     FaultInWords(finding.measure), pair);
}

}  // namespace

Reproduction Reproduce(const ScenarioResult& result, const OracleInfo& oracle,
                       const Finding& finding) {
  const ContactQuery& query = result.scenario.contact;
  const FaultCheck check = CheckOf(finding, query, result.truth);
  const EngineCode engine = CodeOf(query, oracle);
  const std::string pair = fmt::format("{} and {}", NameOf(KindOf(query.A.shape)),
                                       NameOf(KindOf(query.B.shape)));
  const std::string title = TitleOf(oracle, finding, pair);
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
  files.build =
      "cmake_minimum_required(VERSION 3.24)\nproject(reproduce LANGUAGES C CXX)\n"
      "set(CMAKE_CXX_STANDARD 17)\nset(CMAKE_CXX_STANDARD_REQUIRED ON)\n" +
      engine.find +
      "add_executable(reproduce reproduce.cc)\n"
      "target_link_libraries(reproduce PRIVATE engine)\n";
  files.report = fmt::format(
      "# {title}\n\n## Asked\n\n{call}, {library} {version} as on Debian "
      "12.\n\n{bodies}\n"
      "`reproduce.cc` has their exact numbers.\n\n"
      "## Answer and proof\n\n{proof}\n\n## Truth\n\n{truth}\n\n"
      "The error is {value:.3g} where {tolerance:.3g} is allowed: {because}.\n\n"
      "## Build and run\n\n    apt-get install g++ cmake make pkg-config {package}\n"
      "    cmake -S . -B build && cmake --build build && build/reproduce\n\n"
      "The program prints the answer, the truth and the error. It exits 1 if the fault "
      "is there and 0 if it is gone.\n\n## Output\n\nPaste the output of the program "
      "here. "
      "It has not been run yet.\n",
      fmt::arg("title", title), fmt::arg("call", engine.call),
      fmt::arg("library", oracle.library), fmt::arg("version", oracle.version),
      fmt::arg("bodies", bodies), fmt::arg("proof", finding.proof),
      fmt::arg("truth", Describe(query, result.truth)), fmt::arg("value", finding.value),
      fmt::arg("tolerance", finding.tolerance),
      fmt::arg("because", finding.tolerance_because),
      fmt::arg("package", engine.package));
  return files;
}

}  // namespace touchstone
