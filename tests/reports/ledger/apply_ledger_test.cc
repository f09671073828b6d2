#include "reports/ledger/apply_ledger.h"

#include <cmath>
#include <functional>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reports/ledger/ledger_file.h"
#include "reports/ledger/update_bounds.h"
#include "tests/reports/ledger/report_of_failures.h"
#include "tests/reports/specimens.h"

namespace touchstone {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(ApplyLedger, LeavesScenariosOutsideTheCatalogueAlone) {
  RunReport report = ReportOfFailures({0.01, 0.04}, 0.05);
  report.ledger.outside_catalogue = {"contact/box_box/0"};
  ApplyLedger(report, "2026-01-01", false);
  EXPECT_EQ(report.findings[0].verdict, Verdict::kFail);
  EXPECT_EQ(report.findings[1].verdict, Verdict::kKnown);
  EXPECT_EQ(report.ledger_use[0].candidates, 1);
}

TEST(ApplyLedger, MakesFailuresKnownAndCountsThem) {
  RunReport report = ReportOfFailures({0.01, 0.04, 0}, 0.05);
  report.ledger.bounds.erase(CellOfFailure(2));
  ApplyLedger(report, "2026-01-01", false);
  EXPECT_EQ(report.findings[0].verdict, Verdict::kKnown);
  EXPECT_EQ(report.findings[0].ledger_entry, 0);
  EXPECT_EQ(report.findings[1].verdict, Verdict::kKnown);
  EXPECT_EQ(report.findings[2].verdict, Verdict::kPass);
  ASSERT_EQ(report.ledger_use.size(), 1U);
  EXPECT_EQ(report.ledger_use[0].findings(), 2);
  EXPECT_DOUBLE_EQ(report.ledger_use[0].hidden[0].worst, 0.04);
  EXPECT_EQ(report.ledger_use[0].hidden[0].bound, 0.05);
  EXPECT_EQ(report.ledger_use[0].causes.at(Cause::kNone), 2);
  EXPECT_EQ(report.ledger_use[0].candidates, 3);
  EXPECT_THAT(report.faults, IsEmpty());
}

TEST(ApplyLedger, KeepsAFailureBeyondTheBoundAndSaysByHowMuch) {
  RunReport report = ReportOfFailures({0.04, 0.08}, 0.05);
  ApplyLedger(report, "2026-01-01", false);
  EXPECT_EQ(report.findings[1].verdict, Verdict::kFail);
  EXPECT_EQ(
      report.findings[1].proof,
      "It is wrong. known_discrepancies.bounds:4 allows 0.05; 0.08 exceeds it by 0.03.");
  EXPECT_FALSE(report.findings[0].outgrown_entry);
  EXPECT_EQ(report.findings[1].outgrown_entry, 0);
  EXPECT_FALSE(report.findings[1].ledger_entry);
  // A wider bound excuses it again.
  report.ledger.bounds.at(CellOfFailure(1)).value = 0.1;
  ApplyAgain(report);
  EXPECT_FALSE(report.findings[1].outgrown_entry);
  EXPECT_EQ(report.findings[1].ledger_entry, 0);
}

// The entry says why an engine fails, the bound where. Otherwise a glob would excuse
// cells that pass today.
TEST(ApplyLedger, ExcusesNoCellWithoutABound) {
  RunReport report = ReportOfFailures({0.04, 0.04}, 0.05);
  report.ledger.bounds.erase(CellOfFailure(1));
  ApplyLedger(report, "2026-01-01", false);
  EXPECT_EQ(report.findings[0].verdict, Verdict::kKnown);
  EXPECT_EQ(report.findings[1].verdict, Verdict::kFail);
  EXPECT_EQ(report.findings[1].proof,
            "It is wrong. known_discrepancies.toml:17 covers it, but "
            "known_discrepancies.bounds has no bound for it.");
  EXPECT_FALSE(report.findings[1].outgrown_entry);
}

TEST(ApplyLedger, ExcusesNoCellWithoutAnEntry) {
  RunReport report = ReportOfFailures({0.04}, 0.05);
  report.ledger.entries[0].scenarios = {"contact/zoo/*", "contact/box_box/1"};
  ApplyLedger(report, "2026-01-01", true);
  EXPECT_EQ(report.findings[0].verdict, Verdict::kFail);
  report = ReportOfFailures({0.04}, 0.05);
  report.ledger.entries[0].scenarios = {"contact/zoo/*", "contact/box_box/0"};
  ApplyLedger(report, "2026-01-01", true);
  EXPECT_EQ(report.findings[0].verdict, Verdict::kKnown);
}

TEST(ApplyLedger, LetsTheLastEntryHideAFinding) {
  RunReport report = ReportOfFailures({0.04, 0.04}, 0.05);
  report.ledger.entries.push_back(report.ledger.entries[0]);
  report.ledger.entries[1].scenarios = {"contact/box_box/1"};
  ApplyLedger(report, "2026-01-01", false);
  EXPECT_EQ(report.findings[0].ledger_entry, 0);
  EXPECT_EQ(report.findings[1].ledger_entry, 1);
  EXPECT_THAT(report.faults, IsEmpty());
}

TEST(ApplyLedger, BoundsTheFindingsOfEachLawSeparately) {
  RunReport report = ReportOfFailures({0.04, 0.04}, 0.05);
  report.findings[1].scenario = report.findings[0].scenario;
  report.findings[0].law = "rolls";
  report.findings[1].law = "slides";
  LedgerCell cell = CellOfFailure(0);
  cell.law = "rolls";
  report.ledger.bounds = {{cell, {Verdict::kFail, 0.05, 3}}};
  ApplyLedger(report, "2026-01-01", true);
  EXPECT_EQ(report.findings[0].verdict, Verdict::kKnown);
  EXPECT_EQ(report.findings[1].verdict, Verdict::kFail);
}

TEST(ApplyLedger, AcceptsAnErrorOfTheSizeOfTheSceneOnlyIfTheEntrySaysSo) {
  RunReport report = ReportOfFailures({1.1}, 1.2);
  ApplyLedger(report, "2026-01-01", false);
  EXPECT_EQ(report.findings[0].verdict, Verdict::kFail);
  EXPECT_THAT(report.findings[0].proof,
              HasSubstr("allows 1.2 of the scene, but known_discrepancies.toml:17 lacks "
                        "beyond_scene."));
  report = ReportOfFailures({1.1}, 1.2);
  report.ledger.entries[0].beyond_scene = true;
  ApplyLedger(report, "2026-01-01", false);
  EXPECT_EQ(report.findings[0].verdict, Verdict::kKnown);
  EXPECT_THAT(report.faults, IsEmpty());
  report = ReportOfFailures({0.9}, 0.99);
  report.ledger.entries[0].beyond_scene = true;
  ApplyLedger(report, "2026-01-01", false);
  EXPECT_THAT(report.faults, ElementsAre(HasSubstr("remove beyond_scene")));
}

TEST(ApplyLedger, AcceptsAVerdictWithoutAValueOnlyByItsName) {
  for (const Verdict accepted : {Verdict::kCrashed, Verdict::kInvalid, Verdict::kFail}) {
    RunReport report = ReportOfFailures({1}, 0.05);
    report.findings[0].verdict = Verdict::kCrashed;
    report.ledger.entries[0].verdict = Verdict::kCrashed;
    report.ledger.bounds[CellOfFailure(0)] = {accepted, 0, 3};
    ApplyLedger(report, "2026-01-01", true);
    EXPECT_EQ(report.findings[0].verdict,
              accepted == Verdict::kCrashed ? Verdict::kKnown : Verdict::kCrashed);
  }
}

TEST(ApplyLedger, ExcusesAMissedHairlineContactButNotAMissedDeepOne) {
  const double size = SceneSize(SphereInBoxFace(1e-3).query);
  RunReport report = ReportOfFailures({1, 1}, 1e-5 / size);
  report.ledger.entries[0].measures = {MeasureKind::kTouching};
  report.ledger.bounds = {
      {CellOfFailure(0, MeasureKind::kTouching), {Verdict::kFail, 1e-5 / size, 3}},
      {CellOfFailure(1, MeasureKind::kTouching), {Verdict::kFail, 1e-5 / size, 4}}};
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
  RunReport report = ReportOfFailures({0, 0}, 0.05);
  report.ledger.bounds.clear();
  ApplyLedger(report, "2026-01-01", false);
  EXPECT_THAT(
      report.faults,
      ElementsAre("known_discrepancies.toml:17: improved: remove this entry, it hides "
                  "nothing (ode in contact/box_box/*)."));
}

TEST(ApplyLedger, DoesNotCallAnEntryImprovedWhoseFindingsExceedTheirBounds) {
  RunReport report = ReportOfFailures({0.08, 0.08}, 0.05);
  ApplyLedger(report, "2026-01-01", false);
  EXPECT_EQ(report.findings[0].outgrown_entry, 0);
  EXPECT_THAT(report.faults, IsEmpty());
}

TEST(ApplyLedger, FailsABoundThatHidesNothing) {
  RunReport report = ReportOfFailures({0.04, 0}, 0.05);
  ApplyLedger(report, "2026-01-01", false);
  EXPECT_THAT(
      report.faults,
      ElementsAre("known_discrepancies.toml:17: improved: 1 of its bounds hides nothing "
                  "above a twelfth, e.g. contact/box_box/1 ode excess "
                  "(known_discrepancies.bounds:4): run `touchstone ledger --update`."));
}

// Whether it fails or passes just below its tolerance may depend on the processor.
TEST(ApplyLedger, KeepsABoundWhoseFindingPassesByLittle) {
  RunReport report = ReportOfFailures({0.04, 0.01}, 0.05);
  report.findings[1].verdict = Verdict::kPass;
  ApplyLedger(report, "2026-01-01", false);
  EXPECT_THAT(report.faults, IsEmpty());
}

TEST(ApplyLedger, FailsABoundWhoseCellHasNoFindingOrNoEntry) {
  RunReport report = ReportOfFailures({0.04}, 0.05);
  report.ledger.bounds[CellOfFailure(7)] = {Verdict::kFail, 0.05, 9};
  ApplyLedger(report, "2026-01-01", false);
  EXPECT_THAT(report.faults, ElementsAre(HasSubstr("contact/box_box/7 ode excess")));
  report = ReportOfFailures({0.04}, 0.05);
  report.ledger.bounds[CellOfFailure(0, MeasureKind::kSwap)] = {Verdict::kFail, 0.05, 9};
  ApplyLedger(report, "2026-01-01", false);
  EXPECT_THAT(report.faults,
              ElementsAre("known_discrepancies.bounds: 1 bound that no entry covers, "
                          "e.g. contact/box_box/0 ode swap "
                          "(known_discrepancies.bounds:9): run `touchstone ledger "
                          "--update`."));
}

// The value of `touching` is the distance from touching, whatever was answered.
TEST(ApplyLedger, FailsABoundOfTouchingWhoseFindingPasses) {
  RunReport report = ReportOfFailures({0.04, 0}, 0.05);
  report.findings[1].measure = MeasureKind::kTouching;
  report.scenarios[1].truth.separation = {-1e-5, -0.9e-5};
  report.ledger.entries[0].measures = {MeasureKind::kTouching, MeasureKind::kExcess};
  report.ledger.bounds.erase(CellOfFailure(1));
  report.ledger.bounds[CellOfFailure(1, MeasureKind::kTouching)] = {Verdict::kFail, 1e-5,
                                                                    9};
  ApplyLedger(report, "2026-01-01", false);
  EXPECT_THAT(report.faults,
              testing::Contains(HasSubstr("contact/box_box/1 ode touching")));
}

TEST(ApplyLedger, LetsAnIntermittentEntryHideNothing) {
  RunReport report = ReportOfFailures({0, 0}, 0.05);
  report.ledger.entries[0].intermittent = true;
  ApplyLedger(report, "2026-01-01", false);
  EXPECT_THAT(report.faults, IsEmpty());
  report = ReportOfFailures({0.04, 0.08}, 0.05);
  report.ledger.entries[0].intermittent = true;
  ApplyLedger(report, "2026-01-01", false);
  EXPECT_EQ(report.findings[0].verdict, Verdict::kKnown);
  EXPECT_EQ(report.findings[1].verdict, Verdict::kFail);
}

// Whether an engine hangs may differ from run to run, and there is nothing to bound.
TEST(ApplyLedger, LetsAnIntermittentEntryExcuseAVerdictWithoutAValueWithoutABound) {
  for (const Verdict verdict : {Verdict::kTimedOut, Verdict::kFail}) {
    RunReport report = ReportOfFailures({1}, 0.05);
    report.ledger.bounds.clear();
    report.findings[0].verdict = verdict;
    report.ledger.entries[0].verdict = verdict;
    report.ledger.entries[0].intermittent = true;
    ApplyLedger(report, "2026-01-01", false);
    EXPECT_EQ(report.findings[0].verdict,
              verdict == Verdict::kTimedOut ? Verdict::kKnown : Verdict::kFail);
  }
}

TEST(ApplyLedger, FailsABoundThatIsTwelveTimesTooWide) {
  RunReport report = ReportOfFailures({0.05 / 12.1}, 0.05);
  ApplyLedger(report, "2026-01-01", false);
  ASSERT_EQ(report.faults.size(), 1U);
  EXPECT_THAT(report.faults[0], HasSubstr("hides nothing above a twelfth"));
  report = ReportOfFailures({0.05 / 11.9}, 0.05);
  ApplyLedger(report, "2026-01-01", false);
  EXPECT_THAT(report.faults, IsEmpty());
}

// The large bound of one measure must not excuse an error in another.
TEST(ApplyLedger, BoundsEachMeasureSeparately) {
  RunReport report = ReportOfFailures({0.04, 0.04}, 0.05);
  report.ledger.entries[0].measures.push_back(MeasureKind::kConsistencyError);
  report.ledger.bounds[CellOfFailure(1, MeasureKind::kConsistencyError)] = {
      Verdict::kFail, 0.001, 9};
  report.findings[1].measure = MeasureKind::kConsistencyError;
  ApplyLedger(report, "2026-01-01", true);
  EXPECT_EQ(report.findings[0].verdict, Verdict::kKnown);
  EXPECT_EQ(report.findings[1].verdict, Verdict::kFail);
  EXPECT_THAT(report.findings[1].proof, HasSubstr("allows 0.001"));
}

TEST(ApplyLedger, FailsAnEntryOneOfWhoseMeasuresHidesNothing) {
  RunReport report = ReportOfFailures({0.04, 0}, 0.05);
  report.ledger.entries[0].measures.push_back(MeasureKind::kConsistencyError);
  report.ledger.bounds.erase(CellOfFailure(1));
  report.findings[1].measure = MeasureKind::kConsistencyError;
  ApplyLedger(report, "2026-01-01", false);
  EXPECT_THAT(report.faults,
              ElementsAre("known_discrepancies.toml:17: improved: remove "
                          "consistency_error, the entry hides none of it (ode in "
                          "contact/box_box/*)."));
}

TEST(ApplyLedger, CallsNothingImprovedInAPartialRun) {
  RunReport report = ReportOfFailures({0, 0}, 0.05);
  ApplyLedger(report, "2026-01-01", true);
  EXPECT_THAT(report.faults, IsEmpty());
}

TEST(ApplyLedger, FaultsAnEntryThatMatchesNothing) {
  RunReport report = ReportOfFailures({0, 0}, 0.05);
  report.ledger.bounds.clear();
  report.ledger.entries[0].scenarios = {"contact/bxo_box/*"};
  ApplyLedger(report, "2026-01-01", true);
  EXPECT_THAT(report.faults, IsEmpty());
  ApplyLedger(report, "2026-01-01", false);
  EXPECT_THAT(
      report.faults,
      ElementsAre("known_discrepancies.toml:17: matches no finding of the run: correct "
                  "or remove this entry (ode in contact/bxo_box/*)."));
}

// Also in a run of a part of the catalogue, which is all that a user's own folder is.
TEST(ApplyLedger, FaultsAnEntryForAnOracleThatNoBuildHas) {
  const auto is_oracle = [](std::string_view name) { return name == "fcl/collide"; };
  for (const bool partial : {true, false}) {
    RunReport report = ReportOfFailures({0.04}, 0.05);
    report.ledger.bounds.clear();
    report.ledger.entries[0].oracle = "fcl/collide";  // Not in this build.
    ApplyLedger(report, "2026-01-01", partial, is_oracle);
    EXPECT_THAT(report.faults, IsEmpty());
    report.ledger.entries[0].oracle = "fcl/colide";
    ApplyLedger(report, "2026-01-01", partial, is_oracle);
    EXPECT_THAT(report.faults,
                ElementsAre("known_discrepancies.toml:17: no build has an oracle "
                            "\"fcl/colide\": correct or remove this entry."));
  }
}

TEST(ApplyLedger, FailsAnExpiredEntryThoughItStillExcuses) {
  RunReport report = ReportOfFailures({0.04}, 0.05);
  ApplyLedger(report, "2026-07-01", false);
  EXPECT_EQ(report.findings[0].verdict, Verdict::kKnown);
  ASSERT_EQ(report.faults.size(), 1U);
  EXPECT_THAT(report.faults[0],
              HasSubstr("known_discrepancies.toml:17: expired on 2026-06-30"));
  // An entry that matches nothing expires too: otherwise nobody would review it.
  report = ReportOfFailures({0.04}, 0.05);
  report.ledger.entries[0].scenarios = {"contact/bxo_box/*"};
  ApplyLedger(report, "2026-07-01", false);
  EXPECT_THAT(report.faults, testing::Contains(HasSubstr("expired on 2026-06-30")));
  report = ReportOfFailures({0.04}, 0.05);
  ApplyLedger(report, "2026-06-30", false);
  EXPECT_THAT(report.faults, IsEmpty());
}

TEST(ApplyLedger, IsVoidForAnotherVersion) {
  RunReport report = ReportOfFailures({0.04}, 0.05);
  report.oracles[0].version = "0.16.3";
  ApplyLedger(report, "2026-01-01", false);
  EXPECT_EQ(report.findings[0].verdict, Verdict::kFail);
  EXPECT_THAT(report.findings[0].proof, HasSubstr("is void: it is for version 0.16.2"));
  EXPECT_TRUE(report.ledger_use[0].voided);
  EXPECT_THAT(report.faults, IsEmpty());
}

TEST(ApplyLedger, ExcusesOnlyItsOwnOracleMeasureAndVerdict) {
  for (const auto& change : std::vector<std::function<void(LedgerEntry&)>>{
           [](LedgerEntry& e) { e.oracle = "ode/other"; },
           [](LedgerEntry& e) { e.measures = {MeasureKind::kSeparationError}; },
           [](LedgerEntry& e) { e.verdict = Verdict::kDisagree; }}) {
    RunReport report = ReportOfFailures({0.04}, 0.05);
    change(report.ledger.entries[0]);
    ApplyLedger(report, "2026-01-01", true);
    EXPECT_EQ(report.findings[0].verdict, Verdict::kFail);
  }
}

TEST(ApplyLedger, NeverExcusesNan) {
  RunReport report = ReportOfFailures({0.04}, 0.05);
  report.findings[0].value = std::nan("");
  ApplyLedger(report, "2026-01-01", true);
  EXPECT_EQ(report.findings[0].verdict, Verdict::kFail);
}

TEST(ProposeLedger, MakesOneEntryOfAFolderInWhichAllFail) {
  RunReport report = ReportOfFailures({0.01, 0.04}, 0.05);
  report.ledger.entries.clear();
  EXPECT_EQ(ProposeLedger(report, "2026-06-30"),
            "# 2 scenarios; the worst: It is wrong.\n"
            "[[entry]]\n"
            "scenarios = \"contact/box_box/*\"\n"
            "oracle = \"ode\"\n"
            "version = \"0.16.2\"\n"
            "verdict = \"fail\"\n"
            "measures = [\"excess\"]\n"
            "cause = \"defect\"\n"
            "reason = \"\"\n"
            "upstream = \"unreported\"\n"
            "expires = 2026-06-30\n");
}

TEST(ProposeLedger, NamesSingleScenariosWhereOthersPass) {
  const std::string text = ProposeLedger(ReportOfFailures({0.01, 0, 0.04}, 0.05));
  EXPECT_THAT(text, HasSubstr("scenarios = \"contact/box_box/0\""));
  EXPECT_THAT(text, HasSubstr("scenarios = \"contact/box_box/2\""));
  EXPECT_THAT(text, testing::Not(HasSubstr("*")));
}

TEST(ProposeLedger, ListsTheMeasuresOfVerdictsWithoutAValue) {
  RunReport report = ReportOfFailures({1}, 0.05);
  report.ledger.entries.clear();
  report.findings[0].measure = MeasureKind::kAnswering;
  report.findings[0].verdict = Verdict::kCrashed;
  EXPECT_THAT(ProposeLedger(report),
              HasSubstr("verdict = \"crashed\"\nmeasures = [\"answering\"]\n"));
}

TEST(ProposeLedger, IsRefusedUntilAPersonGivesReasons) {
  const std::string text =
      ProposeLedger(ReportOfFailures({0.01, 0, 0.04}, 0.05), "2026-06-30");
  const LedgerResult result = ReadLedger(text, "proposed.toml");
  ASSERT_EQ(result.diagnostics.size(), 2U);
  for (const Diagnostic& d : result.diagnostics) EXPECT_EQ(d.what, "reason is empty");
}

TEST(ProposeLedger, ExcusesItsOwnFailuresOnceReasonsAndBoundsAreGiven) {
  RunReport report = ReportOfFailures({0.0123, 0, 0.0456}, 0.05);
  std::string text = ProposeLedger(report, "2026-06-30");
  for (auto at = text.find("reason = \"\""); at != std::string::npos;
       at = text.find("reason = \"\"")) {
    text.replace(at, 11, "reason = \"It is so.\"");
  }
  report.ledger = ReadLedger(text, "proposed.toml").ledger.value();
  ApplyLedger(report, "2026-01-01", true);
  report.ledger.bounds = UpdateBounds(report).bounds;
  ApplyLedger(report, "2026-01-01", false);
  EXPECT_THAT(report.faults, IsEmpty());
  for (const Finding& finding : report.findings)
    EXPECT_NE(finding.verdict, Verdict::kFail);
  EXPECT_EQ(ProposeLedger(report), "");
}

}  // namespace
}  // namespace touchstone
