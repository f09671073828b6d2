#include "reports/baseline/baseline.h"

#include <cmath>
#include <sstream>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reports/writers/json_writer.h"
#include "tests/reports/ledger/report_of_failures.h"

namespace touchstone {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/** Returns a report of three scenarios in which `excess` is 0.04 of the scene's size. */
RunReport Report() {
  RunReport report = ReportOfFailures({0.04, 0.04, 0.04}, 0.05);
  for (ScenarioResult& result : report.scenarios) result.answers.resize(1);
  report.ledger_use.resize(1);
  report.ledger_use[0].hidden.resize(1);
  return report;
}

Baseline BaselineOf(const RunReport& report) {
  std::ostringstream text;
  WriteJson(report, text);
  return ReadBaseline(text.str(), "report.jsonl").baseline.value();
}

/** Returns what got worse from one report to another. */
std::vector<std::string> Worse(const RunReport& before, RunReport after) {
  CompareWithBaseline(after, BaselineOf(before));
  std::vector<std::string> worse;
  for (const Regression& regression : after.regressions) worse.push_back(regression.what);
  return worse;
}

TEST(Baseline, IsReadFromTheReportThatARunWrites) {
  RunReport report = Report();
  report.findings[1].value = std::nan("");
  report.findings[2].law = "rolls";
  const Baseline baseline = BaselineOf(report);
  ASSERT_EQ(baseline.cells.size(), 3U);
  EXPECT_EQ(baseline.cells.at(CellOfFailure(0)).value, report.findings[0].value);
  EXPECT_EQ(baseline.cells.at(CellOfFailure(0)).verdict, Verdict::kFail);
  EXPECT_TRUE(std::isnan(baseline.cells.at(CellOfFailure(1)).value));
  LedgerCell of_law = CellOfFailure(2);
  of_law.law = "rolls";
  EXPECT_TRUE(baseline.cells.contains(of_law));
}

TEST(Baseline, KeepsTheWorstOfSeveralFindingsOfACell) {
  RunReport report = Report();
  for (Finding& finding : report.findings) finding.scenario = report.findings[0].scenario;
  report.findings[1].verdict = Verdict::kUndecidable;
  report.findings[1].value = std::nan("");
  report.findings[2].verdict = Verdict::kPass;
  const Baseline baseline = BaselineOf(report);
  ASSERT_EQ(baseline.cells.size(), 1U);
  EXPECT_EQ(baseline.cells.begin()->second.verdict, Verdict::kFail);
  EXPECT_TRUE(std::isnan(baseline.cells.begin()->second.value));
}

TEST(Baseline, RefusesWhatIsNoReport) {
  const std::string head =
      R"({"kind": "run", "format": "touchstone report", "version": )";
  for (const std::string& text :
       {std::string(), std::string("{"), std::string("[]"), std::string("3"), head + "1}",
        head + "2}\n[3]", head + "2}\n{\"kind\": \"finding\"}",
        head + "2}\n{\"kind\": \"finding\", \"measure\": \"excess\", "
               "\"verdict\": \"good\", \"value\": 1}"}) {
    const BaselineResult result = ReadBaseline(text, "r.jsonl");
    EXPECT_FALSE(result.baseline) << text;
    EXPECT_EQ(result.diagnostics.size(), 1U) << text;
  }
  EXPECT_EQ(ToString(ReadBaseline(head + "2}\n  x", "r.jsonl").diagnostics.at(0)),
            "r.jsonl:2:3: is not JSON; expected a report.jsonl of `touchstone run --out "
            "DIR`");
  EXPECT_FALSE(ReadBaselineFile("nowhere.jsonl").baseline);
}

TEST(Compare, TellsWorseNoLongerJudgedNewGoneAndBetterApart) {
  const auto cell = [](const char* oracle) {
    return LedgerCell{"s", oracle, MeasureKind::kExcess, ""};
  };
  const Baseline before{{{cell("a"), {1e-3, Verdict::kFail, 1e-9}},
                         {cell("b"), {1e-3, Verdict::kKnown, 1e-9}},
                         {cell("c"), {0, Verdict::kPass, 1e-9}},
                         {cell("d"), {1e-12, Verdict::kPass, 1e-9}},
                         {cell("gone"), {1, Verdict::kFail, 1e-9}},
                         {cell("gone and right"), {0, Verdict::kPass, 1e-9}},
                         {cell("gone undecided"), {0, Verdict::kUndecidable, 1e-9}},
                         {cell("silent"), {0, Verdict::kPass, 1e-9}},
                         {cell("silent and known"), {1, Verdict::kKnown, 1e-9}}}};
  const Baseline after{{{cell("a"), {2.1e-3, Verdict::kFail, 1e-9}},
                        {cell("b"), {0.4e-3, Verdict::kKnown, 1e-9}},
                        {cell("c"), {0, Verdict::kUndecidable, 1e-9}},
                        {cell("d"), {1e-9, Verdict::kPass, 1e-9}},
                        {cell("silent"), {0, Verdict::kUnsupported, 1e-9}},
                        {cell("silent and known"), {0, Verdict::kUnsupported, 1e-9}},
                        {cell("new"), {1, Verdict::kCrashed, 1e-9}},
                        {cell("new and right"), {0, Verdict::kPass, 1e-9}}}};
  std::vector<std::string> told;
  for (const Change& change : Compare(before, after))
    told.push_back(
        fmt::format("{} {}: {}", NameOf(change.kind), change.cell.oracle, change.what));
  EXPECT_THAT(told,
              ElementsAre("worse a: was 0.001, is 0.0021 m",
                          "worse silent and known: was known, is unsupported",
                          "no longer judged c: was pass, is undecidable",
                          "no longer judged silent: was pass, is unsupported",
                          "no longer judged gone and right: was pass, is not measured",
                          "new new: is crashed, 1 m", "gone gone: was fail, 1 m",
                          "better b: was 0.001, is 0.0004 m"));
}

// A regression from one version of an engine to the next, in one run that asks both.
TEST(Compare, TellsTwoOraclesOfOneRunApart) {
  const auto cell = [](const char* scenario, const char* oracle) {
    return LedgerCell{scenario, oracle, MeasureKind::kExcess, ""};
  };
  const Baseline run{{{cell("s", "engine"), {0, Verdict::kPass, 1e-9}},
                      {cell("s", "engine@2"), {1e-3, Verdict::kFail, 1e-9}},
                      {cell("t", "engine"), {1e-3, Verdict::kKnown, 1e-9}},
                      {cell("t", "engine@2"), {1e-3, Verdict::kFail, 1e-9}},
                      {cell("s", "other"), {1, Verdict::kFail, 1e-9}}}};
  const std::vector<Change> changes = Compare(FindingsOf(run, "engine", "engine@2"),
                                              FindingsOf(run, "engine@2", "engine@2"));
  ASSERT_EQ(changes.size(), 1U);
  EXPECT_EQ(changes[0].what, "was pass, is fail");
  EXPECT_EQ(changes[0].cell, cell("s", "engine@2"));
}

TEST(CompareWithBaseline, FindsNothingInTheSameRun) {
  EXPECT_THAT(Worse(Report(), Report()), IsEmpty());
}

TEST(CompareWithBaseline, NamesAValueThatMoreThanDoubled) {
  RunReport after = Report();
  after.findings[0].value *= 1.99;
  after.findings[1].value *= 2.01;
  const double old = Report().findings[1].value;
  EXPECT_THAT(
      Worse(Report(), after),
      ElementsAre(fmt::format("contact/box_box/1: ode excess: was {:.3g}, is {:.3g} m",
                              old, 2.01 * old)));
  after = Report();
  after.findings[2].value = std::nan("");
  EXPECT_THAT(Worse(Report(), after), testing::SizeIs(1));
}

// An answer that was right to the last digit may be two digits off today.
TEST(CompareWithBaseline, LeavesRoundingAlone) {
  RunReport before = Report();
  RunReport after = Report();
  for (std::size_t i = 0; i < 3; ++i) {
    before.findings[i].value = 1e-20;
    before.findings[i].verdict = after.findings[i].verdict = Verdict::kPass;
    before.oracles[0].unit_roundoff = after.oracles[0].unit_roundoff = 0x1p-53;
  }
  after.findings[0].value = 1e-16;
  after.findings[1].value = 1e-11;  // Passes, but no rounding causes it.
  after.findings[2].value = 1e-11;
  after.findings[2].tolerance = 1e-8;  // Less than 1 % of it.
  EXPECT_THAT(Worse(before, after),
              ElementsAre(testing::StartsWith("contact/box_box/1: ")));
}

TEST(CompareWithBaseline, NamesAWorseVerdict) {
  RunReport before = Report();
  RunReport after = Report();
  before.findings[0].verdict = Verdict::kPass;
  after.findings[0].verdict = Verdict::kKnown;  // The ledger was lenient.
  before.findings[1].verdict = Verdict::kFail;
  after.findings[1].verdict = Verdict::kKnown;
  after.findings[2].verdict = Verdict::kCrashed;
  EXPECT_THAT(Worse(before, after),
              ElementsAre("contact/box_box/0: ode excess: was pass, is known",
                          "contact/box_box/2: ode excess: was fail, is crashed"));
  std::swap(before, after);
  EXPECT_THAT(Worse(before, after), IsEmpty());
}

TEST(CompareWithBaseline, LeavesOutWhatOnlyOneRunHas) {
  RunReport before = Report();
  RunReport after = Report();
  before.findings.erase(before.findings.begin());
  after.findings.pop_back();
  EXPECT_THAT(Worse(before, after), IsEmpty());
}

TEST(ExitCode, FailsForARegressionOfTheSubjectAndOfAReferenceWhereItCounts) {
  RunReport report;
  report.subject = "mine";
  Finding finding{};
  finding.oracle = "mine";
  finding.reference = "referee";
  finding.measure = MeasureKind::kExcess;
  report.findings = {finding};
  EXPECT_EQ(ExitCode(report, {.whose = FailOn::kAnything}), 0);
  report.regressions = {{"ode", "worse"}};
  EXPECT_EQ(ExitCode(report, {.whose = FailOn::kAnything}), 1);
  EXPECT_EQ(ExitCode(report, {.whose = FailOn::kSubject}), 0);
  report.regressions = {{"mine", "worse"}};
  EXPECT_EQ(ExitCode(report, {.whose = FailOn::kSubject}), 1);
}

}  // namespace
}  // namespace touchstone
