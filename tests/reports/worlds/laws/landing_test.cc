#include "reports/worlds/law_support/landing.h"

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "tests/reports/worlds/motions.h"

namespace touchstone {
namespace {

using Eigen::Vector3d;

RigidBody TurnedAbout(const Shape& shape, const Vector3d& angle_W) {
  RigidBody body = BodyOf("body", shape, 1, Vector3d(0.3, 2, -0.7));
  body.placed.X_WB = Pose::FromQuaternion(
      body.placed.X_WB.p_WB, Turned(Eigen::Quaterniond::Identity(), angle_W));
  return body;
}

const Vector3d kUp = Vector3d::UnitY();
constexpr double kRight = std::numbers::pi / 2;

// The axis of these is z, so that they lie on their side.
TEST(LiesFlat, IsTrueOfRoundBodiesOnTheirSideOrOnAnEndOnly) {
  const std::vector<Shape> round = {Capsule{0.2, 0.5}, Cylinder{0.2, 0.5}};
  for (const Shape& shape : round) {
    EXPECT_TRUE(LiesFlat(TurnedAbout(shape, {0, 0.3, 0}), kUp));
    EXPECT_TRUE(LiesFlat(TurnedAbout(shape, {kRight, 0, 0}), kUp));
    EXPECT_TRUE(LiesFlat(TurnedAbout(shape, {-kRight, 0, 0}), kUp));
    EXPECT_FALSE(LiesFlat(TurnedAbout(shape, {1e-3, 0, 0}), kUp));
    EXPECT_FALSE(LiesFlat(TurnedAbout(shape, {kRight + 1e-3, 0, 0}), kUp));
  }
  EXPECT_TRUE(LiesFlat(TurnedAbout(Sphere{1}, {0.1, 0.2, 0.3}), kUp));
}

TEST(LiesFlat, IsTrueOfAConeOnItsBaseOrItsApexOnly) {
  EXPECT_TRUE(LiesFlat(TurnedAbout(Cone{0.2, 0.5}, {-kRight, 0, 0}), kUp));
  EXPECT_TRUE(LiesFlat(TurnedAbout(Cone{0.2, 0.5}, {kRight, 0, 0}), kUp));
  EXPECT_FALSE(LiesFlat(TurnedAbout(Cone{0.2, 0.5}, {0, 0, 0}), kUp));
}

TEST(LiesFlat, IsTrueOfAHullOnAFaceThatIsBelowItsCentreOfMass) {
  // A square base at y = −1 under an apex, beside the origin or far from it.
  const auto pyramid = [](double x) {
    return ConvexHull{
        {{x + 1, -1, 1}, {x + 1, -1, -1}, {x - 1, -1, 1}, {x - 1, -1, -1}, {0, 2, 0}}};
  };
  EXPECT_TRUE(LiesFlat(TurnedAbout(pyramid(0.9), {0, 0.4, 0}), kUp));
  EXPECT_FALSE(LiesFlat(TurnedAbout(pyramid(1.1), {0, 0.4, 0}), kUp));
  EXPECT_FALSE(LiesFlat(TurnedAbout(pyramid(0), {1e-3, 0, 0}), kUp));
  EXPECT_FALSE(LiesFlat(TurnedAbout(pyramid(0), {2 * kRight, 0, 0}), kUp));
}

TEST(SupportOf, IsTheFarthestPointOfEachShape) {
  const Vector3d d(0.6, 0, 0.8);
  const Vector3d p(0.3, 2, -0.7);
  const auto support = [&](const Shape& shape, const Vector3d& along) -> Vector3d {
    return SupportOf(TurnedAbout(shape, {0, 0, 0}), along) - p;
  };
  const auto expect = [](const Vector3d& is, const Vector3d& right) {
    EXPECT_NEAR((is - right).norm(), 0, 1e-15) << is.transpose();
  };
  expect(support(Sphere{2}, 3 * d), {1.2, 0, 1.6});
  expect(support(Box{{1, 2, 3}}, {-0.6, 0.1, -0.8}), {-1, 2, -3});
  expect(support(Capsule{2, 5}, -d), {-1.2, 0, -6.6});
  expect(support(Cylinder{2, 5}, d), {2, 0, 5});
  expect(support(Cylinder{2, 5}, -Vector3d::UnitZ()), {0, 0, -5});
  expect(support(Cone{2, 5}, d), {0, 0, 5});
  expect(support(Cone{2, 5}, {0.99, 0, 0.1}), {2, 0, -5});
  expect(support(ConvexHull{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, -1, -1}}}, d),
         {0, 0, 1});
}

TEST(LandingOf, SeesEveryShapeAboveThePlane) {
  World world;
  world.bodies = {TurnedAbout(Cone{0.2, 0.5}, {-kRight, 0, 0}), GroundOf()};
  const std::optional<Landing> landing = LandingOf(world, 0);
  ASSERT_TRUE(landing);
  EXPECT_NEAR(landing->gap, 1.5, 1e-15);
}

}  // namespace
}  // namespace touchstone
