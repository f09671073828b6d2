#include "reports/accuracy/accuracy.h"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reports/accuracy/audit_run.h"
#include "tests/reports/specimens.h"

namespace touchstone {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/** Returns a report of two sphere-box questions with the given separation errors,
 relative to the size of the scene. */
RunReport ReportOf(double first, double second) {
  RunReport report;
  OracleInfo info;
  info.name = "ode";
  info.version = "0.16.2";
  info.capabilities[0][0].supported = true;
  report.oracles = {info};
  ContactQuery query = SphereInBoxFace(1e-3).query;
  for (const double error : {first, second}) {
    ScenarioResult result;
    result.scenario.id = "contact/sphere_box/" + std::to_string(report.scenarios.size());
    result.scenario.contact = query;
    result.answers.resize(1);
    result.answers[0].status = AnswerStatus::kAnswered;
    Finding finding{};
    finding.scenario = result.scenario.id;
    finding.oracle = "ode";
    finding.measure = MeasureKind::kSeparationError;
    finding.value = error * SceneSize(query);
    report.scenarios.push_back(result);
    report.findings.push_back(finding);
    std::swap(query.A, query.B);
  }
  return report;
}

TEST(AccuracyTable, ReturnsTheWorstOfEachPairInEitherOrder) {
  // 1.5 * 2.01e-15 = 3.015e-15, rounded up.
  EXPECT_THAT(AccuracyTable(ReportOf(1e-15, 2.01e-15)),
              HasSubstr("| oracle | version | shapes | separation_error | excess | "
                        "contact_surface_error |\n"
                        "|---|---|---|---|---|---|\n"
                        "| ode | 0.16.2 | sphere, box | 3.1e-15 | - | - |\n"));
}

TEST(AccuracyTable, MarksUnsupportedPairs) {
  RunReport report = ReportOf(0, 0);
  report.findings.clear();
  for (ScenarioResult& result : report.scenarios) {
    result.answers[0].status = AnswerStatus::kUnsupported;
  }
  EXPECT_THAT(AccuracyTable(report),
              HasSubstr("| ode | 0.16.2 | sphere, box | unsupported | unsupported | "));
}

TEST(AccuracyTable, LeavesOutOraclesThatOnlySimulate) {
  RunReport report = ReportOf(0, 0);
  report.oracles.emplace_back().name = "ode/quick";
  for (ScenarioResult& result : report.scenarios) result.answers.emplace_back();
  EXPECT_THAT(AccuracyTable(report), testing::Not(HasSubstr("ode/quick")));
}

TEST(CheckAccuracy, AcceptsTheTableOfTheSameRun) {
  const RunReport report = ReportOf(1e-15, 2e-15);
  EXPECT_THAT(CheckAccuracy(report, AccuracyTable(report)), IsEmpty());
  const RunReport exact = ReportOf(0, 0);
  EXPECT_THAT(CheckAccuracy(exact, AccuracyTable(exact)), IsEmpty());
}

constexpr std::string_view kRow = "| ode | 0.16.2 | sphere, box | 1.2e-15 | - | - |\n";

TEST(CheckAccuracy, FailsAnErrorAboveItsRow) {
  EXPECT_THAT(
      CheckAccuracy(ReportOf(1.3e-15, 0), kRow),
      ElementsAre("ode on sphere, box: separation_error: measured 1.30e-15, above the "
                  "published 1.2e-15"));
  EXPECT_THAT(CheckAccuracy(ReportOf(1.1e-15, 0), kRow), IsEmpty());
}

TEST(CheckAccuracy, FailsAnErrorBelowATwelfthOfItsRow) {
  EXPECT_THAT(
      CheckAccuracy(ReportOf(0.9e-16, 0), kRow),
      ElementsAre("ode on sphere, box: separation_error: improved to 9.00e-17: lower "
                  "the published 1.2e-15"));
  EXPECT_THAT(CheckAccuracy(ReportOf(1.1e-16, 0), kRow), IsEmpty());
}

TEST(CheckAccuracy, FailsARowThatIsMissingOrSaysSomethingElse) {
  EXPECT_THAT(CheckAccuracy(ReportOf(1e-15, 0), ""),
              ElementsAre("ode on sphere, box: has no row: add it"));
  EXPECT_THAT(
      CheckAccuracy(ReportOf(1e-15, 0),
                    "| ode | 0.16.2 | sphere, box | unsupported | - | - |\n"),
      ElementsAre("ode on sphere, box: separation_error: measured 1.00e-15, but the "
                  "table says unsupported"));
  EXPECT_THAT(
      CheckAccuracy(ReportOf(1e-15, 0),
                    "| ode | 0.16.2 | sphere, box | 1.2e-15 | 1e-9 | - |\n"),
      ElementsAre("ode on sphere, box: excess: the table says 1e-9, but it is \"-\""));
}

TEST(AuditRun, FindsErrorsOffTheirTableAndFindingsWithoutTolerance) {
  RunReport report = ReportOf(1e-15, 2e-15);
  const std::string published = AccuracyTable(report);
  EXPECT_THAT(AuditRun(report, published), IsEmpty());
  report.findings[0].tolerance = std::numeric_limits<double>::quiet_NaN();
  report.findings[1].value *= 2;
  EXPECT_THAT(
      AuditRun(report, published),
      ElementsAre("contact/sphere_box/0: separation_error of ode has no tolerance",
                  HasSubstr("accuracy of ode on sphere, box: separation_error: ")));
}

}  // namespace
}  // namespace touchstone
