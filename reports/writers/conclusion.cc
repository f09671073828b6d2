#include "reports/writers/conclusion.h"

#include <string_view>

#include <fmt/format.h>

#include "reports/text/counted.h"

namespace touchstone {
namespace {

std::string_view Headline(int code) {
  switch (code) {
    case 0:
      return "OK";
    case 1:
      return "FAILED";
    default:
      return "NOTHING VERIFIED";
  }
}

}  // namespace

std::string ConclusionOf(const RunReport& report, std::span<const Outcome> outcomes,
                         FailOn fail_on) {
  VerdictCounts counts;
  VerdictCounts of_subject;
  for (const Outcome& outcome : outcomes) {
    Count(outcome, counts);
    if (outcome.oracle == 0) ++of_subject[outcome.verdict];
  }
  const std::string failed = FailedReferences(report, outcomes);
  const int unsupported = of_subject[Verdict::kUnsupported];
  const std::string not_examined =
      unsupported > 0 ? fmt::format(", was not examined in {}", unsupported) : "";
  const std::string worse =
      report.regressions.empty()
          ? ""
          : fmt::format(", {} worse than in the baseline",
                        Counted(report.regressions.size(), "finding"));
  return fmt::format(
      "{}: {} failed in {}{}, references in {}{}, {} in the scenario files and the "
      "ledger{}",
      Headline(ExitCode(report, fail_on)), report.subject,
      Counted(of_subject.failed(), "scenario"), not_examined,
      Counted(counts.failed() - of_subject.failed(), "answer"),
      failed.empty() ? "" : fmt::format(" ({})", failed),
      Counted(report.faults.size(), "fault"), worse);
}

}  // namespace touchstone
