#include "reports/writers/conclusion.h"

#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "hand_made_report.h"

namespace touchstone {
namespace {

using testing::Eq;

Finding Of(const char* oracle, Verdict verdict) {
  Finding finding;
  finding.oracle = oracle;
  finding.verdict = verdict;
  return finding;
}

RunReport WithFindings(std::vector<Finding> findings) {
  RunReport report = HandMadeReport();
  report.findings = std::move(findings);
  return report;
}

TEST(AnswersInWords, LeavesOutAKindThatWasNotAsked) {
  EXPECT_THAT(AnswersInWords(HandMadeReport()),
              Eq("2 oracles answered 3 contact questions."));
}

TEST(AnswersInWords, DoesNotCountAnOracleThatSupportsNothing) {
  const RunReport report = WithFindings(
      {Of("mine", Verdict::kPass), Of("theirs/float", Verdict::kUnsupported)});
  EXPECT_THAT(AnswersInWords(report),
              Eq("1 oracle answered 3 contact questions; 1 oracle "
                 "supports none of them."));
}

TEST(AnswersInWords, CountsAnOracleThatSupportsOneOfTheQuestions) {
  const RunReport report =
      WithFindings({Of("mine", Verdict::kUnsupported), Of("mine", Verdict::kFail),
                    Of("theirs/float", Verdict::kCrashed)});
  EXPECT_THAT(AnswersInWords(report), Eq("2 oracles answered 3 contact questions."));
}

TEST(AnswersInWords, SpeaksOfASingleQuestion) {
  RunReport report = WithFindings({});
  report.scenarios.resize(1);
  EXPECT_THAT(AnswersInWords(report),
              Eq("0 oracles answered 1 contact question; 2 oracles do not support it."));
  report.scenarios.clear();
  report.worlds.resize(1);
  report.findings = {Of("mine", Verdict::kPass)};
  EXPECT_THAT(AnswersInWords(report),
              Eq("1 oracle answered 1 world; 1 oracle does not support it."));
}

TEST(AnswersInWords, NamesBothKinds) {
  RunReport report = HandMadeReport();
  report.worlds.resize(2);
  EXPECT_THAT(AnswersInWords(report),
              Eq("2 oracles answered 3 contact questions and 2 worlds."));
}

// Nothing is wrong with an engine, nor with a scenario.
TEST(ConclusionOf, DoesNotCallAnImprovementAFault) {
  RunReport report = WithFindings({Of("mine", Verdict::kPass)});
  report.faults = {
      "known.toml:17: improved: remove this entry, it hides nothing (ode in "
      "contact/box_box/*).",
      "known.toml:30: expired on 2026-01-01: review it."};
  const std::vector<Outcome> outcomes = OutcomesOf(report);
  EXPECT_THAT(
      ConclusionOf(report, outcomes, {.whose = FailOn::kAnything}),
      testing::EndsWith("; 1 entry of the ledger hides less than allowed: lower or "
                        "remove it; 1 fault in the scenario files and the ledger"));
  report.faults.pop_back();
  EXPECT_THAT(ConclusionOf(report, outcomes, {.whose = FailOn::kAnything}),
              testing::EndsWith("lower or remove it"));
}

}  // namespace
}  // namespace touchstone
