#include "reports/ledger/audit_ledger.h"

#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reports/ledger/apply_ledger.h"
#include "reports/ledger/rewrite_causes.h"
#include "tests/reports/ledger/report_of_failures.h"

namespace touchstone {
namespace {

using testing::HasSubstr;

LedgerAudit AuditOf(RunReport& report) {
  ApplyLedger(report, "", true);
  return AuditLedger(report);
}

std::string TextOf(const RunReport& report) {
  std::ostringstream text;
  WriteAudit(report, AuditLedger(report), text);
  return text.str();
}

// Two cells pass; a bound of 0.05 would excuse an error of 0.001 in one of them.
TEST(AuditLedger, CountsThePassingCellsInWhichAnErrorWouldBeExcused) {
  RunReport report = ReportOfFailures({0.04, 0, 0}, 0.05);
  report.ledger.bounds.erase(CellOfFailure(1));
  LedgerAudit audit = AuditOf(report);
  EXPECT_EQ(audit.hidden, 1);
  EXPECT_EQ(audit.passing, 2);
  EXPECT_EQ(audit.excusable, 1);
  EXPECT_EQ(audit.Seen(), 0.5);
  EXPECT_FALSE(IsInOrder(audit));
  EXPECT_THAT(TextOf(report), HasSubstr("seen in 50.00 % of 2 length findings"));

  report = ReportOfFailures({0.04, 0, 0}, 0.0009);
  EXPECT_EQ(AuditOf(report).Seen(), 1);
  // Without an entry a bound excuses nothing.
  report = ReportOfFailures({0, 0}, 0.05);
  report.ledger.entries[0].scenarios = {"contact/box_box/0"};
  EXPECT_EQ(AuditOf(report).excusable, 1);
}

TEST(AuditLedger, LeavesOutTheSubjectAndMeasuresThatAreNoLength) {
  RunReport report = ReportOfFailures({0}, 0.05);
  report.subject = "ode";
  EXPECT_EQ(AuditOf(report).passing, 0);
  report = ReportOfFailures({0}, 0.05);
  report.findings[0].measure = MeasureKind::kPatchCoverage;
  EXPECT_EQ(AuditOf(report).passing, 0);
}

TEST(AuditLedger, CountsTolerancesThatAllowTheErrorApart) {
  RunReport report = ReportOfFailures({0}, 0.0009);
  report.findings[0].tolerance = 1;
  const LedgerAudit audit = AuditOf(report);
  EXPECT_EQ(audit.tolerated, 1);
  EXPECT_EQ(audit.Seen(), 1);
}

TEST(AuditLedger, FindsCausesThatContradictTheirFindings) {
  RunReport report = ReportOfFailures({0.04, 0.04, 0.04}, 0.05);
  report.ledger.entries[0].causes = {Cause::kDefect};
  report.findings[0].cause = Cause::kPrecision;
  report.findings[1].cause = Cause::kDefect;
  const LedgerAudit audit = AuditOf(report);
  ASSERT_EQ(audit.contradictions.size(), 1U);
  EXPECT_EQ(audit.contradictions[0].cause, Cause::kPrecision);
  EXPECT_EQ(audit.contradictions[0].findings, 1);
  EXPECT_FALSE(IsInOrder(audit));
  EXPECT_THAT(TextOf(report),
              HasSubstr("known_discrepancies.toml:17: says defect, but 1 is precision "
                        "(ode in contact/box_box/*)"));
  report = ReportOfFailures({0.04, 0.04}, 0.05);
  report.ledger.entries[0].causes = {Cause::kPrecision, Cause::kDefect};
  report.findings[0].cause = Cause::kDefect;
  EXPECT_FALSE(IsInOrder(AuditOf(report)));
  EXPECT_THAT(TextOf(report), HasSubstr("says precision, defect, but none is precision"));
  EXPECT_TRUE(IsInOrder(AuditLedger(report, true)));
  report = ReportOfFailures({0.04, 0.04}, 0.05);
  report.ledger.entries[0].causes = {Cause::kPrecision, Cause::kDefect};
  report.findings[0].cause = Cause::kDefect;
  report.findings[1].cause = Cause::kPrecision;
  EXPECT_TRUE(IsInOrder(AuditOf(report)));
}

TEST(FaultsOfAnAudit, AreSentencesWithPlaceAndNumbers) {
  RunReport report = ReportOfFailures({0.04, 0, 0}, 0.05);
  report.ledger.bounds.erase(CellOfFailure(1));
  report.ledger.entries[0].causes = {Cause::kDefect};
  report.findings[0].cause = Cause::kPrecision;
  const LedgerAudit audit = AuditOf(report);
  EXPECT_THAT(
      FaultsOf(report, audit),
      testing::ElementsAre("known_discrepancies.toml: would excuse an error of 0.001 of "
                           "the scene in 1 of 2 passing cells; expected at most 0.5 %",
                           HasSubstr(":17: says defect, but 1 is precision"),
                           HasSubstr(":17: says defect, but none is defect")));
  EXPECT_FALSE(IsInOrder(audit));
  report = ReportOfFailures({0.04, 0}, 0.0009);
  EXPECT_THAT(FaultsOf(report, AuditOf(report)), testing::IsEmpty());
}

TEST(RewriteCauses, WritesTheCausesOfTheFindingsOverTheLineOfTheEntry) {
  const std::string before =
      "[[entry]]\nreason = \"A\"\ncause = \"defect\"\n\n[[entry]]\n"
      "cause = [\"tie\", \"defect\"]  # why\nreason = \"B\"\n";
  RunReport report = ReportOfFailures({0.04, 0.04}, 0.05);
  report.ledger.entries.push_back(report.ledger.entries[0]);
  report.ledger.entries[0].line = 1;
  report.ledger.entries[0].causes = {Cause::kDefect};
  report.ledger.entries[0].scenarios = {"nowhere"};
  report.ledger.entries[1].line = 5;
  report.ledger.entries[1].causes = {Cause::kTie, Cause::kDefect};
  report.findings[0].cause = Cause::kDefect;
  report.findings[1].cause = Cause::kPrecision;
  ApplyLedger(report, "", true);
  EXPECT_EQ(RewriteCauses(before, report),
            "[[entry]]\nreason = \"A\"\ncause = \"defect\"\n\n[[entry]]\n"
            "cause = [\"precision\", \"defect\"]\nreason = \"B\"\n");
  report.ledger.entries[1].causes = {Cause::kPrecision, Cause::kDefect};
  EXPECT_EQ(RewriteCauses(before, report), before);
}

TEST(AuditLedger, ListsBoundsAboveATenthOfTheScene) {
  RunReport report = ReportOfFailures({0.04, 0.4, 0.2}, 0.05);
  report.ledger.bounds[CellOfFailure(1)].value = 0.6;
  report.ledger.bounds[CellOfFailure(2)].value = 0.3;
  const LedgerAudit audit = AuditOf(report);
  ASSERT_EQ(audit.large.size(), 2U);
  EXPECT_EQ(audit.large[0].bound, 0.6);
  EXPECT_THAT(TextOf(report),
              HasSubstr("2 bounds above 10 % of the scene\n      2  ode excess, the "
                        "largest 0.6 in contact/box_box/1\n"));
}

TEST(WriteAudit, NamesTheFirstDateOfExpiryAndWhatEachEntryHides) {
  RunReport report = ReportOfFailures({0.04, 0.03}, 0.05);
  report.ledger.entries.push_back(report.ledger.entries[0]);
  report.ledger.entries[1].expires = "2025-01-01";
  ApplyLedger(report, "", true);
  EXPECT_THAT(
      TextOf(report),
      testing::AllOf(HasSubstr("2 entries with 2 bounds hide 2 findings; the first "
                               "expires on 2025-01-01\n"),
                     HasSubstr("      2  known_discrepancies.toml:17 ode fail in "
                               "contact/box_box/*\n")));
}

}  // namespace
}  // namespace touchstone
