#include "reports/ledger/update_bounds.h"

#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reports/ledger/apply_ledger.h"
#include "tests/reports/ledger/report_of_failures.h"

namespace touchstone {
namespace {

using testing::IsEmpty;

/** Returns the updated bounds of a report to which its ledger has not been applied yet.
 */
UpdatedBounds Updated(RunReport& report) {
  ApplyLedger(report, "", true);
  return UpdateBounds(report);
}

TEST(UpdateBounds, BoundsEveryCoveredFailureAndNothingElse) {
  RunReport report = ReportOfFailures({0.0123, 0, 0.0456}, 1);
  report.ledger.bounds.clear();
  const UpdatedBounds updated = Updated(report);
  ASSERT_EQ(updated.bounds.size(), 2U);
  EXPECT_EQ(updated.bounds.at(CellOfFailure(0)).value, 0.019);
  EXPECT_EQ(updated.bounds.at(CellOfFailure(2)).value, 0.069);
  EXPECT_EQ(updated.added, 2);
  report.ledger.bounds = updated.bounds;
  ApplyLedger(report, "", false);
  EXPECT_THAT(report.faults, IsEmpty());
}

TEST(UpdateBounds, LeavesFailuresWithoutAnEntryAlone) {
  RunReport report = ReportOfFailures({0.01, 0.01}, 1);
  report.ledger.bounds.clear();
  report.ledger.entries[0].scenarios = {"contact/box_box/0"};
  const UpdatedBounds updated = Updated(report);
  EXPECT_EQ(updated.bounds.size(), 1U);
  EXPECT_EQ(updated.uncovered, 1);
}

// A value of another machine changes nothing as long as the bound guards it.
TEST(UpdateBounds, KeepsABoundThatHoldsAndIsNotImproved) {
  for (const double value : {0.05, 0.02, 0.05 / 11.9}) {
    RunReport report = ReportOfFailures({value}, 0.05);
    const UpdatedBounds updated = Updated(report);
    EXPECT_EQ(updated.bounds.at(CellOfFailure(0)).value, 0.05);
    EXPECT_EQ(updated.changed, 0);
  }
  RunReport passing = ReportOfFailures({0.02}, 0.05);
  passing.findings[0].verdict = Verdict::kPass;
  EXPECT_EQ(Updated(passing).bounds.size(), 1U);
}

TEST(UpdateBounds, RenewsABoundThatIsExceededOrTooWide) {
  for (const double value : {0.08, 0.05 / 12.1}) {
    RunReport report = ReportOfFailures({value}, 0.05);
    const UpdatedBounds updated = Updated(report);
    EXPECT_EQ(updated.bounds.at(CellOfFailure(0)).value, RoundedUp(1.5 * value));
    EXPECT_EQ(updated.changed, 1);
  }
}

TEST(UpdateBounds, RemovesABoundThatHidesNothing) {
  RunReport report = ReportOfFailures({0.04, 0}, 0.05);
  const UpdatedBounds updated = Updated(report);
  EXPECT_EQ(updated.bounds.size(), 1U);
  EXPECT_EQ(updated.removed, 1);
}

TEST(UpdateBounds, KeepsWhatTheRunDidNotTest) {
  RunReport report = ReportOfFailures({0.04, 0}, 0.05);
  LedgerCell other = CellOfFailure(0);
  other.oracle = "fcl/collide";
  report.ledger.bounds[other] = {Verdict::kFail, 0.05, 9};
  report.ledger.bounds[CellOfFailure(7)] = {Verdict::kFail, 0.05, 9};
  EXPECT_EQ(Updated(report).bounds.size(), 3U);
  report = ReportOfFailures({0.04, 0}, 0.05);
  report.ledger.entries[0].intermittent = true;
  EXPECT_EQ(Updated(report).bounds.size(), 2U);
  report = ReportOfFailures({0.08, 0}, 0.05);
  report.oracles[0].version = "another";
  EXPECT_EQ(Updated(report).bounds.at(CellOfFailure(0)).value, 0.05);
}

TEST(UpdateBounds, NeverBoundsAnInfiniteValue) {
  for (const double value : {std::numeric_limits<double>::infinity(), std::nan("")}) {
    RunReport report = ReportOfFailures({0.04}, 0.05);
    report.ledger.bounds.clear();
    report.findings[0].value = value;
    EXPECT_THAT(Updated(report).bounds, IsEmpty());
  }
}

TEST(UpdateBounds, NamesTheVerdictWithoutAValue) {
  RunReport report = ReportOfFailures({1}, 0.05);
  report.ledger.bounds.clear();
  report.findings[0].verdict = Verdict::kCrashed;
  report.ledger.entries[0].verdict = Verdict::kCrashed;
  EXPECT_EQ(Updated(report).bounds.at(CellOfFailure(0)).verdict, Verdict::kCrashed);
}

TEST(UpdateBounds, NamesTheWorstVerdictOfACell) {
  for (const bool last : {false, true}) {
    RunReport report = ReportOfFailures({0.01, 0.01}, 0.05);
    report.ledger.bounds.clear();
    report.findings[1].scenario = report.findings[0].scenario;
    report.findings[last ? 1 : 0].verdict = Verdict::kInvalid;
    LedgerEntry invalid = report.ledger.entries[0];
    invalid.verdict = Verdict::kInvalid;
    report.ledger.entries.push_back(invalid);
    EXPECT_EQ(Updated(report).bounds.at(CellOfFailure(0)).verdict, Verdict::kInvalid)
        << last;
  }
}

TEST(ProposedBound, IsAWholeNumberForACountAndAtMostOneForAShare) {
  EXPECT_EQ(ProposedBound(MeasureKind::kContactCount, 3), 3);
  EXPECT_EQ(ProposedBound(MeasureKind::kPatchCoverage, 0.9), 1);
  EXPECT_EQ(ProposedBound(MeasureKind::kExcess, 0.9), 1.4);
  EXPECT_EQ(ProposedBound(MeasureKind::kTouching, 0), 0);
}

TEST(RoundedUp, IsNeverBelowAndAtMostATenthAbove) {
  EXPECT_EQ(RoundedUp(0), 0);
  for (const double value : {1e-300, 3.14159e-16, 0.01, 0.0101, 7.77, 99.5, 123456.0}) {
    EXPECT_GE(RoundedUp(value), value * (1 - 0x1p-50));
    EXPECT_LE(RoundedUp(value), value * 1.1 * (1 + 0x1p-50));
  }
}

}  // namespace
}  // namespace touchstone
