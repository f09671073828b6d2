#include "reports/writers/table_writer.h"

#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "hand_made_report.h"

namespace touchstone {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

std::string Table(const RunReport& report, const TableStyle& style = {}) {
  std::ostringstream out;
  WriteTable(report, style, out);
  return out.str();
}

TEST(WriteTable, ShowsEveryFailureAsASentenceWithItsProof) {
  const std::string table = Table(HandMadeReport());
  EXPECT_THAT(table,
              HasSubstr("contact/box_sphere/wrong: A sphere in a <box> & out again"));
  EXPECT_THAT(table, HasSubstr("moving B by 0.04 along n leaves 0.01 of overlap"));
  EXPECT_THAT(table, HasSubstr("also: consistency_error"));
  EXPECT_THAT(table, HasSubstr("theirs/float: invalid"));
}

TEST(WriteTable, CountsEveryVerdict) {
  EXPECT_THAT(Table(HandMadeReport()),
              HasSubstr("3 scenarios × 2 oracles: 1 pass, 1 fail, 0 disagree, 1 known, "
                        "1 undecidable (1 truth unknown), 1 unsupported, 0 crashed, 0 "
                        "timed out, 1 invalid"));
}

TEST(WriteTable, RanksFaultsAndSaysWhichTheLedgerKnows) {
  const std::string table = Table(HandMadeReport());
  EXPECT_THAT(table, HasSubstr("Faults: 4, 3 new, 1 in the ledger\n  unusable          "
                               "New: theirs/float gives an invalid answer. In 1 "
                               "scenario.\n"));
  EXPECT_THAT(table, HasSubstr("Float build. theirs/float, in 1 scenario."));
}

TEST(WriteTable, ShowsTenFaultsAtMost) {
  RunReport report = HandMadeReport();
  report.findings[0].verdict = Verdict::kFail;
  Finding fault = report.findings[0];
  report.findings.clear();
  for (int m = 0; m < 12; ++m) {
    fault.measure = static_cast<MeasureKind>(m);
    report.findings.push_back(fault);
  }
  EXPECT_THAT(Table(report), HasSubstr("  and 2 more, in the page of --out DIR"));
}

TEST(WriteTable, NamesWhoIsNeverWrong) {
  RunReport report = HandMadeReport();
  EXPECT_THAT(Table(report), Not(HasSubstr("Never proved wrong")));
  for (Finding& finding : report.findings) {
    if (finding.oracle == "mine") finding.verdict = Verdict::kPass;
  }
  EXPECT_THAT(Table(report), HasSubstr("Never proved wrong: mine\n"));
}

TEST(WriteTable, WrapsSentencesToTheWidthOfTheTerminal) {
  const std::string table = Table(HandMadeReport(), {.quiet = true, .width = 60});
  EXPECT_THAT(table, HasSubstr("\n    "));
  std::istringstream lines(table);
  std::string line;
  while (std::getline(lines, line) && line.find("scenarios ×") == std::string::npos)
    EXPECT_LE(line.size(), line.starts_with("contact") ? 100U : 62U) << line;
}

TEST(WriteTable, CountsReasonsOfLargeRunsOnly) {
  RunReport report = HandMadeReport();
  while (report.scenarios.size() < 21) {
    report.scenarios.push_back(report.scenarios.back());
    report.scenarios.back().scenario.id += 'z';
  }
  EXPECT_THAT(Table(report), HasSubstr("Unsupported 19 times, for 1 reason\n"));
}

TEST(WriteTable, SaysWhichEntriesAreForAnotherVersion) {
  RunReport report = HandMadeReport();
  EXPECT_THAT(Table(report), Not(HasSubstr("excuse")));
  report.ledger.entries[1].version = "0.9";
  report.ledger_use[1].voided = true;
  EXPECT_THAT(Table(report), HasSubstr("Ledger: 1 entry for theirs/float 0.9 excuses "
                                       "nothing: its version here is 1.2\n"));
}

TEST(WriteTable, ListsWhatGotWorseAndCountsIt) {
  RunReport report = HandMadeReport();
  EXPECT_THAT(Table(report), Not(HasSubstr("baseline")));
  report.regressions = {{"theirs/float", "a: theirs/float excess: was 1, is 3 m"}};
  EXPECT_THAT(Table(report),
              testing::AllOf(
                  HasSubstr("Worse than in the baseline\n  ✗ a: theirs/float excess: was "
                            "1, is 3 m\n"),
                  HasSubstr("; 1 finding worse than in the baseline\n")));
  EXPECT_THAT(Table(report, {.rule = {.whose = FailOn::kSubject}}),
              Not(HasSubstr("was 1, is 3 m")));
}

TEST(WriteTable, CountsUnverifiedClaims) {
  RunReport report = HandMadeReport();
  EXPECT_THAT(Table(report), Not(HasSubstr("Unverified")));
  Finding unverified = report.findings.front();
  unverified.reference = "law";
  unverified.verdict = Verdict::kUnsupported;
  unverified.proof = "coulomb_cone: nothing";
  report.findings.insert(report.findings.begin() + 1, 2, unverified);
  EXPECT_THAT(Table(report), HasSubstr("Unverified: 2 claims or variants of worlds\n"
                                       "      2  mine: coulomb_cone: nothing\n"));
}

TEST(WriteTable, ShowsFaultsInTheCatalogue) {
  EXPECT_THAT(Table(HandMadeReport()), HasSubstr("the author expects \"apart\""));
}

TEST(WriteTable, WritesTheReasonsOfUnsupportedOutcomes) {
  EXPECT_THAT(Table(HandMadeReport()),
              HasSubstr("Unsupported\n      1  theirs/float: no cones \x01 here\n"));
}

TEST(WriteTable, SaysThatTheSubjectWasNotExaminedEvenIfReferencesFail) {
  RunReport report = HandMadeReport();
  std::erase_if(report.findings, [](const Finding& finding) {
    return finding.oracle == "mine" || finding.scenario != "contact/box_sphere/wrong";
  });
  report.scenarios = {report.scenarios[1]};
  report.scenarios[0].answers[0] = {};
  report.scenarios[0].answers[0].reason = "no spheres.";
  const std::string table = Table(report);
  EXPECT_THAT(table, HasSubstr("NOTHING VERIFIED: mine answered no scenario of 1; the "
                               "other oracles failed in 1 answer (theirs/float)"));
  EXPECT_THAT(table, HasSubstr("mine was not examined: unsupported: no spheres; "));
}

TEST(WriteTable, CountsMotionsThatFollowAnotherLegalModel) {
  RunReport report = HandMadeReport();
  EXPECT_THAT(Table(report), Not(HasSubstr("Recognised")));
  report.findings[0].reference = "law";
  report.findings[0].cause = Cause::kModel;
  report.findings[0].cause_because = "L∞ friction cone";
  EXPECT_THAT(Table(report), HasSubstr("      1  mine: L∞ friction cone\n"));
}

TEST(WriteTable, ShowsTheOnlyGroupOnce) {
  RunReport report = HandMadeReport();
  EXPECT_THAT(Table(report), HasSubstr("all scenarios (3)"));
  report.scenarios.pop_back();
  std::erase_if(report.findings, [](const Finding& finding) {
    return finding.scenario == "contact/cone_cone/grazing";
  });
  EXPECT_THAT(Table(report), Not(HasSubstr("all scenarios")));
  EXPECT_THAT(Table(report), HasSubstr("contact/box_sphere (2)"));
}

TEST(WriteTable, IsPlainWithoutColours) {
  EXPECT_THAT(Table(HandMadeReport()), Not(HasSubstr("\x1b")));
  EXPECT_THAT(Table(HandMadeReport(), {.colours = true}), HasSubstr("\x1b["));
}

TEST(WriteTable, KeepsFailuresWhenQuiet) {
  const std::string table = Table(HandMadeReport(), {.quiet = true});
  EXPECT_THAT(table, HasSubstr("leaves 0.01 of overlap"));
  EXPECT_THAT(table, Not(HasSubstr("unsupported worst/tol")));
}

TEST(WriteTable, KeepsOnlyTheFailuresThatCountWhenQuiet) {
  const std::string proof_of_theirs = "theirs/float: invalid.";
  const auto table = [](bool quiet, FailOn whose) {
    return Table(HandMadeReport(), {.quiet = quiet, .rule = {.whose = whose}});
  };
  EXPECT_THAT(table(true, FailOn::kFaults), HasSubstr(proof_of_theirs));
  EXPECT_THAT(table(true, FailOn::kAnything), HasSubstr(proof_of_theirs));
  EXPECT_THAT(table(false, FailOn::kSubject), HasSubstr(proof_of_theirs));
  EXPECT_THAT(table(true, FailOn::kSubject),
              AllOf(Not(HasSubstr(proof_of_theirs)), HasSubstr("leaves 0.01 of overlap"),
                    HasSubstr("the other oracles failed in 1 answer, and in 1 that the "
                              "ledger knows (theirs/float)")));
}

TEST(WriteTable, SaysOkOnlyWithoutFailuresAndFaults) {
  RunReport report = HandMadeReport();
  EXPECT_THAT(Table(report),
              HasSubstr("FAILED: mine failed in 1 scenario (it answers all 3 scenarios); "
                        "the other oracles "
                        "failed in 1 answer, and in 1 that the ledger knows "
                        "(theirs/float); 1 fault in the scenario files"));
  for (Finding& finding : report.findings) finding.verdict = Verdict::kPass;
  EXPECT_THAT(Table(report), HasSubstr("FAILED"));
  report.faults.clear();
  EXPECT_THAT(
      Table(report),
      HasSubstr(
          "OK: mine never failed (it answers all 3 scenarios); the other oracles never "
          "failed\n"));
}

TEST(WriteTable, NamesTheOtherOraclesFirstWhereTheyAloneFailed) {
  RunReport report = HandMadeReport();
  report.faults.clear();
  for (Finding& finding : report.findings)
    if (finding.oracle == "mine") finding.verdict = Verdict::kPass;
  EXPECT_THAT(Table(report),
              HasSubstr("FAILED: the other oracles failed in 1 answer, and "
                        "in 1 that the ledger knows (theirs/float); mine "
                        "never failed (it answers all 3 scenarios)\n"));
}

TEST(WriteTable, TellsKnownFailuresFromNewOnesAtTheEnd) {
  RunReport report = HandMadeReport();
  report.faults.clear();
  std::erase_if(report.findings,
                [](const Finding& finding) { return IsFailure(finding.verdict); });
  EXPECT_THAT(
      Table(report),
      HasSubstr("the other oracles failed only in 1 answer that the ledger knows\n"));
}

TEST(WriteTable, WritesNoMultipleOfAZeroTolerance) {
  RunReport report = HandMadeReport();
  for (Finding& finding : report.findings) {
    if (finding.verdict == Verdict::kFail) finding.tolerance = 0;
  }
  const std::string table = Table(report);
  EXPECT_THAT(table, Not(HasSubstr("inf")));
  EXPECT_THAT(table, HasSubstr(" 0.01 > 0  separation_error"));
  EXPECT_THAT(table, HasSubstr("also: consistency_error 0.01 where 0 is allowed"));
}

}  // namespace
}  // namespace touchstone
