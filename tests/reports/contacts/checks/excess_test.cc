#include "reports/contacts/checks/excess.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/reports/specimens.h"

namespace touchstone {
namespace {

constexpr double kDepth = 2e-3;        // [m]
constexpr double kRounding = 0x1p-46;  // [m], 64 roundings of a scene below 2 m

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

}  // namespace
}  // namespace touchstone
