#include "reports/writers/outcome.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "hand_made_report.h"

namespace touchstone {
namespace {

TEST(OutcomesOf, ReturnsOneOutcomePerScenarioAndOracle) {
  const RunReport report = HandMadeReport();
  const std::vector<Outcome> outcomes = OutcomesOf(report);
  ASSERT_EQ(outcomes.size(), 6u);
  EXPECT_EQ(outcomes[0].verdict, Verdict::kPass);
  EXPECT_EQ(outcomes[1].verdict, Verdict::kKnown);
  EXPECT_EQ(outcomes[2].verdict, Verdict::kFail);
  EXPECT_EQ(outcomes[3].verdict, Verdict::kInvalid);
  EXPECT_EQ(outcomes[4].verdict, Verdict::kUndecidable);
  EXPECT_EQ(outcomes[5].verdict, Verdict::kUnsupported);
}

TEST(OutcomesOf, DecidesByTheSimplestProofNotTheLargestError) {
  RunReport report = HandMadeReport();
  report.findings[3].value =
      1e9;  // Consistency error, enumerated after separation error.
  const std::vector<Outcome> outcomes = OutcomesOf(report);
  const Outcome& outcome = outcomes[2];
  ASSERT_EQ(outcome.findings.size(), 2u);
  EXPECT_EQ(outcome.decisive->measure, MeasureKind::kSeparationError);
  EXPECT_EQ(outcome.worst->measure, MeasureKind::kConsistencyError);
}

TEST(OutcomesOf, DecidesByTheGravestFault) {
  RunReport report = HandMadeReport();
  report.findings[2].grade = Grade::kRounding;
  report.findings[3].grade = Grade::kGross;
  EXPECT_EQ(OutcomesOf(report)[2].decisive->measure, MeasureKind::kConsistencyError);
  report.findings[3].grade = Grade::kRounding;
  EXPECT_EQ(OutcomesOf(report)[2].decisive->measure, MeasureKind::kSeparationError);
}

// A false hit has no contacts to return: that it returns none is not the fault.
TEST(OutcomesOf, DecidesByAFalseHitBeforeItsMissingContacts) {
  RunReport report = HandMadeReport();
  Finding& touching = report.findings[2];
  touching.measure = MeasureKind::kTouching;
  touching.grade = Grade::kWrongTouch;
  Finding& missing = report.findings[3];
  missing.measure = MeasureKind::kAnswering;
  missing.verdict = Verdict::kInvalid;
  missing.grade = Grade::kUnusable;
  EXPECT_EQ(OutcomesOf(report)[2].verdict, Verdict::kFail);
  EXPECT_EQ(OutcomesOf(report)[2].decisive->measure, MeasureKind::kTouching);
  touching.grade = Grade::kRounding;
  EXPECT_EQ(OutcomesOf(report)[2].verdict, Verdict::kInvalid);
  // A normal that is short by a rounding hides no error of a depth.
  missing.grade = Grade::kRounding;
  touching.measure = MeasureKind::kSeparationError;
  touching.grade = Grade::kGross;
  EXPECT_EQ(OutcomesOf(report)[2].decisive->measure, MeasureKind::kSeparationError);
}

TEST(OutcomesOf, CountsTheReasonsOfUndecidableAnswersApart) {
  RunReport report = HandMadeReport();
  report.findings[5].undecided = Undecided::kOpposed;
  const std::vector<Outcome> outcomes = OutcomesOf(report);
  ASSERT_EQ(outcomes[4].verdict, Verdict::kUndecidable);
  EXPECT_EQ(VerdictInWords(outcomes[4]), "undecidable: sign known and opposed");
  VerdictCounts counts;
  for (const Outcome& outcome : outcomes) Count(outcome, counts);
  EXPECT_EQ(counts[Undecided::kOpposed], 1);
  EXPECT_EQ(UndecidedInWords(counts), "1 sign known and opposed");
}

TEST(Sentence, SaysThatAnErrorIsWithinTheFactorOfSafety) {
  Finding finding = HandMadeReport().findings[2];
  finding.grade = Grade::kLarge;
  finding.tolerance = 1;
  finding.safety = 1.5;
  finding.value = 1.4;
  EXPECT_THAT(Sentence(finding), testing::HasSubstr("1.4 m where 1 m is allowed"));
  EXPECT_THAT(Sentence(finding), testing::HasSubstr("factor of 1.5 for safety"));
  EXPECT_THAT(Sentence(finding), testing::HasSubstr("fail, over 0.001 in "));
  finding.value = 1.6;
  EXPECT_THAT(Sentence(finding), testing::Not(testing::HasSubstr("for safety")));
}

TEST(OutcomesOf, DoesNotCountAnotherLegalModelAsAnError) {
  RunReport report = HandMadeReport();
  Finding& recognised = report.findings[3];
  recognised.value = 1e9;
  recognised.verdict = Verdict::kPass;
  recognised.reference = "law";
  recognised.cause = Cause::kModel;
  recognised.cause_because = "simultaneous impacts";
  EXPECT_EQ(OutcomesOf(report)[2].worst->measure, MeasureKind::kSeparationError);
}

TEST(OutcomesOf, RanksAFailureAboveAPass) {
  RunReport report = HandMadeReport();
  report.findings[2].verdict = Verdict::kPass;
  EXPECT_EQ(OutcomesOf(report)[2].verdict, Verdict::kFail);
}

TEST(OutcomesOf, CountsAScenarioWithoutAnyMeasureAsUnsupported) {
  RunReport report = HandMadeReport();
  report.findings.clear();
  for (const Outcome& outcome : OutcomesOf(report)) {
    EXPECT_EQ(outcome.verdict, Verdict::kUnsupported);
    EXPECT_EQ(outcome.decisive, nullptr);
  }
}

/** Returns the findings of an answer with an unverified claim. */
std::vector<Finding> AnsweredWithoutProof(const RunReport& report) {
  Finding answered = report.findings.front();
  answered.measure = MeasureKind::kAnswering;
  Finding unverified = answered;
  unverified.verdict = Verdict::kUnsupported;
  return {answered, unverified};
}

TEST(OutcomesOf, PassesNoAnswerWithoutAVerifiedClaim) {
  RunReport report = HandMadeReport();
  const Finding proof = report.findings.front();
  report.findings = AnsweredWithoutProof(report);
  EXPECT_EQ(OutcomesOf(report)[0].verdict, Verdict::kUnsupported);
  EXPECT_EQ(OutcomesOf(report)[0].decisive, &report.findings[1]);
  // A body that never moves is the same in every frame, so a variant verifies nothing.
  Finding variant = proof;
  variant.measure = MeasureKind::kTranslation;
  variant.reference.clear();
  report.findings.push_back(variant);
  EXPECT_EQ(OutcomesOf(report)[0].verdict, Verdict::kUnsupported);
  report.findings.back() = proof;
  EXPECT_EQ(OutcomesOf(report)[0].verdict, Verdict::kPass);
}

TEST(RelativeToTolerance, IsInfiniteForNan) {
  Finding finding;
  finding.value = std::nan("");
  finding.tolerance = 1;
  EXPECT_TRUE(std::isinf(RelativeToTolerance(finding)));
}

TEST(RelativeToTolerance, IsInfiniteForAnErrorBeyondAZeroTolerance) {
  Finding finding;
  finding.value = 1;
  EXPECT_TRUE(std::isinf(RelativeToTolerance(finding)));
  finding.value = 0;
  EXPECT_EQ(RelativeToTolerance(finding), 0);
}

TEST(RelativeInWords, StatesTheValueIfTheToleranceIsZero) {
  Finding finding;
  finding.value = 3;
  finding.tolerance = 2;
  EXPECT_EQ(RelativeInWords(finding), "1.5 × tolerance");
  finding.tolerance = 0;
  EXPECT_EQ(RelativeInWords(finding), "3 where 0 is allowed");
}

TEST(GroupOf, IsTheFolderOfTheId) {
  EXPECT_EQ(GroupOf("contact/box_box/a"), "contact/box_box");
  EXPECT_EQ(GroupOf("alone"), "alone");
}

TEST(TallyByGroup, CountsEachGroupSeparately) {
  const RunReport report = HandMadeReport();
  const std::vector<GroupTally> groups = TallyByGroup(report, OutcomesOf(report));
  ASSERT_EQ(groups.size(), 2u);
  EXPECT_EQ(groups[0].group, "contact/box_sphere");
  EXPECT_EQ(groups[0].scenarios, 2);
  EXPECT_EQ(groups[0].oracles[0].outcomes[Verdict::kPass], 1);
  EXPECT_EQ(groups[0].oracles[0].outcomes.failed(), 1);
  EXPECT_EQ(groups[1].oracles[1].outcomes[Verdict::kUnsupported], 1);
}

TEST(Sentence, StatesOracleMeasureValueToleranceProofAndCause) {
  const RunReport report = HandMadeReport();
  EXPECT_EQ(
      Sentence(report.findings[2]),
      "mine: fail in separation_error, 0.01 m where 1e-15 m is allowed (64 unit "
      "roundoffs of the scene). Proof: mine says 0.04 deep; moving B by 0.04 along n "
      "leaves 0.01 of overlap. Cause: defect.");
}

TEST(Sentence, NamesTheLegalModelThatAMotionFollows) {
  Finding finding = HandMadeReport().findings[2];
  finding.verdict = Verdict::kPass;
  finding.reference = "law";
  finding.law = "row_impact";
  finding.cause = Cause::kModel;
  finding.cause_because = "simultaneous impacts";
  EXPECT_THAT(Sentence(finding),
              testing::HasSubstr("mine: pass, recognised as simultaneous impacts in "));
  EXPECT_EQ(RecognisedModelOf(finding), "simultaneous impacts");
  finding.reference = "referee";
  EXPECT_EQ(RecognisedModelOf(finding), "");
}

TEST(Sentence, WritesEnoughDigitsToDistinguishAValueFromItsTolerance) {
  Finding finding = HandMadeReport().findings[2];
  finding.value = 1.23412e-5;
  finding.tolerance = 1.23401e-5;
  EXPECT_THAT(Sentence(finding),
              testing::HasSubstr("1.23412e-05 m where 1.23401e-05 m is allowed"));
}

}  // namespace
}  // namespace touchstone
