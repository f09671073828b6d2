#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reports/contacts/causes/convention.h"
#include "reports/contacts/causes/margin.h"
#include "reports/contacts/causes/precision.h"
#include "reports/contacts/causes/tie.h"
#include "reports/contacts/judge_answer.h"
#include "reports/referee/referee.h"
#include "tests/reports/fake_oracle.h"
#include "tests/reports/specimens.h"

namespace touchstone {
namespace {

using testing::HasSubstr;

constexpr double kDepth = 2e-3;  // [m]

/** Returns the convention found for each failure of an answer; "" where none is found. */
std::vector<std::string> Conventions(const Specimen& s) {
  const FakeOracle oracle("mine");
  Scenario scenario;
  scenario.id = "contact/specimen";
  scenario.contact = s.query;
  std::vector<Finding> findings = JudgeAnswer(scenario, s.truth, oracle.info(), s.right);
  std::vector<Finding*> all;
  for (Finding& finding : findings) all.push_back(&finding);
  ExplainByConvention(scenario, s.truth, oracle.info(), s.right, all);
  std::vector<std::string> conventions;
  for (const Finding& finding : findings) {
    if (finding.verdict != Verdict::kFail) continue;
    EXPECT_EQ(finding.cause == Cause::kConvention, !finding.cause_because.empty());
    conventions.push_back(finding.cause_because);
  }
  return conventions;
}

void ScaleSeparations(ContactAnswer& answer, double factor) {
  *answer.separation *= factor;
  for (ContactPoint& contact : answer.points) contact.separation *= factor;
}

void ShiftContacts(ContactAnswer& answer, double distance) {
  for (ContactPoint& contact : answer.points) contact.p_WC += distance * *answer.n_AB_W;
}

TEST(Convention, IsNotLookedForInRightAnswers) {
  EXPECT_THAT(Conventions(BoxOnBoxFace(kDepth)), testing::IsEmpty());
}

TEST(Convention, RecognisesANormalFromBToA) {
  Specimen s = BoxOnBoxFace(kDepth);
  *s.right.n_AB_W *= -1;
  const auto conventions = Conventions(s);
  EXPECT_GE(conventions.size(), 3U);
  EXPECT_THAT(conventions, testing::Each("its normal points from B to A"));
}

TEST(Convention, RecognisesHalvedDoubledAndNegatedDepths) {
  for (const auto& [factor, words] : {std::pair(0.5, "half of what it is"),
                                      {2.0, "twice what it is"},
                                      {-1.0, "other sign"}}) {
    Specimen s = BoxOnBoxFace(kDepth);
    ScaleSeparations(s.right, factor);
    const auto conventions = Conventions(s);
    EXPECT_GE(conventions.size(), 2U);
    EXPECT_THAT(conventions, testing::Each(HasSubstr(words)));
  }
}

TEST(Convention, RecognisesContactsOnEitherSurface) {
  // A's surface is half the depth along n from the midpoint.
  for (const auto& [shift, words] : {std::pair(kDepth / 2, "on the surface of A"),
                                     {-kDepth / 2, "on the surface of B"}}) {
    Specimen s = BoxOnBoxFace(kDepth);
    ShiftContacts(s.right, shift);
    const auto conventions = Conventions(s);
    ASSERT_EQ(conventions.size(), 1U);
    EXPECT_THAT(conventions[0], HasSubstr(words));
  }
}

TEST(Convention, RecognisesTwoAtOnce) {
  Specimen s = BoxOnBoxFace(kDepth);
  *s.right.n_AB_W *= -1;
  ScaleSeparations(s.right, 0.5);
  const auto conventions = Conventions(s);
  EXPECT_GE(conventions.size(), 3U);
  EXPECT_THAT(conventions, testing::Contains("its normal points from B to A, and its "
                                             "separation is half of what it is along the "
                                             "normal"));
  EXPECT_THAT(conventions, testing::Not(testing::Contains("")));
}

TEST(Convention, IsNotInferredFromSeparationsNearTheTolerance) {
  // The answer says a little more than twice 2e-14 m: an error above the tolerance of
  // 1e-14 m that is near a doubling by chance.
  Specimen s = BoxOnBoxFace(2e-14);
  s.truth = ComputeContactTruth(s.query);
  ScaleSeparations(s.right, 2.2);
  const auto conventions = Conventions(s);
  EXPECT_FALSE(conventions.empty());
  EXPECT_THAT(conventions, testing::Each(""));
}

TEST(Convention, ExplainsNoOtherError) {
  Specimen s = BoxOnBoxFace(kDepth);
  ScaleSeparations(s.right, 1.3);
  EXPECT_THAT(Conventions(s), testing::Each(""));
  s = BoxOnBoxFace(kDepth);
  s.right.n_AB_W = s.query.A.X_WB.R_WB.col(0);
  EXPECT_THAT(Conventions(s), testing::Each(""));
  s = BoxOnBoxFace(kDepth);
  s.right.points.resize(1);
  EXPECT_THAT(Conventions(s), testing::Each(""));
}

TEST(Tie, IsAnotherNormalThatIsAsGood) {
  const Specimen s = BoxOnBoxFace(kDepth);
  EXPECT_EQ(TieOf(s.truth, *s.right.n_AB_W), std::nullopt);
  const auto tie = TieOf(s.truth, s.query.A.X_WB.R_WB.col(0));
  ASSERT_TRUE(tie.has_value());
  EXPECT_THAT(*tie, HasSubstr("1.57 rad away"));
}

TEST(Tie, IsNotTheSameNormalRounded) {
  const Specimen s = BoxOnBoxFace(kDepth);
  const Eigen::Vector3d rounded = s.right.n_AB_W->cast<float>().cast<double>();
  EXPECT_EQ(TieOf(s.truth, rounded), std::nullopt);
}

TEST(Neighbours, AreAFewRoundingsAwayAndNotTheQuestionItself) {
  const ContactQuery query = BoxOnBoxFace(kDepth).query;
  for (const double u : {0x1p-53, 0x1p-24}) {
    for (const ContactQuery& neighbour : NeighboursOf(query, u)) {
      const double moved = (neighbour.B.X_WB.p_WB - query.B.X_WB.p_WB).norm();
      const double turned = (neighbour.B.X_WB.R_WB - query.B.X_WB.R_WB).norm();
      EXPECT_GT(moved + turned, 0);
      // The limit is four roundings of the scene, and one for storing each number.
      EXPECT_LE(moved, 8 * u * SceneSize(query));
      EXPECT_LE(turned, 16 * u);
    }
  }
}

TEST(Neighbours, OfAFloatEngineIncludeTheInputRoundedToFloat) {
  const ContactQuery query = SphereInBoxFace(kDepth).query;
  const ContactQuery rounded = NeighboursOf(query, 0x1p-24).back();
  EXPECT_EQ(std::get<Sphere>(rounded.B.shape).radius, static_cast<double>(1.0F / 3));
  EXPECT_EQ(rounded.A.X_WB.p_WB.x(), static_cast<double>(0.31F));
}

Finding Failure(MeasureKind measure, double value) {
  Finding finding{};
  finding.measure = measure;
  finding.value = value;
  finding.verdict = Verdict::kFail;
  return finding;
}

TEST(Precision, ExplainsAnErrorThatTheNeighboursShowToo) {
  const Specimen s = BoxOnBoxFace(kDepth);
  ContactAnswer jumped = s.right;
  *jumped.separation -= 3e-4;
  const std::vector<ContactAnswer> neighbours = {s.right, jumped};
  const double movement = MovementOf(s.query, s.truth, s.right, neighbours);
  EXPECT_NEAR(movement, 3e-4, 1e-12);
  const Finding finding = Failure(MeasureKind::kSeparationError, 5e-4);
  EXPECT_THAT(PrecisionOf(finding, s.truth, movement, 0x1p-53).value(),
              HasSubstr("4 roundings of 2^-53 on its input move its answer by 0.0003 m"));
}

TEST(Precision, DoesNotExplainAnErrorThatStaysPut) {
  const Specimen s = BoxOnBoxFace(kDepth);
  const std::vector<ContactAnswer> neighbours = {s.right, s.right};
  const double movement = MovementOf(s.query, s.truth, s.right, neighbours);
  const Finding finding = Failure(MeasureKind::kSeparationError, 5e-4);
  EXPECT_EQ(PrecisionOf(finding, s.truth, movement, 0x1p-53), std::nullopt);
}

TEST(Precision, ExplainsATouchingVerdictThatFlips) {
  const Specimen s = BoxOnBoxFace(kDepth);
  ContactAnswer missed = s.right;
  missed.touching = false;
  const std::vector<ContactAnswer> neighbours = {missed};
  const double movement = MovementOf(s.query, s.truth, s.right, neighbours);
  const Finding finding = Failure(MeasureKind::kTouching, 1);
  EXPECT_NE(PrecisionOf(finding, s.truth, movement, 0x1p-53), std::nullopt);
}

TEST(Precision, LearnsNothingFromNeighboursWithoutAnAnswer) {
  const Specimen s = BoxOnBoxFace(kDepth);
  ContactAnswer broken = s.right;
  broken.n_AB_W->setZero();
  ContactAnswer crashed;
  crashed.status = AnswerStatus::kCrashed;
  ContactAnswer nan = s.right;
  nan.separation = NAN;
  const std::vector<ContactAnswer> neighbours = {broken, crashed, nan};
  EXPECT_EQ(MovementOf(s.query, s.truth, s.right, neighbours), 0);
}

/** Returns the causes found for separations that are off by `errors` in questions with
 `truths`. */
std::vector<Cause> Margins(std::vector<double> errors, std::vector<double> truths) {
  std::vector<Finding> findings(errors.size());
  std::vector<SignedError> off;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    findings[i] = Failure(MeasureKind::kSeparationError, std::abs(errors[i]));
    findings[i].tolerance = 1e-12;
    off.push_back({&findings[i], errors[i], truths[i]});
  }
  ExplainByMargin(off);
  std::vector<Cause> causes;
  for (const Finding& finding : findings) causes.push_back(finding.cause);
  return causes;
}

TEST(Margin, IsOneErrorInThreeDifferentQuestions) {
  const Cause margin = Cause::kConvention;
  EXPECT_THAT(Margins({-0.04, -0.04, 0.01, -0.04}, {-0.1, 0.2, -0.3, 0.7}),
              testing::ElementsAre(margin, margin, Cause::kNone, margin));
}

TEST(Margin, IsNotSeenInTwoQuestionsOrInOneAskedThrice) {
  EXPECT_THAT(Margins({-0.04, -0.04}, {-0.1, 0.2}), testing::Each(Cause::kNone));
  EXPECT_THAT(Margins({-0.04, -0.04, -0.04}, {-0.1, -0.1, -0.1}),
              testing::Each(Cause::kNone));
}

TEST(Margin, IsNotSeenInErrorsThatDiffer) {
  EXPECT_THAT(Margins({-0.04, -0.0401, -0.0402}, {-0.1, 0.2, 0.3}),
              testing::Each(Cause::kNone));
}

}  // namespace
}  // namespace touchstone
