#include "reports/measures/answer_change.h"

#include <gtest/gtest.h>

#include "tests/reports/specimens.h"

namespace touchstone {
namespace {

constexpr double kDepth = 2e-3;        // [m]
constexpr double kRounding = 0x1p-46;  // [m], 64 roundings of a scene below 2 m

double Change(const Specimen& s, const ContactAnswer& other) {
  return AnswerChange(s.query, s.truth, s.right, other).Largest();
}

TEST(AnswerChange, IsNoneBetweenAnAnswerAndItself) {
  const Specimen s = BoxOnBoxFace(kDepth);
  EXPECT_EQ(Change(s, s.right), 0);
}

TEST(AnswerChange, SeesTheSeparationChange) {
  const Specimen s = BoxOnBoxFace(kDepth);
  ContactAnswer other = s.right;
  *other.separation *= 1.5;
  EXPECT_DOUBLE_EQ(Change(s, other), kDepth / 2);
}

TEST(AnswerChange, SeesAFlippedNormal) {
  const Specimen s = BoxOnBoxFace(kDepth);
  ContactAnswer other = s.right;
  *other.n_AB_W *= -1;
  // o(-n) - o(n) = (2 h + 2 h_B - d) - d.
  EXPECT_NEAR(Change(s, other), 0.2 + 0.22 - 2 * kDepth, kRounding);
}

TEST(AnswerChange, KeepsNormalsApartFromSeparations) {
  const Specimen s = BoxOnBoxFace(kDepth);
  ContactAnswer other = s.right;
  *other.separation *= 1.5;
  EXPECT_EQ(AnswerChange(s.query, s.truth, s.right, other).overlap, 0);
  other = s.right;
  *other.n_AB_W *= -1;
  EXPECT_EQ(AnswerChange(s.query, s.truth, s.right, other).separation, 0);
}

/** Returns the answer without its own normal and separation: its contacts state them
 instead. */
ContactAnswer InContactsOnly(ContactAnswer answer) {
  for (ContactPoint& contact : answer.points) contact.n_AB_W = answer.n_AB_W;
  answer.n_AB_W.reset();
  answer.separation.reset();
  return answer;
}

TEST(AnswerChange, SeesTheChangeOfAnAnswerGivenInContactsOnly) {
  Specimen s = BoxOnBoxFace(kDepth);
  s.right = InContactsOnly(s.right);
  EXPECT_TRUE(AnswerChange(s.query, s.truth, s.right, s.right).compared);
  ContactAnswer other = s.right;
  for (ContactPoint& contact : other.points) contact.separation *= 1.5;
  EXPECT_DOUBLE_EQ(AnswerChange(s.query, s.truth, s.right, other).separation, kDepth / 2);
  other = s.right;
  for (ContactPoint& contact : other.points) *contact.n_AB_W *= -1;
  EXPECT_GT(AnswerChange(s.query, s.truth, s.right, other).overlap, 0.1);
}

TEST(AnswerChange, SaysWhereThereIsNothingToCompare) {
  const Specimen s = BoxOnBoxFace(kDepth);
  ContactAnswer bare;
  bare.touching = true;
  EXPECT_FALSE(AnswerChange(s.query, s.truth, s.right, bare).compared);
}

TEST(AnswerChange, ForgivesATieOfNormals) {
  const Pose X_WA = AwkwardPose();
  const Box box{{0.3, 0.3, 0.3}};
  Specimen s;
  s.query = {{box, X_WA}, {box, Placed(X_WA, {0.57, 0.57, 0.1})}};
  s.right.touching = true;
  s.right.n_AB_W = X_WA.R_WB.col(0);
  ContactAnswer other = s.right;
  other.n_AB_W = X_WA.R_WB.col(1);
  EXPECT_LE(Change(s, other), kRounding);
}

TEST(AnswerChange, OfTheTouchingVerdictIsTheDistanceFromTouching) {
  const Specimen s = SphereInBoxFace(kDepth);
  ContactAnswer other = s.right;
  other.touching = false;
  EXPECT_NEAR(Change(s, other), kDepth, kRounding);
}

TEST(BackFromSwap, UndoesTheSwap) {
  for (const Specimen& s : {BoxOnBoxFace(kDepth), SphereInBoxFace(-kDepth)}) {
    EXPECT_EQ(Change(s, BackFromSwap(BackFromSwap(s.right))), 0);
    EXPECT_EQ(*BackFromSwap(s.right).n_AB_W, -*s.right.n_AB_W);
    EXPECT_EQ(BackFromSwap(s.right).separation, s.right.separation);
  }
}

TEST(BackFromSwap, SwapsTheWitnesses) {
  const ContactAnswer right = SphereInBoxFace(-kDepth).right;
  EXPECT_EQ(BackFromSwap(right).witnesses->p_WCa, right.witnesses->p_WCb);
}

TEST(BackFromMotion, TurnsNormalsAndMovesPoints) {
  const Specimen s = BoxOnBoxFace(kDepth);
  Eigen::Isometry3d X_VW = Eigen::Isometry3d::Identity();
  X_VW.linear() = AwkwardPose().R_WB;
  X_VW.translation() = Eigen::Vector3d(0.3, 1.7, -0.9);
  ContactAnswer moved = s.right;
  moved.n_AB_W = X_VW.linear() * *s.right.n_AB_W;
  for (ContactPoint& contact : moved.points) contact.p_WC = X_VW * contact.p_WC;
  const ContactAnswer back = BackFromMotion(moved, X_VW);
  EXPECT_LE(Change(s, back), kRounding);
  EXPECT_LE((back.points[3].p_WC - s.right.points[3].p_WC).norm(), kRounding);
}

TEST(BackFromScale, BringsLengthsBackAndLeavesDirections) {
  const Specimen s = BoxOnBoxFace(kDepth);
  const ContactAnswer back = BackFromScale(s.right, 4);
  EXPECT_EQ(back.separation, -kDepth / 4);
  EXPECT_EQ(back.points[1].p_WC, s.right.points[1].p_WC / 4);
  EXPECT_EQ(back.n_AB_W, s.right.n_AB_W);
}

}  // namespace
}  // namespace touchstone
