#include "reports/contacts/judge_answer.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "oracles/stated_tolerance.h"
#include "reports/finding/decisive.h"
#include "reports/referee/referee.h"
#include "tests/reports/fake_oracle.h"
#include "tests/reports/specimens.h"

namespace touchstone {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

constexpr double kDepth = 2e-3;  // [m]

std::vector<Finding> Judged(const ContactQuery& query, const ContactAnswer& answer,
                            const FakeOracle& oracle = FakeOracle("mine")) {
  Scenario scenario;
  scenario.id = "contact/specimen";
  scenario.contact = query;
  return JudgeAnswer(scenario, ComputeContactTruth(query), oracle.info(), answer);
}

const Finding& Of(MeasureKind measure, const std::vector<Finding>& findings) {
  for (const Finding& finding : findings) {
    if (finding.measure == measure) return finding;
  }
  static const Finding none{};
  ADD_FAILURE() << NameOf(measure) << " does not apply";
  return none;
}

std::vector<MeasureKind> Failed(const std::vector<Finding>& findings) {
  std::vector<MeasureKind> failed;
  for (const Finding& finding : findings) {
    if (finding.verdict != Verdict::kPass) failed.push_back(finding.measure);
  }
  return failed;
}

// Sweeps ask for fewer sentences, and the search for causes for none.
TEST(Judge, FindsTheSameWithFewerSentences) {
  const FakeOracle oracle("mine");
  for (const Specimen& s :
       {SphereInBoxFace(kDepth), BoxOnBoxFace(kDepth), SphereInBoxFace(-kDepth)}) {
    Scenario scenario;
    scenario.id = "contact/specimen";
    scenario.contact = s.query;
    ContactAnswer wrong = s.right;
    wrong.touching = !wrong.touching;
    wrong.separation = 2 * *wrong.separation;
    wrong.points.resize(std::min<std::size_t>(wrong.points.size(), 1));
    for (const ContactAnswer& answer : {s.right, wrong}) {
      const auto judged = [&](Reasons reasons) {
        return JudgeAnswer(scenario, s.truth, oracle.info(), answer, reasons);
      };
      const std::vector<Finding> all = judged(Reasons::kOfAll);
      for (const Reasons reasons : {Reasons::kNoneButProofs, Reasons::kNone}) {
        const std::vector<Finding> fewer = judged(reasons);
        ASSERT_EQ(fewer.size(), all.size());
        for (std::size_t i = 0; i < all.size(); ++i) {
          EXPECT_EQ(fewer[i].measure, all[i].measure);
          EXPECT_EQ(fewer[i].verdict, all[i].verdict);
          EXPECT_EQ(fewer[i].value, all[i].value);
          EXPECT_EQ(fewer[i].tolerance, all[i].tolerance);
          EXPECT_EQ(fewer[i].grade, all[i].grade);
          EXPECT_EQ(fewer[i].safety, all[i].safety);
          EXPECT_EQ(fewer[i].tolerance_because, "");
          EXPECT_EQ(fewer[i].proof, reasons == Reasons::kNone ? "" : all[i].proof);
        }
      }
    }
  }
}

TEST(Judge, PassesAnswersDerivedByHand) {
  for (const double depth : {kDepth, -kDepth}) {
    for (const Specimen& s :
         {SphereInBoxFace(depth), BoxOnBoxFace(depth), SphereInHalfSpace(depth)}) {
      const std::vector<Finding> findings = Judged(s.query, s.right);
      EXPECT_THAT(Failed(findings), testing::IsEmpty());
      EXPECT_GE(findings.size(), 6U);
      for (const Finding& finding : findings) EXPECT_EQ(finding.proof, "");
    }
  }
}

TEST(Judge, AppliesEveryMeasureToATouchingManifold) {
  const Specimen s = BoxOnBoxFace(kDepth);
  std::vector<MeasureKind> applied;
  for (const Finding& f : Judged(s.query, s.right)) applied.push_back(f.measure);
  EXPECT_THAT(applied,
              testing::UnorderedElementsAre(
                  MeasureKind::kTouching, MeasureKind::kSeparationError,
                  MeasureKind::kConsistencyError, MeasureKind::kExcess,
                  MeasureKind::kContactSurfaceError, MeasureKind::kContactOffPatch,
                  MeasureKind::kPatchCoverage, MeasureKind::kContactCount,
                  MeasureKind::kContactTooDeep, MeasureKind::kContactSeparationError,
                  MeasureKind::kMixedNormals, MeasureKind::kAnswering));
}

// The patch needs the normal and the points to be judged, which it is not asked for.
TEST(Judge, ProvesAMissedContactByAPointInsideBoth) {
  Specimen s = BoxOnBoxFace(kDepth);
  s.right.touching = false;
  s.right.points.clear();
  const Finding touching = Of(MeasureKind::kTouching, Judged(s.query, s.right));
  EXPECT_EQ(touching.verdict, Verdict::kFail);
  EXPECT_EQ(touching.reference, "referee");
  // Midway through the overlap.
  EXPECT_THAT(touching.proof, StartsWith("mine says apart; the point ("));
  EXPECT_THAT(touching.proof, HasSubstr("lies 0.001 m inside both."));
}

TEST(Judge, ProvesAPhantomContactByASeparatingPlane) {
  Specimen s = SphereInBoxFace(-kDepth);
  s.right.touching = true;
  s.right.points = {{s.right.witnesses->p_WCa, kDepth, {}}};
  const Finding touching = Of(MeasureKind::kTouching, Judged(s.query, s.right));
  EXPECT_EQ(touching.verdict, Verdict::kFail);
  EXPECT_THAT(touching.proof, StartsWith("mine says they touch; the plane n·x = "));
  EXPECT_THAT(touching.proof, HasSubstr("separates them by 0.002 m"));
}

TEST(Judge, ProvesATooLargeDepthByAShorterTranslation) {
  Specimen s = SphereInBoxFace(kDepth);
  s.right.separation = -3 * kDepth;
  const Finding finding = Of(MeasureKind::kSeparationError, Judged(s.query, s.right));
  EXPECT_EQ(finding.verdict, Verdict::kFail);
  EXPECT_NEAR(finding.value, 2 * kDepth, 1e-12);
  EXPECT_THAT(finding.proof,
              StartsWith("mine says 0.006 m deep; moving B by 0.002 m along ("));
  EXPECT_GT(finding.tolerance, 0);
  EXPECT_THAT(finding.tolerance_because, StartsWith("64 roundings of 2^-53"));
}

TEST(Judge, ProvesATooSmallDepthByTheOverlapLeft) {
  Specimen s = SphereInBoxFace(kDepth);
  s.right.separation = -kDepth / 2;
  const Finding finding = Of(MeasureKind::kSeparationError, Judged(s.query, s.right));
  EXPECT_EQ(finding.verdict, Verdict::kFail);
  EXPECT_THAT(
      finding.proof,
      HasSubstr("no translation shorter than 0.002 m separates them, 0.001 m more"));
  EXPECT_THAT(finding.proof, HasSubstr("leaves an overlap of 0.001 m"));
}

TEST(Judge, ProvesAnErrorInTheLastDigitsWithNumbersThatDiffer) {
  Specimen s = SphereInBoxFace(kDepth);
  s.right.separation = -kDepth - 1.5e-12;
  const std::vector<Finding> findings = Judged(s.query, s.right);
  EXPECT_THAT(Of(MeasureKind::kSeparationError, findings).proof,
              AllOf(StartsWith("mine says 0.0020000000015 m deep; moving B by 0.002 m "),
                    HasSubstr(" separates them, 1.5e-12 m less.")));
  EXPECT_THAT(Of(MeasureKind::kConsistencyError, findings).proof,
              AllOf(StartsWith("mine says 0.0020000000015 m along ("),
                    HasSubstr("the overlap along it is 0.002 m, 1.5e-12 m less.")));
}

TEST(Judge, ProvesATooLargeDistanceByTwoPoints) {
  Specimen s = SphereInBoxFace(-kDepth);
  s.right.separation = 2 * kDepth;
  const Finding finding = Of(MeasureKind::kSeparationError, Judged(s.query, s.right));
  EXPECT_THAT(finding.proof, HasSubstr("says 0.004 m apart; the point ("));
  EXPECT_THAT(finding.proof, HasSubstr("are 0.002 m apart, 0.002 m less."));
}

TEST(Judge, FindsAFlippedNormalByItsExcessAndInconsistency) {
  Specimen s = SphereInBoxFace(kDepth);
  *s.right.n_AB_W *= -1;
  const std::vector<Finding> findings = Judged(s.query, s.right);
  EXPECT_THAT(Failed(findings), testing::UnorderedElementsAre(
                                    MeasureKind::kExcess, MeasureKind::kConsistencyError,
                                    MeasureKind::kContactSurfaceError));
  EXPECT_THAT(Of(MeasureKind::kExcess, findings).proof,
              HasSubstr("moving B by 0.002 m along ("));
}

// If the normal is tilted by θ, the overlap of the faces grows by their lever times θ.
TEST(Judge, AllowsANormalTwiceTheRoundingOfADepth) {
  const Specimen s = BoxOnBoxFace(kDepth);
  const auto excess_of = [&](double tilt) {
    ContactAnswer answer = s.right;
    answer.n_AB_W =
        s.query.A.X_WB.R_WB * Eigen::Vector3d(std::sin(tilt), 0, std::cos(tilt));
    return Of(MeasureKind::kExcess, Judged(s.query, answer));
  };
  const double rounding =
      Of(MeasureKind::kSeparationError, Judged(s.query, s.right)).tolerance;
  const double lever = excess_of(1e-6).value / 1e-6;
  EXPECT_EQ(excess_of(1.9 * rounding / lever).verdict, Verdict::kPass);
  EXPECT_EQ(excess_of(2.1 * rounding / lever).verdict, Verdict::kFail);
}

TEST(Judge, FindsAContactOnASurface) {
  Specimen s = SphereInBoxFace(kDepth);
  s.right.points[0].p_WC += *s.right.n_AB_W * (kDepth / 2);
  EXPECT_THAT(Failed(Judged(s.query, s.right)),
              testing::ElementsAre(MeasureKind::kContactSurfaceError));
}

TEST(Judge, FindsAContactOffThePatch) {
  Specimen s = BoxOnBoxFace(kDepth);
  s.right.points[0].p_WC += 0.01 * s.query.B.X_WB.R_WB.col(0);
  EXPECT_THAT(Failed(Judged(s.query, s.right)),
              testing::Contains(MeasureKind::kContactOffPatch));
}

TEST(Judge, FindsMissingAndRepeatedContacts) {
  Specimen s = BoxOnBoxFace(kDepth);
  s.right.points.resize(1);
  EXPECT_THAT(
      Failed(Judged(s.query, s.right)),
      testing::ElementsAre(MeasureKind::kPatchCoverage, MeasureKind::kContactCount));
  s = BoxOnBoxFace(kDepth);
  s.right.points.push_back(s.right.points[1]);
  EXPECT_THAT(Failed(Judged(s.query, s.right)),
              testing::ElementsAre(MeasureKind::kContactCount));
}

// Half a depth weighs more than five contacts too many.
TEST(Judge, LetsALengthDecideBeforeANumberOfContacts) {
  Specimen s = BoxOnBoxFace(kDepth);
  for (int i = 0; i < 5; ++i) s.right.points.push_back(s.right.points[1]);
  for (ContactPoint& contact : s.right.points) contact.separation /= 2;
  *s.right.separation /= 2;
  const std::vector<Finding> findings = Judged(s.query, s.right);
  const Finding count = Of(MeasureKind::kContactCount, findings);
  EXPECT_EQ(count.verdict, Verdict::kFail);
  EXPECT_EQ(count.value, 5);
  EXPECT_EQ(count.grade, Grade::kLarge);
  EXPECT_EQ(DecisiveOf(findings)->measure, MeasureKind::kSeparationError);
}

// The proof names a point that the contacts leave out and both bodies reach.
TEST(Judge, ProvesAMissingContactByAPointOfBothBodies) {
  Specimen s = BoxOnBoxFace(kDepth);
  const Eigen::Vector3d missed = s.right.points[2].p_WC;
  s.right.points.erase(s.right.points.begin() + 2);
  const Finding finding = Of(MeasureKind::kPatchCoverage, Judged(s.query, s.right));
  const std::string before = "both bodies reach as deep at (";
  const std::size_t at = finding.proof.find(before);
  ASSERT_NE(at, std::string::npos) << finding.proof;
  Eigen::Vector3d p_W;
  ASSERT_EQ(std::sscanf(finding.proof.c_str() + at + before.size(), "%lf, %lf, %lf",
                        &p_W.x(), &p_W.y(), &p_W.z()),
            3);
  EXPECT_LE((p_W - missed).norm(), 1e-13);
}

// The polygon around a disc has its corners outside the disc.
TEST(Judge, FindsMissingContactsOfADisc) {
  const Pose X_WA = AwkwardPose();
  Specimen s;
  s.query = {{Box{{0.3, 0.2, 0.1}}, X_WA},
             {Cylinder{0.08, 0.2}, Placed(X_WA, {0.01, 0.02, 0.3 - kDepth})}};
  s.right.status = AnswerStatus::kAnswered;
  s.right.touching = true;
  s.right.n_AB_W = X_WA.R_WB.col(2);
  s.right.separation = -kDepth;
  for (const double third : {0, 1, 2}) {
    const double angle = third * 2 * M_PI / 3;
    const Eigen::Vector3d p_A(0.01 + 0.08 * std::cos(angle),
                              0.02 + 0.08 * std::sin(angle), 0.1 - kDepth / 2);
    s.right.points.push_back({X_WA * p_A, -kDepth, {}});
  }
  EXPECT_THAT(Failed(Judged(s.query, s.right)), testing::IsEmpty());
  s.right.points.pop_back();
  EXPECT_THAT(
      Failed(Judged(s.query, s.right)),
      testing::ElementsAre(MeasureKind::kPatchCoverage, MeasureKind::kContactCount));
}

// The patch is a lens between two discs. The polygons around them are 2 % wider than the
// discs, so a narrow lens has no corner between its tips that both bodies reach.
TEST(Judge, LeavesACountOpenWhereNoCertifiedPointIsMissed) {
  constexpr double r = 0.1;
  const Pose X_WA = AwkwardPose();
  int open = 0;
  for (const double half_width : {0.06 * r, 0.08 * r, 0.1 * r, 0.12 * r}) {
    Specimen s;
    s.query = {{Cylinder{r, 0.2}, X_WA},
               {Cylinder{r, 0.2}, Placed(X_WA, {2 * (r - half_width), 0, 0.4 - kDepth})}};
    s.right.status = AnswerStatus::kAnswered;
    s.right.touching = true;
    s.right.n_AB_W = X_WA.R_WB.col(2);
    s.right.separation = -kDepth;
    const double x = r - half_width;
    for (const double sign : {-1, 1}) {
      const Eigen::Vector3d tip(x, sign * std::sqrt(r * r - x * x), 0.2 - kDepth / 2);
      s.right.points.push_back({X_WA * tip, -kDepth, {}});
    }
    const std::vector<Finding> findings = Judged(s.query, s.right);
    if (Of(MeasureKind::kPatchCoverage, findings).verdict != Verdict::kUndecidable)
      continue;
    ++open;
    EXPECT_EQ(Of(MeasureKind::kContactCount, findings).verdict, Verdict::kUndecidable)
        << half_width;
  }
  EXPECT_GT(open, 0);
}

/** Returns the findings on a float engine's answer to `s`, whose normal is off by a
 rounding or two. */
std::vector<Finding> JudgedAsFloat(const Specimen& s) {
  FakeOracle coarse("mine");
  coarse.info().unit_roundoff = 0x1p-24;
  ContactAnswer answer = s.right;
  answer.n_AB_W = Eigen::AngleAxisd(1e-7, s.query.A.X_WB.R_WB.col(0)) * *answer.n_AB_W;
  return Judged(s.query, answer, coarse);
}

TEST(Judge, FindsMissingContactsOfAFloatEngineWhoseNormalIsRounded) {
  Specimen s = BoxOnBoxFace(kDepth);
  EXPECT_THAT(Failed(JudgedAsFloat(s)), testing::IsEmpty());
  s.right.points.resize(1);
  EXPECT_THAT(Failed(JudgedAsFloat(s)), testing::ElementsAre(MeasureKind::kPatchCoverage,
                                                             MeasureKind::kContactCount));
}

// If the question tilts the face by 1e-8, the patch is the deepest corner, which a float
// engine cannot know.
TEST(Judge, AllowsOneContactWhereTheQuestionTiltsAFace) {
  Specimen s = BoxOnBoxFace(kDepth);
  const Eigen::Matrix3d tilt =
      Eigen::AngleAxisd(1e-8, Eigen::Vector3d(1, 2, 0).normalized()).toRotationMatrix();
  Pose& X_WB = s.query.B.X_WB;
  X_WB = Pose::FromMatrix(X_WB.p_WB, X_WB.R_WB * tilt);
  s.right.points.resize(1);
  EXPECT_THAT(Failed(JudgedAsFloat(s)), testing::IsEmpty());
}

TEST(Judge, FindsAContactTooDeepAndAllowsAShallowOne) {
  Specimen s = BoxOnBoxFace(kDepth);
  s.right.points[0].separation = -2 * kDepth;
  EXPECT_THAT(Failed(Judged(s.query, s.right)),
              testing::Contains(MeasureKind::kContactTooDeep));
  s = BoxOnBoxFace(kDepth);
  // This is a contact of a tilted manifold: half as deep, with its two surface points
  // half as far apart.
  s.right.points[0].separation = -kDepth / 2;
  EXPECT_THAT(Failed(Judged(s.query, s.right)),
              testing::Not(testing::Contains(MeasureKind::kContactTooDeep)));
}

TEST(Judge, FindsAManifoldThatIsNowhereAsDeepAsTheAnswerSays) {
  Specimen s = BoxOnBoxFace(kDepth);
  const Eigen::Vector3d n = *s.right.n_AB_W;
  // On the rim of the overlap: each contact lies on the top of A and on a side of B.
  for (ContactPoint& contact : s.right.points) {
    contact.p_WC += n * (kDepth / 2);
    contact.separation = 0;
  }
  const std::vector<Finding> findings = Judged(s.query, s.right);
  // The point of each contact on B lies on B's side, and B extends further down.
  EXPECT_THAT(Failed(findings),
              testing::ElementsAre(MeasureKind::kConsistencyError,
                                   MeasureKind::kContactSeparationError));
  EXPECT_NEAR(Of(MeasureKind::kContactSeparationError, findings).value, kDepth, 1e-6);
  const Finding finding = Of(MeasureKind::kConsistencyError, findings);
  EXPECT_NEAR(finding.value, kDepth, 1e-12);
  EXPECT_THAT(finding.proof,
              AllOf(StartsWith("mine says a separation of -0.002 m; that of its deepest "
                               "contact, at ("),
                    HasSubstr("), is 0 m: a difference of 0.002 m.")));
}

TEST(Judge, AllowsContactsShallowerThanTheDeepest) {
  Specimen s = BoxOnBoxFace(kDepth);
  s.right.points[0].p_WC += *s.right.n_AB_W * (kDepth / 2);
  s.right.points[0].separation = 0;
  EXPECT_THAT(Failed(Judged(s.query, s.right)),
              testing::Not(testing::Contains(MeasureKind::kConsistencyError)));
}

TEST(Judge, FindsMixedNormals) {
  Specimen s = BoxOnBoxFace(kDepth);
  s.right.points[2].n_AB_W =
      s.query.A.X_WB.R_WB * Eigen::Vector3d(std::sin(1e-6), 0, std::cos(1e-6));
  const Finding finding = Of(MeasureKind::kMixedNormals, Judged(s.query, s.right));
  EXPECT_EQ(finding.verdict, Verdict::kFail);
  EXPECT_NEAR(finding.value, 1e-6, 1e-12);
}

TEST(Judge, CallsNanInvalidAndJudgesNoFurther) {
  Specimen s = BoxOnBoxFace(kDepth);
  s.right.separation = NAN;
  const std::vector<Finding> findings = Judged(s.query, s.right);
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0].measure, MeasureKind::kAnswering);
  EXPECT_EQ(findings[0].verdict, Verdict::kInvalid);
  EXPECT_EQ(findings[0].proof, "mine: separation is nan.");
}

TEST(Judge, CallsAnAnswerWithoutAPromisedFieldInvalid) {
  Specimen s = BoxOnBoxFace(kDepth);
  s.right.points.clear();
  const std::vector<Finding> findings = Judged(s.query, s.right);
  EXPECT_EQ(Of(MeasureKind::kTouching, findings).verdict, Verdict::kPass);
  EXPECT_EQ(Of(MeasureKind::kAnswering, findings).proof,
            "mine: touching, without a contact.");
  FakeOracle modest("mine");
  modest.ForEachPair([](Capability& capability) { capability.manifold = false; });
  EXPECT_THAT(Failed(Judged(s.query, s.right, modest)), testing::IsEmpty());
}

TEST(Judge, QuotesTheReasonForAMissingAnswer) {
  const Specimen s = BoxOnBoxFace(kDepth);
  for (const auto& [status, verdict] :
       {std::pair(AnswerStatus::kCrashed, Verdict::kCrashed),
        std::pair(AnswerStatus::kTimedOut, Verdict::kTimedOut),
        std::pair(AnswerStatus::kUnsupported, Verdict::kUnsupported)}) {
    ContactAnswer answer;
    answer.status = status;
    answer.reason = "it said so";
    const std::vector<Finding> findings = Judged(s.query, answer);
    ASSERT_EQ(findings.size(), 1U);
    EXPECT_EQ(findings[0].verdict, verdict);
    EXPECT_EQ(findings[0].proof, "mine: it said so.");
    EXPECT_EQ(findings[0].grade, IsUnusable(verdict) ? Grade::kUnusable : Grade::kNone);
  }
}

// The plane x = 1e100 of the box cuts the sphere at its centre. The overlap is 1 m,
// although the squares of 1e100 overflow in the computation.
TEST(Judge, ProvesNothingWrongWhereDoublesOverflow) {
  const ContactQuery query{
      {Box{Eigen::Vector3d::Constant(1e100)}, Pose{}},
      {Sphere{1}, Pose::FromMatrix({1e100, 0, 0}, Eigen::Matrix3d::Identity())}};
  ContactAnswer answer;
  answer.status = AnswerStatus::kAnswered;
  answer.touching = true;
  answer.separation = -1;
  answer.n_AB_W = Eigen::Vector3d::UnitX();
  answer.points = {{{1e100, 0, 0}, -1, std::nullopt}};
  for (const Finding& finding : Judged(query, answer)) {
    EXPECT_NE(finding.verdict, Verdict::kFail) << NameOf(finding.measure);
  }
}

// A cylinder of radius and half length 1 leans by θ about y, 0.1 deep in the half-space.
// A point of its rim at the angle φ from the deepest point is sin θ (1 − cos φ) less
// deep: 1e-14 m for θ = 1e-5 and φ = 4.5e-5, which no engine can distinguish from the
// deepest.
TEST(Judge, AcceptsAContactAnywhereOnARimThatIsDeepestToRounding) {
  const double lean = 1e-5;
  const double phi = 4.5e-5;
  const double depth = 0.1;
  const Eigen::Matrix3d R(Eigen::AngleAxisd(lean, Eigen::Vector3d::UnitY()));
  const Eigen::Vector3d p(0.3, -0.2, std::sin(lean) + std::cos(lean) - depth);
  const ContactQuery query{{HalfSpace{}, Pose{}},
                           {Cylinder{1, 1}, Pose::FromMatrix(p, R)}};
  ContactAnswer answer;
  answer.status = AnswerStatus::kAnswered;
  answer.touching = true;
  answer.separation = -depth;
  answer.n_AB_W = Eigen::Vector3d::UnitZ();
  const Eigen::Vector3d rim = p + R * Eigen::Vector3d(std::cos(phi), std::sin(phi), -1);
  answer.points = {{{rim.x(), rim.y(), rim.z() / 2}, rim.z(), std::nullopt}};
  EXPECT_THAT(Failed(Judged(query, answer)), testing::IsEmpty());
  answer.points[0].p_WC.y() += 0.1;
  EXPECT_THAT(Failed(Judged(query, answer)), testing::Not(testing::IsEmpty()));
}

TEST(Judge, IsUndecidedWhereBodiesTouchToARounding) {
  Specimen s = SphereInBoxFace(0);
  for (const bool touching : {false, true}) {
    ContactAnswer answer = s.right;
    answer.touching = touching;
    answer.points.clear();
    if (touching) answer.points = {{s.truth.certificate.p_WCa, 0, {}}};
    const std::vector<Finding> findings = Judged(s.query, answer);
    EXPECT_EQ(Of(MeasureKind::kTouching, findings).verdict, Verdict::kUndecidable);
    EXPECT_THAT(Failed(findings), testing::ElementsAre(MeasureKind::kTouching));
  }
}

TEST(Judge, AllowsAFloatEngineItsOwnRounding) {
  // A gap of 1e-7 m in a scene of 1.4 m is below 64 roundings of 2^-24, 5e-6 m.
  Specimen s = SphereInBoxFace(-1e-7);
  s.right.touching = true;
  s.right.separation = 0;
  s.right.points = {{s.right.witnesses->p_WCa, 0, {}}};
  s.right.witnesses.reset();
  FakeOracle coarse("mine");
  coarse.info().unit_roundoff = 0x1p-24;
  EXPECT_THAT(Failed(Judged(s.query, s.right, coarse)),
              testing::ElementsAre(MeasureKind::kTouching));
  EXPECT_EQ(Of(MeasureKind::kTouching, Judged(s.query, s.right, coarse)).verdict,
            Verdict::kUndecidable);
  EXPECT_EQ(Of(MeasureKind::kTouching, Judged(s.query, s.right)).verdict, Verdict::kFail);
}

TEST(Judge, PassesOnlyValuesNearTheWholeEnclosure) {
  const Specimen s = SphereInBoxFace(kDepth);
  Scenario scenario;
  scenario.id = "contact/specimen";
  scenario.contact = s.query;
  const FakeOracle oracle("mine");
  const auto judged = [&](double narrower, double wider, double separation) {
    ContactTruth truth = ComputeContactTruth(s.query);
    truth.separation = {-kDepth - wider, -kDepth + narrower};
    ContactAnswer answer = s.right;
    answer.separation = separation;
    answer.points[0].separation = separation;
    return JudgeAnswer(scenario, truth, oracle.info(), answer);
  };
  const auto verdict = [&](MeasureKind measure, const std::vector<Finding>& findings) {
    return Of(measure, findings).verdict;
  };
  const double e = Of(MeasureKind::kSeparationError, Judged(s.query, s.right)).tolerance;
  std::vector<Finding> findings = judged(kDepth / 2, kDepth, -1.5 * kDepth);
  EXPECT_EQ(verdict(MeasureKind::kSeparationError, findings), Verdict::kUndecidable);
  EXPECT_EQ(verdict(MeasureKind::kExcess, findings), Verdict::kUndecidable);
  EXPECT_EQ(verdict(MeasureKind::kContactTooDeep, findings), Verdict::kUndecidable);
  EXPECT_THAT(Of(MeasureKind::kSeparationError, findings).tolerance_because,
              StartsWith("the truth is known only to within 0.003 m, more than is "
                         "allowed: 64 roundings"));
  // A value outside the enclosure fails; a value near all of it passes.
  findings = judged(kDepth / 2, kDepth, -3 * kDepth);
  EXPECT_EQ(verdict(MeasureKind::kSeparationError, findings), Verdict::kFail);
  findings = judged(0.8 * e, 0.8 * e, -kDepth);
  EXPECT_EQ(verdict(MeasureKind::kSeparationError, findings), Verdict::kPass);
  EXPECT_EQ(verdict(MeasureKind::kContactTooDeep, findings), Verdict::kPass);
}

TEST(Judge, GrantsADocumentedErrorAndQuotesIt) {
  Specimen s = SphereInBoxFace(kDepth);
  s.right.separation = -kDepth - 0.5e-6;
  FakeOracle documented("mine");
  documented.ForEachPair([](Capability& capability) {
    capability.documented_error = 1e-6;
    capability.documented_by = "its manual, section 4";
  });
  EXPECT_EQ(Of(MeasureKind::kSeparationError, Judged(s.query, s.right)).verdict,
            Verdict::kFail);
  const Finding granted =
      Of(MeasureKind::kSeparationError, Judged(s.query, s.right, documented));
  EXPECT_EQ(granted.verdict, Verdict::kPass);
  EXPECT_THAT(granted.tolerance_because, HasSubstr("its manual, section 4"));
}

TEST(Judge, DecidesAFlushSceneWhoseNumbersNeedNoRounding) {
  const Box cube{Eigen::Vector3d::Constant(0.5)};
  const ContactQuery query{
      {cube, Pose{}},
      {cube, Pose::FromMatrix({0, 0.25, 1}, Eigen::Matrix3d::Identity())}};
  ContactAnswer answer = RightAnswer(query);
  ASSERT_TRUE(answer.touching);
  EXPECT_EQ(Of(MeasureKind::kTouching, Judged(query, answer)).verdict, Verdict::kPass);
  answer = {};
  answer.status = AnswerStatus::kAnswered;
  const Finding missed = Of(MeasureKind::kTouching, Judged(query, answer));
  EXPECT_EQ(missed.verdict, Verdict::kFail);
  EXPECT_THAT(missed.proof, HasSubstr("belongs to both"));
}

TEST(Judge, SaysWhetherAnUndecidableAnswerOpposesTheCertifiedSign) {
  const Specimen s = SphereInBoxFace(0);
  Scenario scenario;
  scenario.contact = s.query;
  const FakeOracle oracle("mine");
  const auto reason = [&](const Enclosure& separation, bool touching) {
    ContactTruth truth = s.truth;
    truth.touching = Touching::kUndecided;
    truth.separation = separation;
    ContactAnswer answer = s.right;
    answer.touching = touching;
    const Finding finding =
        Of(MeasureKind::kTouching, JudgeAnswer(scenario, truth, oracle.info(), answer));
    EXPECT_EQ(finding.verdict, Verdict::kUndecidable);
    return finding.undecided;
  };
  EXPECT_EQ(reason({1e-17, 2e-17}, false), Undecided::kAgreed);
  EXPECT_EQ(reason({1e-17, 2e-17}, true), Undecided::kOpposed);
  EXPECT_EQ(reason({-2e-17, 0}, true), Undecided::kAgreed);
  EXPECT_EQ(reason({-1e-17, 1e-17}, true), Undecided::kUnknown);
}

// Two float cubes at x = 3e6 m, 0.5 m deep in each other along z.
TEST(Judge, RoundsAnEngineThatSubtractsFirstByTheDistanceOfThePositions) {
  const Box cube{Eigen::Vector3d::Constant(1)};
  const Eigen::Matrix3d I = Eigen::Matrix3d::Identity();
  ContactQuery query{{cube, Pose::FromMatrix({3e6, 0, 0}, I)},
                     {cube, Pose::FromMatrix({3e6, 0, 1.5}, I)}};
  ContactAnswer answer = RightAnswer(query);
  answer.separation = -0.289;
  for (ContactPoint& contact : answer.points) contact.separation = -0.289;
  FakeOracle coarse("mine");
  coarse.info().unit_roundoff = 0x1p-24;
  EXPECT_EQ(Of(MeasureKind::kSeparationError, Judged(query, answer, coarse)).undecided,
            Undecided::kCoarse);
  coarse.info().subtracts_first = true;
  EXPECT_EQ(Of(MeasureKind::kSeparationError, Judged(query, answer, coarse)).verdict,
            Verdict::kFail);
  // 3e6 + 1/8 is no float.
  query.A.X_WB = Pose::FromMatrix({3e6 + 0.125, 0, 0}, I);
  EXPECT_EQ(Of(MeasureKind::kSeparationError, Judged(query, answer, coarse)).verdict,
            Verdict::kUndecidable);
}

TEST(Judge, CallsNothingRightWithinAToleranceAsLargeAsTheBodies) {
  const Specimen s = SphereInBoxFace(kDepth);
  FakeOracle documented("mine");
  documented.ForEachPair([](Capability& capability) {
    capability.documented_error = 0.1;
    capability.documented_by = "its manual";
  });
  const auto judged = [&](double error) {
    ContactAnswer answer = s.right;
    answer.separation = -kDepth - error;
    return Of(MeasureKind::kSeparationError, Judged(s.query, answer, documented));
  };
  // The smallest feature is the box's half height of 0.1 m.
  EXPECT_EQ(judged(0.9e-3).verdict, Verdict::kPass);
  EXPECT_DOUBLE_EQ(judged(0.9e-3).tolerance, 1e-3);
  EXPECT_EQ(judged(1.1e-3).verdict, Verdict::kUndecidable);
  EXPECT_EQ(judged(1.1e-3).undecided, Undecided::kCoarse);
  EXPECT_EQ(judged(0.11).verdict, Verdict::kFail);
}

TEST(Judge, GrantsAStatedToleranceAsALengthAndAShareOfTheSceneAndQuotesIt) {
  Specimen s = SphereInBoxFace(kDepth);
  const double size = SceneSize(s.query);
  const auto judged = [&](double error, StatedTolerance tolerance) {
    tolerance.by = "me";
    s.right.separation = -kDepth - error;
    FakeOracle oracle("mine");
    SetTolerance(tolerance, oracle.info());
    return Of(MeasureKind::kSeparationError, Judged(s.query, s.right, oracle));
  };
  EXPECT_EQ(judged(0.99e-6, {.length = 1e-6}).verdict, Verdict::kPass);
  EXPECT_EQ(judged(1.01e-6, {.length = 1e-6}).verdict, Verdict::kFail);
  EXPECT_EQ(judged(0.99e-6 * size, {.share = 1e-6}).verdict, Verdict::kPass);
  EXPECT_EQ(judged(1.01e-6 * size, {.share = 1e-6}).verdict, Verdict::kFail);
  const StatedTolerance both{.length = 1e-6, .share = 1e-6};
  EXPECT_EQ(judged(0.99e-6 * (1 + size), both).verdict, Verdict::kPass);
  EXPECT_EQ(judged(1.01e-6 * (1 + size), both).verdict, Verdict::kFail);
  EXPECT_THAT(judged(0, both).tolerance_because,
              HasSubstr("1e-06 m and 1e-06 of the scene's size stated by me"));
}

}  // namespace
}  // namespace touchstone
