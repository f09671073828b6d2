#include "reports/reproduce/project_files.h"

#include <fmt/format.h>

#include "reports/clusters/measure_words.h"

namespace touchstone {

std::string TitleOf(const OracleInfo& oracle, const Finding& finding) {
  return fmt::format("{} {} {}", oracle.library, oracle.version,
                     FaultInWords(finding.measure));
}

std::string BuildFile(const EngineCode& engine) {
  return "cmake_minimum_required(VERSION 3.24)\nproject(reproduce LANGUAGES C CXX)\n"
         "set(CMAKE_CXX_STANDARD 17)\nset(CMAKE_CXX_STANDARD_REQUIRED ON)\n" +
         engine.find +
         "add_executable(reproduce reproduce.cc)\n"
         "target_link_libraries(reproduce PRIVATE engine)\n";
}

std::string ReportOf(const ReportParts& parts, const OracleInfo& oracle,
                     const EngineCode& engine, const Finding& finding) {
  const std::string truth =
      parts.truth.empty() ? "" : fmt::format("## Truth\n\n{}\n\n", parts.truth);
  // Neither a missing answer nor a wrong decision has an error that could be smaller.
  const std::string error =
      finding.verdict == Verdict::kFail && finding.measure != MeasureKind::kTouching
          ? fmt::format("The error is {:.3g} where {:.3g} is allowed: {}.\n\n",
                        finding.value, finding.tolerance, finding.tolerance_because)
          : "";
  return fmt::format(
      "## Asked\n\n{call}, {library} {version} as on Debian 12.\n\n{asked}\n"
      "`reproduce.cc` has the exact numbers.\n\n"
      "## Answer and proof\n\n{proof}\n\n{truth}"
      "{error}"
      "## Build and run\n\n    apt-get install g++ cmake make pkg-config {package}\n"
      "    cmake -S . -B build && cmake --build build && build/reproduce\n\n"
      "The program prints the answer and what is wrong with it. It exits 1 if the fault "
      "is there and 0 if it is gone.\n\n",
      fmt::arg("call", engine.call), fmt::arg("library", oracle.library),
      fmt::arg("version", oracle.version), fmt::arg("asked", parts.asked),
      fmt::arg("proof", finding.proof), fmt::arg("truth", truth),
      fmt::arg("error", error), fmt::arg("package", engine.package));
}

}  // namespace touchstone
