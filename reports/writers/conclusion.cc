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

/** Returns "never failed", "failed in 3 answers, and in 2 that the ledger knows", …. */
std::string FailuresInWords(int failures, int known, std::string_view what) {
  if (failures == 0 && known == 0) return "never failed";
  if (failures == 0)
    return fmt::format("failed only in {} that the ledger knows", Counted(known, what));
  return fmt::format(
      "failed in {}{}", Counted(failures, what),
      known > 0 ? fmt::format(", and in {} that the ledger knows", known) : "");
}

/** Returns how the subject did: "cookbook never failed (it answers 288 of the 686
 scenarios)". */
std::string SubjectInWords(std::string_view subject, const VerdictCounts& counts,
                           std::size_t questions) {
  const auto unsupported = static_cast<std::size_t>(counts[Verdict::kUnsupported]);
  if (unsupported == questions)
    return fmt::format("{} answered no scenario of {}", subject, questions);
  const std::string failures =
      FailuresInWords(counts.failed(), counts[Verdict::kKnown], "scenario");
  if (unsupported == 0)
    return fmt::format("{} {} (it answers {} scenario{})", subject, failures,
                       questions == 1 ? "the only" : fmt::format("all {}", questions),
                       questions == 1 ? "" : "s");
  return fmt::format("{} {} (it answers {} of the {} scenarios)", subject, failures,
                     questions - unsupported, questions);
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
  std::string conclusion =
      fmt::format("{}: {}", Headline(ExitCode(report, fail_on)),
                  SubjectInWords(report.subject, of_subject, QuestionCount(report)));
  if (report.oracles.size() > 1) {
    conclusion += fmt::format(
        "; the other oracles {}{}",
        FailuresInWords(counts.failed() - of_subject.failed(),
                        counts[Verdict::kKnown] - of_subject[Verdict::kKnown], "answer"),
        failed.empty() ? "" : fmt::format(" ({})", failed));
  }
  if (!report.faults.empty()) {
    conclusion += fmt::format("; {} in the scenario files and the ledger",
                              Counted(report.faults.size(), "fault"));
  }
  if (!report.regressions.empty()) {
    conclusion += fmt::format("; {} worse than in the baseline",
                              Counted(report.regressions.size(), "finding"));
  }
  return conclusion;
}

}  // namespace touchstone
