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

/** Returns what rounding says about the failure `measure`, by `error`, of an answer to a
 specimen, if its neighbours are answered by `neighbours` and have the truth of the
 specimen moved by `truth_moves`. [m] */
std::optional<Explanation> ByRounding(const Specimen& s, const ContactAnswer& answer,
                                      MeasureKind measure, std::string reference,
                                      const std::vector<ContactAnswer>& neighbours,
                                      double truth_moves = 0, double error = 3e-4) {
  const FakeOracle oracle("mine");
  Scenario scenario;
  scenario.id = "contact/specimen";
  scenario.contact = s.query;
  ContactTruth moved = s.truth;
  moved.separation.lo += truth_moves;
  moved.separation.hi += truth_moves;
  const std::vector<ContactQuery> queries(neighbours.size(), s.query);
  const std::vector<ContactTruth> truths(neighbours.size(), moved);
  Finding finding = Failure(measure, error);
  finding.reference = std::move(reference);
  return ExplanationByRounding(finding, s.query, s.truth, answer,
                               Judged(scenario, oracle.info(), queries, truths,
                                      neighbours, std::span(&finding, 1)),
                               0x1p-53);
}

/** As ByRounding(), but returns only why the cause is `precision`. */
std::optional<std::string> Precision(const Specimen& s, const ContactAnswer& answer,
                                     MeasureKind measure, std::string reference,
                                     const std::vector<ContactAnswer>& neighbours,
                                     double truth_moves = 0) {
  const auto why =
      ByRounding(s, answer, measure, std::move(reference), neighbours, truth_moves);
  if (!why || why->cause != Cause::kPrecision) return std::nullopt;
  return why->because;
}

TEST(Precision, ExplainsAnErrorIfANeighbourIsAnsweredRightly) {
  const Specimen s = BoxOnBoxFace(kDepth);
  ContactAnswer wrong = s.right;
  *wrong.separation -= 3e-4;
  const auto why =
      Precision(s, wrong, MeasureKind::kSeparationError, "referee", {wrong, s.right});
  EXPECT_THAT(why.value(),
              HasSubstr("4 roundings of 2^-53 on its input make its answer right"));
}

TEST(Precision, DoesNotExplainAnErrorThatStaysOrOneThatMovesToAnother) {
  const Specimen s = BoxOnBoxFace(kDepth);
  ContactAnswer wrong = s.right;
  *wrong.separation -= 3e-4;
  ContactAnswer as_wrong = s.right;
  *as_wrong.separation += 3e-4;
  for (const ContactAnswer& neighbour : {wrong, as_wrong}) {
    EXPECT_EQ(Precision(s, wrong, MeasureKind::kSeparationError, "referee", {neighbour}),
              std::nullopt);
  }
}

TEST(Precision, ExplainsAnErrorIfRoundingMovesTheTruthAsFar) {
  const Specimen s = BoxOnBoxFace(kDepth);
  ContactAnswer wrong = s.right;
  *wrong.separation -= 3e-4;
  const auto why =
      Precision(s, wrong, MeasureKind::kSeparationError, "referee", {wrong}, 2e-4);
  EXPECT_THAT(why.value(), HasSubstr("move the truth by 0.0002 m"));
  EXPECT_EQ(Precision(s, wrong, MeasureKind::kSeparationError, "referee", {wrong}, 1e-4),
            std::nullopt);
}

TEST(Precision, IsNoExcuseForAGrossErrorAtATie) {
  const Specimen s = BoxOnBoxFace(kDepth);
  const double gross = 0.2 * SmallerExtent(s.query);
  ContactAnswer wrong = s.right;
  *wrong.separation -= gross;
  const auto why = ByRounding(s, wrong, MeasureKind::kSeparationError, "referee",
                              {wrong, s.right}, 0, gross);
  EXPECT_EQ(why.value().cause, Cause::kDefect);
  EXPECT_THAT(why->because, HasSubstr("not that it errs by"));
  // Unless the truth itself is as uncertain.
  EXPECT_EQ(ByRounding(s, wrong, MeasureKind::kSeparationError, "referee",
                       {wrong, s.right}, 0.6 * gross, gross)
                .value()
                .cause,
            Cause::kPrecision);
  // The patch of flush faces jumps at a rounding, so an answer may, too.
  EXPECT_EQ(ByRounding(s, wrong, MeasureKind::kContactOffPatch, "referee",
                       {wrong, s.right}, 0, gross)
                .value()
                .cause,
            Cause::kPrecision);
  // At a tie another answer may be as right, so a comparison proves nothing gross.
  EXPECT_EQ(
      ByRounding(s, wrong, MeasureKind::kSwap, "", {s.right}, 0, gross).value().cause,
      Cause::kPrecision);
}

TEST(Precision, IsNoExcuseForAMissOfADeepOverlap) {
  const Specimen s = BoxOnBoxFace(0.4);
  ContactAnswer missed = s.right;
  missed.touching = false;
  ASSERT_GT(-s.truth.separation.hi, 0.1 * SmallerExtent(s.query));
  EXPECT_EQ(
      ByRounding(s, missed, MeasureKind::kTouching, "referee", {s.right}).value().cause,
      Cause::kDefect);
}

TEST(Precision, ExplainsATouchingVerdictThatBecomesRight) {
  const Specimen s = BoxOnBoxFace(kDepth);
  ContactAnswer missed = s.right;
  missed.touching = false;
  EXPECT_NE(Precision(s, missed, MeasureKind::kTouching, "referee", {s.right}),
            std::nullopt);
  EXPECT_EQ(Precision(s, missed, MeasureKind::kTouching, "referee", {missed}),
            std::nullopt);
}

TEST(Precision, ExplainsAVariantIfTheAnswerMovesAsFarToARightOne) {
  const Specimen s = BoxOnBoxFace(kDepth);
  ContactAnswer off = s.right;
  *off.separation -= 3e-4;
  EXPECT_THAT(Precision(s, off, MeasureKind::kSwap, "", {s.right}).value(),
              HasSubstr("move its answer by 0.0003 m, to a right one"));
  EXPECT_EQ(Precision(s, s.right, MeasureKind::kSwap, "", {off}), std::nullopt);
}

TEST(Precision, LearnsNothingFromNeighboursWithoutAUsableAnswer) {
  const Specimen s = BoxOnBoxFace(kDepth);
  ContactAnswer wrong = s.right;
  *wrong.separation -= 3e-4;
  ContactAnswer broken = s.right;
  broken.n_AB_W->setZero();
  ContactAnswer crashed;
  crashed.status = AnswerStatus::kCrashed;
  ContactAnswer nan = s.right;
  nan.separation = NAN;
  for (const std::string reference : {"referee", ""}) {
    EXPECT_EQ(Precision(s, wrong, MeasureKind::kSeparationError, reference,
                        {broken, crashed, nan}),
              std::nullopt);
  }
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
