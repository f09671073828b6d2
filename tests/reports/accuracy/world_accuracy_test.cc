#include "reports/accuracy/world_accuracy.h"

#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reports/accuracy/accuracy.h"

namespace touchstone {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

Finding Found(std::string oracle, MeasureKind measure, double value) {
  Finding finding{};
  finding.scenario = "world/free/stone";
  finding.oracle = std::move(oracle);
  finding.reference = "law";
  finding.measure = measure;
  finding.value = value;
  finding.tolerance = 1;
  return finding;
}

/** Returns a report of two simulators and one oracle that answers contact queries only.
 The first has position errors of `a` [m], in two claims, and of `b` [m]. The second was
 judged only by its energy. */
RunReport ReportOf(double a, double b) {
  RunReport report;
  for (const char* name : {"cookbook", "ode", "fcl"}) {
    OracleInfo& info = report.oracles.emplace_back();
    info.name = name;
    info.version = "1.0";
    info.simulates = info.name != "fcl";
  }
  report.worlds.emplace_back().scenario.id = "world/free/stone";
  report.findings = {Found("cookbook", MeasureKind::kPositionError, a),
                     Found("cookbook", MeasureKind::kPositionError, b),
                     Found("ode", MeasureKind::kEnergyDrift, 3e-3)};
  return report;
}

TEST(WorldAccuracyTable, ReturnsTheWorstOfEachWorldAndMeasure) {
  // 1.5 * 2.01e-3 = 3.015e-3, rounded up.
  EXPECT_THAT(WorldAccuracyTable(ReportOf(1e-3, 2.01e-3)),
              HasSubstr("| world | measure | cookbook | ode |\n"
                        "|---|---|---|---|\n"
                        "| world/free/stone | position_error [m] | 3.1e-03 | - |\n"
                        "| world/free/stone | energy_drift [J] | - | 4.5e-03 |\n"));
}

TEST(WorldAccuracyTable, LeavesOutMeasuresNotComparedWithTheTruth) {
  RunReport report = ReportOf(1e-3, 2e-3);
  report.findings.push_back(Found("ode", MeasureKind::kObservedOrder, 1));
  report.findings.push_back(Found("ode", MeasureKind::kPositionError, 7));
  report.findings.back().reference = "cookbook";
  EXPECT_EQ(WorldAccuracyTable(report), WorldAccuracyTable(ReportOf(1e-3, 2e-3)));
  report.worlds.clear();
  EXPECT_EQ(WorldAccuracyTable(report), "");
}

TEST(WorldAccuracyTable, CountsRowsWithoutASmallerError) {
  RunReport report = ReportOf(0.3, 0.2);
  const Finding near = Found("ode", MeasureKind::kPositionError, 0.3 - 0.9 * kAlike);
  report.findings.push_back(near);
  EXPECT_THAT(WorldAccuracyTable(report), HasSubstr("| cookbook | 1.0 | 1 | 1 |\n"
                                                    "| ode | 1.0 | 2 | 2 |\n"));
  EXPECT_THAT(WorldAccuracyTable(report), Not(HasSubstr("smaller error than")));
  report.findings.back().value = 0.3 - 1.1 * kAlike;
  EXPECT_THAT(
      WorldAccuracyTable(report),
      HasSubstr("| cookbook | 1.0 | 1 | 0 |\n"
                "| ode | 1.0 | 2 | 2 |\n\n"
                "In these rows another oracle has a smaller error than cookbook:\n\n"
                "- world/free/stone, position_error [m]: 4.5e-01, and 4.4e-01 by "
                "ode\n"));
}

TEST(WorldAccuracyTable, CountsNoErrorOfAMotionThatFollowsAnotherLegalModel) {
  for (const std::size_t who : {0U, 1U}) {
    RunReport report = ReportOf(0.3, 0.3);
    report.findings[1] = Found("ode", MeasureKind::kPositionError, 0.1);
    report.findings[who].cause = Cause::kModel;
    const std::string table = WorldAccuracyTable(report);
    EXPECT_THAT(table, HasSubstr(who == 0 ? "| cookbook | 1.0 | 0 | 0 |\n"
                                            "| ode | 1.0 | 2 | 2 |\n"
                                          : "| cookbook | 1.0 | 1 | 1 |\n"
                                            "| ode | 1.0 | 1 | 1 |\n"));
    EXPECT_THAT(table, HasSubstr("| 4.5e-01 | 1.6e-01 |"));
    // Not a legal model: only the cause is known.
    report.findings[who].verdict = Verdict::kFail;
    EXPECT_THAT(WorldAccuracyTable(report), HasSubstr("| cookbook | 1.0 | 1 | 0 |\n"
                                                      "| ode | 1.0 | 2 | 2 |\n"));
  }
}

TEST(CheckWorldAccuracy, AcceptsTheTableOfTheSameRun) {
  const RunReport report = ReportOf(1e-3, 2e-3);
  EXPECT_THAT(CheckAccuracy(report, AccuracyTable(report)), IsEmpty());
}

constexpr std::string_view kTable =
    "## Worlds\n"
    "| world | measure | ode | cookbook |\n"
    "|---|---|---|---|\n"
    "| world/free/stone | position_error [m] | - | 1.2e-03 |\n"
    "| world/free/stone | energy_drift [J] | 4.5e-03 | - |\n";

TEST(CheckWorldAccuracy, FailsAnErrorAboveItsCellOrBelowATwelfthOfIt) {
  EXPECT_THAT(CheckAccuracy(ReportOf(1.1e-3, 0), kTable), IsEmpty());
  EXPECT_THAT(CheckAccuracy(ReportOf(1.3e-3, 0), kTable),
              ElementsAre("cookbook in world/free/stone: position_error: measured "
                          "1.30e-03, above the published 1.2e-03"));
  EXPECT_THAT(CheckAccuracy(ReportOf(0.9e-4, 0), kTable),
              ElementsAre("cookbook in world/free/stone: position_error: improved to "
                          "9.00e-05: lower the published 1.2e-03"));
}

TEST(CheckWorldAccuracy, FailsWhatIsMissingFromTheTableOrFromTheRun) {
  EXPECT_THAT(CheckWorldAccuracy(ReportOf(1e-3, 0), ""),
              ElementsAre("cookbook in world/free/stone: position_error: is not in the "
                          "table: add it",
                          "ode in world/free/stone: energy_drift: is not in the table: "
                          "add it"));
  RunReport report = ReportOf(1e-3, 0);
  report.findings.push_back(Found("cookbook", MeasureKind::kEnergyDrift, 1e-3));
  report.findings.erase(report.findings.begin() + 2);
  EXPECT_THAT(CheckWorldAccuracy(report, kTable),
              ElementsAre("cookbook in world/free/stone: energy_drift: measured "
                          "1.00e-03, but the table says -",
                          "ode in world/free/stone: energy_drift: the table says "
                          "4.5e-03, but it is \"-\""));
  report.oracles.erase(report.oracles.begin(), report.oracles.begin() + 2);
  EXPECT_THAT(CheckWorldAccuracy(report, kTable), IsEmpty());
}

}  // namespace
}  // namespace touchstone
