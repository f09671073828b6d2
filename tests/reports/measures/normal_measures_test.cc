#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "reports/measures/consistency_error.h"
#include "reports/measures/excess.h"
#include "reports/measures/overlap_along.h"
#include "tests/reports/specimens.h"

namespace touchstone {
namespace {

constexpr double kDepth = 2e-3;  // [m]

// Scenes below 2 m, a dozen operations each: 64 roundings of 2^-53 · 2 m.
constexpr double kRounding = 0x1p-46;  // [m]

TEST(ConsistencyError, IsNoneForARightAnswer) {
  for (const Specimen& s :
       {SphereInBoxFace(kDepth), BoxOnBoxFace(kDepth), SphereInHalfSpace(kDepth)}) {
    EXPECT_LE(ConsistencyError(s.query, *s.right.n_AB_W, *s.right.separation), kRounding);
  }
}

TEST(ConsistencyError, OfAHalvedDepthIsTheOtherHalf) {
  const Specimen s = SphereInBoxFace(kDepth);
  EXPECT_NEAR(ConsistencyError(s.query, *s.right.n_AB_W, -kDepth / 2), kDepth / 2,
              kRounding);
}

TEST(ConsistencyError, OfASwappedSignIsTwiceTheDepth) {
  const Specimen s = SphereInBoxFace(kDepth);
  EXPECT_NEAR(ConsistencyError(s.query, *s.right.n_AB_W, kDepth), 2 * kDepth, kRounding);
}

TEST(ConsistencyError, OfAFlippedNormalIsTheDistanceThroughBothBodies) {
  // Moved against n, B leaves through A's far face: o(-n) = 2 h + 2 r - d.
  const Specimen s = SphereInBoxFace(kDepth);
  EXPECT_NEAR(ConsistencyError(s.query, -*s.right.n_AB_W, -kDepth),
              0.2 + 2.0 / 3 - 2 * kDepth, kRounding);
}

TEST(ConsistencyError, HoldsForABadDirectionThatKnowsItsOwnDepth) {
  // Along A's x, o = 0.3 + r - 0.07: the answer is consistent, though far from the least
  // overlap.
  const Specimen s = SphereInBoxFace(kDepth);
  EXPECT_LE(
      ConsistencyError(s.query, s.query.A.X_WB.R_WB.col(0), -(0.3 + 1.0 / 3 - 0.07)),
      kRounding);
}

TEST(Excess, IsNoneForARightNormal) {
  for (const double depth : {kDepth, -kDepth}) {
    for (const Specimen& s :
         {SphereInBoxFace(depth), BoxOnBoxFace(depth), SphereInHalfSpace(depth)}) {
      EXPECT_LE(Excess(s.query, s.truth, *s.right.n_AB_W), kRounding);
    }
  }
}

TEST(Excess, OfAFlippedNormalIsTheExtraTranslation) {
  const Specimen s = SphereInBoxFace(kDepth);
  EXPECT_NEAR(Excess(s.query, s.truth, -*s.right.n_AB_W), 0.2 + 2.0 / 3 - 2 * kDepth,
              kRounding);
}

TEST(Excess, SeesATinyTilt) {
  // If n is tilted by θ about A's y, the box's support grows by 0.3 sin θ minus what its
  // height and the sphere's position take back: o(n) = 0.3 sin θ + h cos θ - (0.07 sin θ
  // + (h + r - d) cos θ) + r.
  const Specimen s = SphereInBoxFace(kDepth);
  constexpr double kTilt = 1e-9;  // [rad]
  const Eigen::Vector3d n =
      s.query.A.X_WB.R_WB * Eigen::Vector3d(std::sin(kTilt), 0, std::cos(kTilt));
  EXPECT_NEAR(Excess(s.query, s.truth, n), 0.23 * kTilt, kRounding);
}

TEST(Excess, OfEitherOfTwoEqualAxesIsNone) {
  // Two boxes that overlap by 0.03 along x and along y: either normal is right.
  const Pose X_WA = AwkwardPose();
  const Box box{{0.3, 0.3, 0.3}};
  const ContactQuery query = {{box, X_WA}, {box, Placed(X_WA, {0.57, 0.57, 0.1})}};
  ContactTruth truth;
  truth.separation = {-0.03 - kRounding, -0.03 + kRounding};
  for (const int axis : {0, 1}) {
    EXPECT_LE(Excess(query, truth, X_WA.R_WB.col(axis)), kRounding);
  }
  EXPECT_GT(Excess(query, truth, X_WA.R_WB.col(2)), 0.4);
}

TEST(Excess, OfAnswersApartIsTheDistanceTheirPlaneFailsToProve) {
  // Along A's x the shapes overlap by 0.3 + r - 0.07: nothing is proved of the gap.
  const Specimen s = SphereInBoxFace(-kDepth);
  EXPECT_NEAR(Excess(s.query, s.truth, s.query.A.X_WB.R_WB.col(0)),
              0.3 + 1.0 / 3 - 0.07 + kDepth, kRounding);
}

TEST(OverlapAlong, CostsAnUlpForANormalOffAHalfSpaceByAnUlp) {
  const Specimen s = SphereInHalfSpace(kDepth);
  Eigen::Vector3d n = *s.right.n_AB_W;
  n.x() = std::nextafter(n.x(), 1);
  const Enclosure overlap = OverlapAlong(s.query, n);
  EXPECT_NEAR(overlap.lo, kDepth, kRounding);
  EXPECT_NEAR(overlap.hi, kDepth, kRounding);
}

TEST(OverlapAlong, CostsTheSceneForANormalFlippedOnAHalfSpace) {
  const Specimen s = SphereInHalfSpace(kDepth);
  EXPECT_NEAR(OverlapAlong(s.query, -*s.right.n_AB_W).lo, kDepth + 2 * SceneSize(s.query),
              kRounding);
}

TEST(OverlapAlong, SeesTheHalfSpaceAsB) {
  Specimen s = SphereInHalfSpace(kDepth);
  std::swap(s.query.A, s.query.B);
  EXPECT_NEAR(OverlapAlong(s.query, -*s.right.n_AB_W).lo, kDepth, kRounding);
}

}  // namespace
}  // namespace touchstone
