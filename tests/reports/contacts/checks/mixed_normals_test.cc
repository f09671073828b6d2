#include "reports/contacts/checks/mixed_normals.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/reports/specimens.h"

namespace touchstone {
namespace {

constexpr double kDepth = 2e-3;  // [m]

TEST(MixedNormals, IsNoneWhereAllContactsShareOne) {
  EXPECT_EQ(MixedNormals(BoxOnBoxFace(kDepth).right), 0);
}

TEST(MixedNormals, ResolvesATinyAngle) {
  Specimen s = BoxOnBoxFace(kDepth);
  constexpr double kAngle = 1e-10;  // [rad], which acos of a dot product sees as 0
  s.right.points[2].n_AB_W =
      s.query.A.X_WB.R_WB * Eigen::Vector3d(std::sin(kAngle), 0, std::cos(kAngle));
  EXPECT_NEAR(MixedNormals(s.right), kAngle, 0x1p-50);
}

TEST(MixedNormals, OfOppositeNormalsIsPi) {
  Specimen s = BoxOnBoxFace(kDepth);
  s.right.points[1].n_AB_W = -*s.right.n_AB_W;
  EXPECT_NEAR(MixedNormals(s.right), std::numbers::pi, 0x1p-50);
}

}  // namespace
}  // namespace touchstone
