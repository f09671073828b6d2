#include "reports/contacts/checks/duality_gap.h"

#include <gtest/gtest.h>

#include "tests/reports/specimens.h"

namespace touchstone {
namespace {

constexpr double kGap = 0.05;  // [m]

// A direction between points 0.05 m apart in a scene of 1.4 m amplifies its rounding by
// 28: 64 roundings of that.
constexpr double kRounding = 64 * 28 * 0x1p-53;  // [m]

TEST(DualityGap, IsNoneForNearestPoints) {
  for (const Specimen& s : {SphereInBoxFace(-kGap), SphereInHalfSpace(-kGap)}) {
    EXPECT_LE(DualityGap(s.query, *s.right.witnesses), kRounding);
  }
}

TEST(DualityGap, SeesAWitnessSlidAlongTheFace) {
  // p_A slides by t along A's x: |p| = √(g² + t²). Along that tilted direction, tan θ =
  // -t/g, the box reaches to x = -0.3 instead of below the sphere, so the gap shrinks by
  // more.
  const Specimen s = SphereInBoxFace(-kGap);
  constexpr double t = 1e-3;
  WitnessPoints w = *s.right.witnesses;
  w.p_WCa += t * s.query.A.X_WB.R_WB.col(0);
  const double cosine = kGap / std::hypot(kGap, t);
  const double sine = t / std::hypot(kGap, t);
  const double r = 1.0 / 3;
  // n = (-sin θ, 0, cos θ): min_B n·x = n·c_B - r, max_A n·x = 0.3 sin θ + 0.1 cos θ.
  const double gap =
      -0.07 * sine + (0.1 + r + kGap) * cosine - r - 0.3 * sine - 0.1 * cosine;
  EXPECT_NEAR(DualityGap(s.query, w), std::hypot(kGap, t) - gap, kRounding);
}

TEST(DualityGap, SeesWitnessesInsideTheBodies) {
  // Both points move towards each other by a quarter of the gap, off the surfaces: nearer
  // than any points of the shapes can be.
  const Specimen s = SphereInBoxFace(-kGap);
  WitnessPoints w = *s.right.witnesses;
  const Eigen::Vector3d quarter = (w.p_WCb - w.p_WCa) / 4;
  w.p_WCa += quarter;
  w.p_WCb -= quarter;
  EXPECT_NEAR(DualityGap(s.query, w), kGap / 2, kRounding);
}

}  // namespace
}  // namespace touchstone
