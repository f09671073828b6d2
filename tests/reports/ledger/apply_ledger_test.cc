#include "reports/ledger/apply_ledger.h"

#include <cmath>
#include <functional>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reports/ledger/ledger_file.h"
#include "tests/reports/specimens.h"

namespace touchstone {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/** Returns a report of failures with the given values, relative to the size of their
 scenes, one scenario each, and a ledger with one entry for them. */
RunReport ReportOf(std::initializer_list<double> values, double bound) {
  RunReport report;
  OracleInfo info;
  info.name = "ode";
  info.version = "0.16.2";
  report.oracles = {info};
  const ContactQuery query = SphereInBoxFace(1e-3).query;
  for (const double value : values) {
    ScenarioResult result;
    result.scenario.id = "contact/box_box/" + std::to_string(report.scenarios.size());
    result.scenario.contact = query;
    Finding finding{};
    finding.scenario = result.scenario.id;
    finding.oracle = "ode";
    finding.measure = MeasureKind::kExcess;
    finding.value = value * SceneSize(query);
    finding.verdict = value > 0 ? Verdict::kFail : Verdict::kPass;
    finding.proof = value > 0 ? "It is wrong." : "";
    report.scenarios.push_back(result);
    report.findings.push_back(finding);
  }
  LedgerEntry entry;
  entry.scenarios = "contact/box_box/*";
  entry.oracle = "ode";
  entry.version = "0.16.2";
  entry.accepted = {{MeasureKind::kExcess, bound}};
  entry.expires = "2026-06-30";
  entry.line = 17;
  report.ledger = {"scenarios/known_discrepancies.toml", {entry}, {}};
  return report;
}

TEST(ApplyLedger, LeavesScenariosOutsideTheCatalogueAlone) {
  RunReport report = ReportOf({0.01, 0.04}, 0.05);
  report.ledger.outside_catalogue = {"contact/box_box/0"};
  ApplyLedger(report, "2026-01-01", false);
  EXPECT_EQ(report.findings[0].verdict, Verdict::kFail);
  EXPECT_EQ(report.findings[1].verdict, Verdict::kKnown);
  EXPECT_EQ(report.ledger_use[0].candidates, 1);
}

TEST(ApplyLedger, MakesFailuresKnownAndCountsThem) {
  RunReport report = ReportOf({0.01, 0.04, 0}, 0.05);
  ApplyLedger(report, "2026-01-01", false);
  EXPECT_EQ(report.findings[0].verdict, Verdict::kKnown);
  EXPECT_EQ(report.findings[0].ledger_entry, 0);
  EXPECT_EQ(report.findings[1].verdict, Verdict::kKnown);
  EXPECT_EQ(report.findings[2].verdict, Verdict::kPass);
  ASSERT_EQ(report.ledger_use.size(), 1U);
  EXPECT_EQ(report.ledger_use[0].findings(), 2);
  EXPECT_DOUBLE_EQ(report.ledger_use[0].hidden[0].worst, 0.04);
  EXPECT_EQ(report.ledger_use[0].candidates, 3);
  EXPECT_THAT(report.faults, IsEmpty());
}

TEST(ApplyLedger, KeepsAFailureBeyondTheBoundAndSaysByHowMuch) {
  RunReport report = ReportOf({0.04, 0.08}, 0.05);
  ApplyLedger(report, "2026-01-01", false);
  EXPECT_EQ(report.findings[1].verdict, Verdict::kFail);
  EXPECT_EQ(
      report.findings[1].proof,
      "It is wrong. known_discrepancies.toml:17 allows 0.05; 0.08 exceeds it by 0.03.");
}

TEST(ApplyLedger, ExcusesAMissedHairlineContactButNotAMissedDeepOne) {
  const double size = SceneSize(SphereInBoxFace(1e-3).query);
  RunReport report = ReportOf({1, 1}, 1e-5 / size);
  report.ledger.entries[0].accepted[0].measure = MeasureKind::kTouching;
  report.scenarios[0].truth.separation = {-1e-5, -0.9e-5};
  report.scenarios[1].truth.separation = {-0.1, -0.1};
  for (Finding& finding : report.findings) {
    finding.measure = MeasureKind::kTouching;
    finding.value = 1;
  }
  ApplyLedger(report, "2026-01-01", false);
  EXPECT_EQ(report.findings[0].verdict, Verdict::kKnown);
  EXPECT_EQ(report.findings[1].verdict, Verdict::kFail);
  EXPECT_DOUBLE_EQ(report.ledger_use[0].hidden[0].worst, 1e-5 / size);
}

TEST(ApplyLedger, FailsAnEntryThatHidesNothing) {
  RunReport report = ReportOf({0, 0}, 0.05);
  ApplyLedger(report, "2026-01-01", false);
  EXPECT_THAT(
      report.faults,
      ElementsAre("known_discrepancies.toml:17: improved: remove this entry, it hides "
                  "nothing (ode in contact/box_box/*)."));
}

TEST(ApplyLedger, LetsAnIntermittentEntryHideNothing) {
  RunReport report = ReportOf({0, 0}, 0.05);
  report.ledger.entries[0].intermittent = true;
  ApplyLedger(report, "2026-01-01", false);
  EXPECT_THAT(report.faults, IsEmpty());
  report = ReportOf({0.04, 0.08}, 0.05);
  report.ledger.entries[0].intermittent = true;
  ApplyLedger(report, "2026-01-01", false);
  EXPECT_EQ(report.findings[0].verdict, Verdict::kKnown);
  EXPECT_EQ(report.findings[1].verdict, Verdict::kFail);
}

TEST(ApplyLedger, FailsABoundThatIsTwelveTimesTooWide) {
  RunReport report = ReportOf({0.05 / 12.1}, 0.05);
  ApplyLedger(report, "2026-01-01", false);
  ASSERT_EQ(report.faults.size(), 1U);
  EXPECT_THAT(report.faults[0], HasSubstr("improved: lower the bound 0.05 of excess"));
  report = ReportOf({0.05 / 11.9}, 0.05);
  ApplyLedger(report, "2026-01-01", false);
  EXPECT_THAT(report.faults, IsEmpty());
}

// The large bound of one measure must not excuse an error in another.
TEST(ApplyLedger, BoundsEachMeasureSeparately) {
  RunReport report = ReportOf({0.04, 0.04}, 0.05);
  report.ledger.entries[0].accepted.push_back({MeasureKind::kConsistencyError, 0.001});
  report.findings[1].measure = MeasureKind::kConsistencyError;
  ApplyLedger(report, "2026-01-01", true);
  EXPECT_EQ(report.findings[0].verdict, Verdict::kKnown);
  EXPECT_EQ(report.findings[1].verdict, Verdict::kFail);
  EXPECT_THAT(report.findings[1].proof, HasSubstr("allows 0.001"));
}

TEST(ApplyLedger, FailsAnEntryOneOfWhoseMeasuresHidesNothing) {
  RunReport report = ReportOf({0.04, 0}, 0.05);
  report.ledger.entries[0].accepted.push_back({MeasureKind::kConsistencyError, 0.001});
  report.findings[1].measure = MeasureKind::kConsistencyError;
  ApplyLedger(report, "2026-01-01", false);
  EXPECT_THAT(report.faults,
              ElementsAre("known_discrepancies.toml:17: improved: remove "
                          "consistency_error, the entry hides none of it (ode in "
                          "contact/box_box/*)."));
}

TEST(ApplyLedger, CallsNothingImprovedInAPartialRun) {
  RunReport report = ReportOf({0, 0}, 0.05);
  ApplyLedger(report, "2026-01-01", true);
  EXPECT_THAT(report.faults, IsEmpty());
}

TEST(ApplyLedger, FaultsAnEntryThatMatchesNothing) {
  RunReport report = ReportOf({0, 0}, 0.05);
  report.ledger.entries[0].scenarios = "contact/bxo_box/*";
  ApplyLedger(report, "2026-01-01", true);
  EXPECT_THAT(report.faults, IsEmpty());
  ApplyLedger(report, "2026-01-01", false);
  EXPECT_THAT(
      report.faults,
      ElementsAre("known_discrepancies.toml:17: matches no finding of the run: correct "
                  "or remove this entry (ode in contact/bxo_box/*)."));
}

TEST(ApplyLedger, FaultsAnEntryForAnOracleThatNoBuildHas) {
  const auto is_oracle = [](std::string_view name) { return name == "fcl/collide"; };
  RunReport report = ReportOf({0.04}, 0.05);
  report.ledger.entries[0].oracle = "fcl/collide";  // Not in this build.
  ApplyLedger(report, "2026-01-01", false, is_oracle);
  EXPECT_THAT(report.faults, IsEmpty());
  report.ledger.entries[0].oracle = "fcl/colide";
  ApplyLedger(report, "2026-01-01", true, is_oracle);
  EXPECT_THAT(report.faults, IsEmpty());
  ApplyLedger(report, "2026-01-01", false, is_oracle);
  EXPECT_THAT(report.faults,
              ElementsAre("known_discrepancies.toml:17: no build has an oracle "
                          "\"fcl/colide\": correct or remove this entry."));
}

TEST(ApplyLedger, FailsAnExpiredEntryThoughItStillExcuses) {
  RunReport report = ReportOf({0.04}, 0.05);
  ApplyLedger(report, "2026-07-01", false);
  EXPECT_EQ(report.findings[0].verdict, Verdict::kKnown);
  ASSERT_EQ(report.faults.size(), 1U);
  EXPECT_THAT(report.faults[0],
              HasSubstr("known_discrepancies.toml:17: expired on 2026-06-30"));
  // An entry that matches nothing expires too: otherwise nobody would review it.
  report = ReportOf({0.04}, 0.05);
  report.ledger.entries[0].scenarios = "contact/bxo_box/*";
  ApplyLedger(report, "2026-07-01", false);
  EXPECT_THAT(report.faults, testing::Contains(HasSubstr("expired on 2026-06-30")));
  report = ReportOf({0.04}, 0.05);
  ApplyLedger(report, "2026-06-30", false);
  EXPECT_THAT(report.faults, IsEmpty());
}

TEST(ApplyLedger, IsVoidForAnotherVersion) {
  RunReport report = ReportOf({0.04}, 0.05);
  report.oracles[0].version = "0.16.3";
  ApplyLedger(report, "2026-01-01", false);
  EXPECT_EQ(report.findings[0].verdict, Verdict::kFail);
  EXPECT_THAT(report.findings[0].proof, HasSubstr("is void: it is for version 0.16.2"));
  EXPECT_THAT(report.faults, IsEmpty());
}

TEST(ApplyLedger, ExcusesOnlyItsOwnOracleMeasureAndVerdict) {
  for (const auto& change : std::vector<std::function<void(LedgerEntry&)>>{
           [](LedgerEntry& e) { e.oracle = "ode/other"; },
           [](LedgerEntry& e) { e.accepted[0].measure = MeasureKind::kSeparationError; },
           [](LedgerEntry& e) { e.verdict = Verdict::kDisagree; }}) {
    RunReport report = ReportOf({0.04}, 0.05);
    change(report.ledger.entries[0]);
    ApplyLedger(report, "2026-01-01", true);
    EXPECT_EQ(report.findings[0].verdict, Verdict::kFail);
  }
}

TEST(ApplyLedger, NeverExcusesNan) {
  RunReport report = ReportOf({0.04}, 0.05);
  report.findings[0].value = std::nan("");
  ApplyLedger(report, "2026-01-01", true);
  EXPECT_EQ(report.findings[0].verdict, Verdict::kFail);
}

TEST(ProposeLedger, MakesOneEntryOfAFolderInWhichAllFail) {
  RunReport report = ReportOf({0.01, 0.04}, 0.05);
  report.ledger.entries.clear();
  EXPECT_EQ(ProposeLedger(report, "2026-06-30"),
            "# 2 scenarios; the worst: It is wrong.\n"
            "[[entry]]\n"
            "scenarios = \"contact/box_box/*\"\n"
            "oracle = \"ode\"\n"
            "version = \"0.16.2\"\n"
            "verdict = \"fail\"\n"
            "bounds = { excess = 0.06 }\n"
            "cause = \"defect\"\n"
            "reason = \"\"\n"
            "upstream = \"unreported\"\n"
            "expires = 2026-06-30\n");
}

TEST(ProposeLedger, NamesSingleScenariosWhereOthersPass) {
  const std::string text = ProposeLedger(ReportOf({0.01, 0, 0.04}, 0.05));
  EXPECT_THAT(text, HasSubstr("scenarios = \"contact/box_box/0\""));
  EXPECT_THAT(text, HasSubstr("scenarios = \"contact/box_box/2\""));
  EXPECT_THAT(text, testing::Not(HasSubstr("*")));
}

TEST(ProposeLedger, BoundsEveryMeasureInItsOwnUnit) {
  RunReport report = ReportOf({1, 2}, 0.05);
  report.ledger.entries.clear();
  report.findings[1].scenario = report.findings[0].scenario;
  report.findings[0].measure = MeasureKind::kTouching;
  report.findings[1].measure = MeasureKind::kContactCount;
  report.findings[1].value = 2;
  report.scenarios[0].truth.separation = {-0.1, -0.1};
  const double size = SceneSize(report.scenarios[0].scenario.contact);
  const double touching = RoundedUp(kProposedBound * 0.1 / size);
  EXPECT_THAT(ProposeLedger(report),
              HasSubstr(fmt::format(
                  "bounds = {{ touching = {:.6g}, contact_count = 3 }}\n", touching)));
}

TEST(ProposeLedger, ListsTheMeasuresOfVerdictsWithoutAValue) {
  RunReport report = ReportOf({1}, 0.05);
  report.ledger.entries.clear();
  report.findings[0].measure = MeasureKind::kAnswering;
  report.findings[0].verdict = Verdict::kCrashed;
  EXPECT_THAT(ProposeLedger(report),
              HasSubstr("verdict = \"crashed\"\nmeasures = [\"answering\"]\n"));
}

TEST(ProposeLedger, IsRefusedUntilAPersonGivesReasons) {
  const std::string text = ProposeLedger(ReportOf({0.01, 0, 0.04}, 0.05), "2026-06-30");
  const LedgerResult result = ReadLedger(text, "proposed.toml");
  ASSERT_EQ(result.diagnostics.size(), 2U);
  for (const Diagnostic& d : result.diagnostics) EXPECT_EQ(d.what, "reason is empty");
}

TEST(ProposeLedger, ExcusesItsOwnFailuresOnceReasonsAreGiven) {
  RunReport report = ReportOf({0.0123, 0, 0.0456}, 0.05);
  std::string text = ProposeLedger(report, "2026-06-30");
  for (auto at = text.find("reason = \"\""); at != std::string::npos;
       at = text.find("reason = \"\"")) {
    text.replace(at, 11, "reason = \"It is so.\"");
  }
  report.ledger = ReadLedger(text, "proposed.toml").ledger.value();
  ApplyLedger(report, "2026-01-01", false);
  EXPECT_THAT(report.faults, IsEmpty());
  for (const Finding& finding : report.findings)
    EXPECT_NE(finding.verdict, Verdict::kFail);
  EXPECT_EQ(ProposeLedger(report), "");
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
