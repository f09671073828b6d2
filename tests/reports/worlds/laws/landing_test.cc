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

/** Returns whether `body` lies flat as it is and tilted by 1e-7 rad, and does not tilted
 by ten times as much, about the x axis either way. */
testing::AssertionResult LiesFlatToRoundings(const Shape& shape,
                                             const Vector3d& angle_W) {
  for (const double tilt : {0.0, 1e-7, -1e-7, 1e-6, -1e-6, 3e-5, 1e-3}) {
    const RigidBody body = TurnedAbout(shape, angle_W + tilt * Vector3d::UnitX());
    if (LiesFlat(body, kUp) != (std::abs(tilt) < 3e-7))
      return testing::AssertionFailure() << "tilted by " << tilt;
  }
  return testing::AssertionSuccess();
}

bool LiesFlatAtAnyTilt(const Shape& shape, const Vector3d& angle_W) {
  for (const double tilt : {0.0, 1e-10, 1e-8, 1e-3})
    if (LiesFlat(TurnedAbout(shape, angle_W + tilt * Vector3d::UnitX()), kUp))
      return true;
  return false;
}

// A pose in single precision, or one of eight digits, is off by 1e-7.
TEST(LiesFlat, IsTrueOfAPoseOfEightDigits) {
  RigidBody body = BodyOf("body", Box{{0.1, 0.2, 0.3}}, 1, Vector3d(0, 2, 0));
  body.placed.X_WB = Pose::FromQuaternion(
      {0, 2, 0}, Eigen::Quaterniond(0.92387953, -0.38268343, 0, 0).normalized());
  EXPECT_TRUE(LiesFlat(body, Vector3d(0, 1, -1).normalized()));
  const Eigen::Quaternionf single(Eigen::AngleAxisf(0.7F, Eigen::Vector3f::UnitX()));
  body.placed.X_WB = Pose::FromQuaternion({0, 2, 0}, single.cast<double>().normalized());
  EXPECT_TRUE(LiesFlat(body, Vector3d(0, std::cos(0.7), std::sin(0.7))));
}

// The axis of round bodies is z, so that they lie on their side.
TEST(LiesFlat, IsTrueOfFacesAndSidesToRoundings) {
  EXPECT_TRUE(LiesFlatToRoundings(Box{{0.1, 0.2, 0.3}}, {0, 0, 0}));
  EXPECT_TRUE(LiesFlatToRoundings(Box{{0.1, 0.2, 0.3}}, {kRight, 0, 0}));
  EXPECT_TRUE(LiesFlatToRoundings(Cylinder{0.2, 0.5}, {0, 0, 0}));
  EXPECT_TRUE(LiesFlatToRoundings(Cylinder{0.2, 0.5}, {kRight, 0, 0}));
  EXPECT_TRUE(LiesFlatToRoundings(Cylinder{0.2, 0.5}, {-kRight, 0, 0}));
  EXPECT_TRUE(LiesFlatToRoundings(Capsule{0.2, 0.5}, {0, 0, 0}));
  EXPECT_TRUE(LiesFlatToRoundings(Cone{0.2, 0.5}, {-kRight, 0, 0}));
  EXPECT_TRUE(LiesFlat(TurnedAbout(Cylinder{0.2, 0.5}, {0, 0.3, 0}), kUp));
  EXPECT_TRUE(LiesFlat(TurnedAbout(Sphere{1}, {0.1, 0.2, 0.3}), kUp));
}

// An impact would multiply a tilt of a rounding, more at each bounce.
TEST(LiesFlat, IsFalseOfWhatBalancesOnAPoint) {
  EXPECT_FALSE(LiesFlatAtAnyTilt(Capsule{0.2, 0.5}, {kRight, 0, 0}));
  EXPECT_FALSE(LiesFlatAtAnyTilt(Capsule{0.2, 0.5}, {-kRight, 0, 0}));
  EXPECT_FALSE(LiesFlatAtAnyTilt(Cone{0.2, 0.5}, {kRight, 0, 0}));
}

TEST(LiesFlat, IsTrueOfAHullOnAFaceThatIsBelowItsCentreOfMass) {
  // A square base at y = −1 under an apex, beside the origin or far from it.
  const auto pyramid = [](double x) {
    return ConvexHull{
        {{x + 1, -1, 1}, {x + 1, -1, -1}, {x - 1, -1, 1}, {x - 1, -1, -1}, {0, 2, 0}}};
  };
  EXPECT_TRUE(LiesFlat(TurnedAbout(pyramid(0.9), {0, 0.4, 0}), kUp));
  EXPECT_TRUE(LiesFlatToRoundings(pyramid(0), {0, 0, 0}));
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
