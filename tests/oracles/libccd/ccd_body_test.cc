#include "oracles/libccd/ccd_body.h"

#include <random>

#include <gtest/gtest.h>

#include "tests/oracles/constructed_contact.h"
#include "tests/oracles/surface.h"

namespace touchstone {
namespace {

using Eigen::Vector3d;

constexpr double kRounding = 64 * 4 * 0x1p-53;  // [m]

// p is the support point along d if and only if it is on the surface and no other point
// is farther. Other points are sampled as support points of random directions, which
// reach all of a convex surface.
TEST(CcdSupport, IsOnTheSurfaceAndNothingIsFarther) {
  std::mt19937_64 random(17);
  std::normal_distribution<double> normal;
  const auto direction = [&] {
    return Vector3d(normal(random), normal(random), normal(random));
  };
  for (int kind = 0; kind < static_cast<int>(ShapeKind::kHalfSpace); ++kind) {
    SCOPED_TRACE(NameOf(static_cast<ShapeKind>(kind)));
    for (int i = 0; i < 40; ++i) {
      const Body body = {RandomShape(static_cast<ShapeKind>(kind), random),
                         RandomPose(2, random)};
      const Vector3d d = direction();
      const Vector3d p = CcdSupport(body, d);
      EXPECT_NEAR(HeightAboveSurface(body, p), 0, kRounding);
      EXPECT_LE(HeightAboveSurface(body, CcdCentre(body)), 0);
      for (int k = 0; k < 40; ++k) {
        const Vector3d q = CcdSupport(body, direction());
        EXPECT_LE(d.normalized().dot(q - p), kRounding);
      }
    }
  }
}

TEST(CcdSupport, DoesNotDependOnTheLengthOfTheDirection) {
  std::mt19937_64 random(18);
  for (int kind = 0; kind < static_cast<int>(ShapeKind::kHalfSpace); ++kind) {
    const Body body = {RandomShape(static_cast<ShapeKind>(kind), random),
                       RandomPose(2, random)};
    const Vector3d d(0.3, -0.8, 0.4);
    EXPECT_LE((CcdSupport(body, d) - CcdSupport(body, 7 * d)).norm(), kRounding);
  }
}

}  // namespace
}  // namespace touchstone
