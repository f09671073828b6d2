#include "reports/writers/conclusion.h"

#include <algorithm>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

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

/** Returns how the subject did: "cookbook never failed (it answers 298 of the 702
 scenarios)". */
std::string SubjectInWords(std::string_view subject, const VerdictCounts& counts,
                           std::size_t questions) {
  const auto unsupported = static_cast<std::size_t>(counts[Verdict::kUnsupported]);
  if (unsupported == questions)
    return fmt::format("{} answered no scenario of {}", subject, questions);
  const auto undecidable = static_cast<std::size_t>(counts[Verdict::kUndecidable]);
  if (unsupported + undecidable == questions)
    return undecidable == 1 ? fmt::format("the only answer of {} is undecidable", subject)
                            : fmt::format("all {} answers of {} are undecidable",
                                          undecidable, subject);
  const std::string failures =
      FailuresInWords(counts.failed(), counts[Verdict::kKnown], "scenario");
  if (unsupported == 0)
    return fmt::format("{} {} (it answers {} scenario{})", subject, failures,
                       questions == 1 ? "the only" : fmt::format("all {}", questions),
                       questions == 1 ? "" : "s");
  return fmt::format("{} {} (it answers {} of the {} scenarios)", subject, failures,
                     questions - unsupported, questions);
}

/** Returns "556 contact questions and 1 world", without a kind that was not asked. */
std::string QuestionsInWords(const RunReport& report) {
  std::vector<std::string> kinds;
  if (!report.scenarios.empty())
    kinds.push_back(Counted(report.scenarios.size(), "contact question"));
  if (!report.worlds.empty()) kinds.push_back(Counted(report.worlds.size(), "world"));
  return kinds.empty() ? "no question" : fmt::format("{}", fmt::join(kinds, " and "));
}

}  // namespace

std::string AnswersInWords(const RunReport& report) {
  std::set<std::string_view> answering;
  for (const Finding& finding : report.findings) {
    if (finding.verdict != Verdict::kUnsupported) answering.insert(finding.oracle);
  }
  std::string words = fmt::format("{} answered {}", Counted(answering.size(), "oracle"),
                                  QuestionsInWords(report));
  const std::size_t silent = report.oracles.size() - answering.size();
  if (silent > 0 && QuestionCount(report) == 1) {
    words +=
        fmt::format("; {} not support it", Counted(silent, "oracle does", "oracles do"));
  } else if (silent > 0) {
    words += fmt::format("; {} none of them",
                         Counted(silent, "oracle supports", "oracles support"));
  }
  return words + ".";
}

std::string ConclusionOf(const RunReport& report, std::span<const Outcome> outcomes,
                         const FailureRule& rule) {
  VerdictCounts counts;
  VerdictCounts of_subject;
  for (const Outcome& outcome : outcomes) {
    Count(outcome, counts);
    if (outcome.oracle == 0) ++of_subject[outcome.verdict];
  }
  const std::string failed = FailedReferences(report, outcomes);
  // The failures come first: "FAILED: cookbook never failed" would contradict itself.
  const int failed_references = counts.failed() - of_subject.failed();
  std::vector<std::string> parts = {
      SubjectInWords(report.subject, of_subject, QuestionCount(report))};
  if (report.oracles.size() > 1) {
    parts.push_back(fmt::format(
        "the other oracles {}{}",
        FailuresInWords(failed_references,
                        counts[Verdict::kKnown] - of_subject[Verdict::kKnown], "answer"),
        failed.empty() ? "" : fmt::format(" ({})", failed)));
  }
  const int code = ExitCode(report, rule);
  const bool a_reference_counts =
      std::ranges::any_of(outcomes, [&](const Outcome& outcome) {
        return outcome.oracle != 0 && CountsAsFailure(outcome, report, rule);
      });
  if (code == 1 && of_subject.failed() == 0 && a_reference_counts)
    std::reverse(parts.begin(), parts.end());
  std::string conclusion = fmt::format("{}: {}", Headline(code), fmt::join(parts, "; "));
  const std::size_t improved = ImprovedCount(report);
  if (improved > 0) {
    conclusion += fmt::format(
        "; {} less than allowed: lower or remove {}",
        Counted(improved, "entry of the ledger hides", "entries of the ledger hide"),
        improved == 1 ? "it" : "them");
  }
  if (report.faults.size() > improved) {
    conclusion += fmt::format("; {} in the scenario files and the ledger",
                              Counted(report.faults.size() - improved, "fault"));
  }
  if (!report.regressions.empty()) {
    conclusion += fmt::format("; {} worse than in the baseline",
                              Counted(report.regressions.size(), "finding"));
  }
  return conclusion;
}

}  // namespace touchstone
