#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reports/contacts/body_size.h"
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
  all.reserve(findings.size());
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

bool MayBeRounding(MeasureKind measure, std::string reference, double depth,
                   Cause cause = Cause::kNone) {
  const Specimen s = BoxOnBoxFace(depth);
  Finding finding = Failure(measure, 3e-4);
  finding.reference = std::move(reference);
  finding.cause = cause;
  return RoundingMayExplain(finding, s.query, s.truth, 0x1p-53);
}

TEST(Precision, IsNoExcuseForALengthUnlessTheBodiesTouch) {
  for (const MeasureKind measure :
       {MeasureKind::kSeparationError, MeasureKind::kTouching, MeasureKind::kExcess}) {
    EXPECT_FALSE(MayBeRounding(measure, "referee", kDepth));
    EXPECT_FALSE(MayBeRounding(measure, "referee", -kDepth));
    EXPECT_TRUE(MayBeRounding(measure, "referee", 1e-16));
  }
}

TEST(Precision, MayExplainWhatJumpsWithThePatch) {
  EXPECT_TRUE(MayBeRounding(MeasureKind::kContactOffPatch, "referee", kDepth));
  EXPECT_TRUE(MayBeRounding(MeasureKind::kContactCount, "referee", kDepth));
  EXPECT_FALSE(
      MayBeRounding(MeasureKind::kContactCount, "referee", kDepth, Cause::kConvention));
}

TEST(Precision, ExplainsNoDifferenceOfTwoAnswers) {
  EXPECT_FALSE(MayBeRounding(MeasureKind::kSwap, "", 1e-16));
}

/** Returns the question how two cubes of 2 m overlap: by 0.1 m along x, and by `overlap`
 along y. [m] */
ContactQuery CubesOnOneAnother(double overlap) {
  const Shape cube = Box{Eigen::Vector3d::Ones()};
  const Eigen::Vector3d p_WB(1.9, 2 - overlap, 0);
  return {{cube, Pose{}}, {cube, Pose::FromMatrix(p_WB, Eigen::Matrix3d::Identity())}};
}

/** Returns the causes of all failures of the answer that is right where the cubes overlap
 by 0.0999 m along y, if they overlap by 0.1003 m and a neighbour by `overlap`. */
std::vector<Cause> CausesNear(double overlap) {
  FakeOracle oracle("mine");
  oracle.ForEachPair([](Capability& capability) { capability.manifold = false; });
  ContactAnswer answer = RightAnswer(CubesOnOneAnother(0.0999));
  answer.points.clear();
  Scenario scenario;
  scenario.id = "contact/cubes";
  scenario.contact = CubesOnOneAnother(0.1003);
  std::vector<Finding> findings =
      JudgeAnswer(scenario, ComputeContactTruth(scenario.contact), oracle.info(), answer);
  const ContactQuery neighbour = CubesOnOneAnother(overlap);
  const ContactTruth truth = ComputeContactTruth(neighbour);
  ExplainByRounding(scenario, oracle.info(), answer, std::span(&neighbour, 1),
                    std::span(&truth, 1), findings);
  std::vector<Cause> causes;
  for (const Finding& finding : findings)
    if (IsProvedWrong(finding)) causes.push_back(finding.cause);
  return causes;
}

TEST(Precision, IsTheCauseIfTheWholeAnswerIsRightForANeighbour) {
  EXPECT_THAT(CausesNear(0.0999), testing::AllOf(testing::Not(testing::IsEmpty()),
                                                 testing::Each(Cause::kPrecision)));
  EXPECT_THAT(CausesNear(0.1), testing::AllOf(testing::Not(testing::IsEmpty()),
                                              testing::Each(Cause::kNone)));
}

/** Returns the causes found for separations of shapes of different sizes that are off by
 `errors` in questions with `truths`; `passes` are errors of passing ones. */
std::vector<Cause> Margins(std::vector<double> errors, std::vector<double> truths,
                           const std::vector<double>& passes = {},
                           bool one_size = false) {
  std::vector<Finding> findings(errors.size() + passes.size());
  std::vector<SignedError> off;
  std::vector<SignedError> passed;
  for (std::size_t i = 0; i < findings.size(); ++i) {
    const bool fails = i < errors.size();
    const double error = fails ? errors[i] : passes[i - errors.size()];
    findings[i] = Failure(MeasureKind::kSeparationError, std::abs(error));
    findings[i].tolerance = 1e-12;
    (fails ? off : passed)
        .push_back({&findings[i], error, fails ? truths[i] : 0.5,
                    one_size ? "1" : std::to_string(i)});
  }
  ExplainByMargin(off, passed);
  std::vector<Cause> causes;
  for (std::size_t i = 0; i < errors.size(); ++i) causes.push_back(findings[i].cause);
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

TEST(Margin, IsNotSeenInShapesOfOneSizeOrIfAnExactAnswerContradictsIt) {
  const std::vector<double> errors = {-0.04, -0.04, -0.04};
  const std::vector<double> truths = {-0.1, 0.2, 0.7};
  EXPECT_THAT(Margins(errors, truths, {}, true), testing::Each(Cause::kNone));
  EXPECT_THAT(Margins(errors, truths, {1e-13}), testing::Each(Cause::kNone));
  EXPECT_THAT(Margins(errors, truths), testing::Each(Cause::kConvention));
}

}  // namespace
}  // namespace touchstone
