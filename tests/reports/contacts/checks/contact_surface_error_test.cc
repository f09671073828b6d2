#include "reports/contacts/checks/contact_surface_error.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "tests/reports/specimens.h"

namespace touchstone {
namespace {

constexpr double kDepth = 2e-3;        // [m]
constexpr double kRounding = 0x1p-46;  // [m], 64 roundings of a scene below 2 m

double WorstSurfaceError(const Specimen& s) {
  double worst = 0;
  for (const ContactPoint& contact : s.right.points) {
    worst =
        std::max(worst, SurfaceError(s.query, SurfacePointsOf(contact, *s.right.n_AB_W)));
  }
  return worst;
}

TEST(SurfaceError, IsNoneMidwayThroughTheOverlap) {
  EXPECT_LE(WorstSurfaceError(SphereInBoxFace(kDepth)), kRounding);
  EXPECT_LE(WorstSurfaceError(BoxOnBoxFace(kDepth)), kRounding);
  EXPECT_LE(WorstSurfaceError(SphereInHalfSpace(kDepth)), kRounding);
}

TEST(SurfaceError, OfAPointOnASurfaceIsHalfTheDepth) {
  Specimen s = SphereInBoxFace(kDepth);
  s.right.points[0].p_WC += *s.right.n_AB_W * (kDepth / 2);
  EXPECT_NEAR(WorstSurfaceError(s), kDepth / 2, kRounding);
}

TEST(SurfaceError, OfAHalvedDepthIsAQuarterOfTheDepth) {
  Specimen s = SphereInBoxFace(kDepth);
  s.right.points[0].separation /= 2;
  EXPECT_NEAR(WorstSurfaceError(s), kDepth / 4, kRounding);
}

TEST(SurfaceError, OfAFlippedNormalIsTheDepth) {
  Specimen s = SphereInBoxFace(kDepth);
  *s.right.n_AB_W *= -1;
  EXPECT_NEAR(WorstSurfaceError(s), kDepth, kRounding);
}

TEST(SurfaceError, SeesAContactInTheAirNextToTheFace) {
  // A's face ends at x = 0.3. A contact 0.3 further along x is 0.07 beyond it, where B's
  // sphere curves away from the plane.
  Specimen s = SphereInBoxFace(kDepth);
  s.right.points[0].p_WC += 0.3 * s.query.A.X_WB.R_WB.col(0);
  EXPECT_GE(WorstSurfaceError(s), 0.07 - kRounding);
}

}  // namespace
}  // namespace touchstone
