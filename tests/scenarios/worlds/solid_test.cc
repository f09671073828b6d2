#include "scenarios/worlds/solid.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <random>
#include <variant>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "scenarios/pose.h"
#include "scenarios/worlds/world.h"

namespace touchstone {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

ConvexHull CornersOf(const Vector3d& half, const Matrix3d& R, const Vector3d& p) {
  ConvexHull hull;
  for (const double x : {-1, 1})
    for (const double y : {-1, 1})
      for (const double z : {-1, 1})
        hull.vertices.emplace_back(R * half.cwiseProduct(Vector3d(x, y, z)) + p);
  return hull;
}

/** A prism or cone about z as a hull of two rings of `count` corners. */
ConvexHull Rings(double below, double above, double half, int count) {
  ConvexHull hull;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * i / count;
    const Vector3d out(std::cos(angle), std::sin(angle), 0);
    hull.vertices.emplace_back(below * out - half * Vector3d::UnitZ());
    if (above > 0) hull.vertices.emplace_back(above * out + half * Vector3d::UnitZ());
  }
  if (above == 0) hull.vertices.emplace_back(half * Vector3d::UnitZ());
  return hull;
}

TEST(UniformSolid, OfABoxIsThatOfTheHullOfItsCorners) {
  const Vector3d half(0.3, 0.7, 1.1);
  const Matrix3d R = Eigen::Quaterniond(0.3, -0.7, 0.41, 0.9).normalized().matrix();
  const Vector3d p(2, -3, 5);
  const std::optional<Solid> box = UniformSolid(Box{half}, 3.5);
  const std::optional<Solid> hull = UniformSolid(CornersOf(half, R, p), 3.5);
  ASSERT_TRUE(box && hull);
  EXPECT_NEAR(hull->volume, box->volume, 1e-14);
  EXPECT_NEAR((hull->centre_B - p).norm(), 0, 1e-14);
  EXPECT_NEAR((hull->inertia_B - R * box->inertia_B * R.transpose()).norm(), 0, 1e-14);
}

TEST(UniformSolid, OfATetrahedronIsItsClosedForm) {
  // Along the axes from the origin: centre at a quarter, ∫x² dm = m a²/10.
  const double a = 2;
  const std::optional<Solid> solid =
      UniformSolid(ConvexHull{{{0, 0, 0}, {a, 0, 0}, {0, a, 0}, {0, 0, a}}}, 6);
  ASSERT_TRUE(solid);
  EXPECT_NEAR(solid->volume, a * a * a / 6, 1e-15);
  EXPECT_NEAR((solid->centre_B - Vector3d::Constant(a / 4)).norm(), 0, 1e-15);
  // About the centre: ∫x² = 6 (4/10 − 4/16) = 0.9, ∫xy = 6 (4/20 − 4/16) = −0.3.
  EXPECT_NEAR(solid->inertia_B(0, 0), 1.8, 1e-14);
  EXPECT_NEAR(solid->inertia_B(0, 1), 0.3, 1e-14);
}

// The error of n corners on a circle is of the order (π/n)².
TEST(UniformSolid, OfRoundShapesIsTheLimitOfHulls) {
  constexpr int kCorners = 400;
  constexpr double kNear = 2e-4;
  const auto expect_near = [](const Shape& round, const ConvexHull& hull) {
    const std::optional<Solid> is = UniformSolid(round, 1.3);
    const std::optional<Solid> limit = UniformSolid(hull, 1.3);
    ASSERT_TRUE(is && limit);
    EXPECT_NEAR(is->volume, limit->volume, kNear * is->volume);
    EXPECT_NEAR((is->centre_B - limit->centre_B).norm(), 0, kNear);
    EXPECT_NEAR((is->inertia_B - limit->inertia_B).norm(), 0,
                kNear * is->inertia_B.norm());
  };
  expect_near(Cylinder{0.8, 0.5}, Rings(0.8, 0.8, 0.5, kCorners));
  expect_near(Cone{0.8, 0.5}, Rings(0.8, 0, 0.5, kCorners));
}

TEST(UniformSolid, OfACapsuleIsThatOfRandomPointsInIt) {
  const Capsule capsule{0.4, 0.7};
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(-1, 1);
  constexpr int kPoints = 400'000;
  int inside = 0;
  Vector3d squares = Vector3d::Zero();
  for (int i = 0; i < kPoints; ++i) {
    const Vector3d x(0.4 * unit(random), 0.4 * unit(random), 1.1 * unit(random));
    const double along = std::clamp(x.z(), -0.7, 0.7);
    if ((x - along * Vector3d::UnitZ()).norm() > 0.4) continue;
    ++inside;
    squares += x.cwiseAbs2();
  }
  squares /= inside;
  const std::optional<Solid> solid = UniformSolid(capsule, 1);
  ASSERT_TRUE(solid);
  // Three standard deviations of the mean of so many points are less than 1 %.
  EXPECT_NEAR(solid->volume, 0.8 * 0.8 * 2.2 * inside / kPoints, 0.01 * solid->volume);
  EXPECT_NEAR(solid->inertia_B(2, 2), squares.x() + squares.y(), 0.01 * 0.08);
  EXPECT_NEAR(solid->inertia_B(0, 0), squares.y() + squares.z(), 0.01 * 0.35);
}

TEST(UniformSolid, OfACapsuleWithoutTubeOrRadiusHasItsLimits) {
  EXPECT_NEAR(UniformSolid(Capsule{1, 1e-12}, 1)->inertia_B(0, 0), 0.4, 1e-11);
  EXPECT_NEAR(UniformSolid(Capsule{1e-12, 1}, 1)->inertia_B(0, 0), 1.0 / 3, 1e-11);
}

TEST(UniformSolid, DoesNotExistWithoutVolume) {
  EXPECT_FALSE(UniformSolid(HalfSpace{}, 1));
  EXPECT_FALSE(UniformSolid(ConvexHull{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}}, 1));
}

TEST(UniformMoments, ExistAboutTheOriginAndAlongTheAxesOnly) {
  const Vector3d half(0.3, 0.7, 1.1);
  const Matrix3d turn = Eigen::AngleAxisd(1e-7, Vector3d::UnitX()).matrix();
  EXPECT_TRUE(UniformMoments(CornersOf(half, Matrix3d::Identity(), {0, 0, 0}), 1));
  EXPECT_TRUE(UniformMoments(CornersOf(half, Matrix3d::Identity(), {0, 1e-10, 0}), 1));
  EXPECT_FALSE(UniformMoments(CornersOf(half, Matrix3d::Identity(), {0, 1e-8, 0}), 1));
  EXPECT_FALSE(UniformMoments(CornersOf(half, turn, {0, 0, 0}), 1));
  EXPECT_FALSE(UniformMoments(Cone{0.4, 0.2}, 1));
}

TEST(UniformMoments, DoNotExistBeyondTheRangeOfDoubles) {
  EXPECT_FALSE(UniformMoments(Box{{1e160, 1e160, 1e160}}, 1));
  EXPECT_FALSE(UniformMoments(Box{{1e160, 1, 1}}, 1));
  EXPECT_FALSE(UniformMoments(Sphere{1e160}, 1));
  EXPECT_FALSE(UniformMoments(Cylinder{1e160, 1}, 1));
  EXPECT_TRUE(UniformMoments(Box{{1e152, 1e152, 1e152}}, 1));
  EXPECT_FALSE(UniformMoments(Box{{1e152, 1e152, 1e152}}, 1e6));
}

TEST(InertiaOf, OfASphereAndABoxAreTheirClosedForms) {
  RigidBody body;
  body.mass = 3;
  body.placed = {Sphere{0.5}, Pose::FromQuaternion({0, 0, 0}, {1, 0, 0, 0})};
  EXPECT_EQ(InertiaOf(body).x(), 0.4 * 3 * 0.5 * 0.5);
  body.placed.shape = Box{{0.5, 1, 1.5}};
  EXPECT_EQ(InertiaOf(body), 3.0 / 3 * Vector3d(3.25, 2.5, 1.25));
}

}  // namespace
}  // namespace touchstone
