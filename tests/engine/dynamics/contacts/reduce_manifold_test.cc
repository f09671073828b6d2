#include "engine/dynamics/contacts/reduce_manifold.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

namespace cookbook {
namespace {

constexpr double kPi = std::numbers::pi;

/** Returns a face perpendicular to z with these corners. The feature of a corner is its
 index + 10. */
Manifold FaceOf(const std::vector<Eigen::Vector3d>& corners) {
  Manifold face;
  face.n_AB_W = Eigen::Vector3d::UnitZ();
  for (const Eigen::Vector3d& corner : corners) {
    const auto k = static_cast<std::size_t>(face.count++);
    face.contacts[k] = {corner, -1e-3, static_cast<FeatureId>(10 + k)};
  }
  return face;
}

/** Returns a face with its corners on an ellipse at these angles. */
Manifold OnEllipse(const std::vector<double>& angles, double width, double height) {
  std::vector<Eigen::Vector3d> corners;
  corners.reserve(angles.size());
  for (const double a : angles) {
    corners.emplace_back(width * std::cos(a), height * std::sin(a), 0);
  }
  return FaceOf(corners);
}

Manifold Octagon(double angle) {
  std::vector<double> angles;
  angles.reserve(8);
  for (int k = 0; k < 8; ++k) angles.push_back(angle + k * kPi / 4);
  return OnEllipse(angles, 1, 1);
}

std::vector<FeatureId> FeaturesOf(const Manifold& face) {
  std::vector<FeatureId> features;
  for (const ContactPoint& contact : face.points()) features.push_back(contact.feature);
  return features;
}

/** Returns the area of a polygon with its corners in order. [m²] */
double AreaOf(const Manifold& face) {
  double area = 0;
  const auto corners = face.points();
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Eigen::Vector3d& a = corners[k].p_WC;
    const Eigen::Vector3d& b = corners[(k + 1) % corners.size()].p_WC;
    area += a.cross(b).z() / 2;
  }
  return area;
}

TEST(ReduceManifold, KeepsFourAndFewer) {
  for (const std::size_t count : {0u, 1u, 2u, 3u, 4u}) {
    std::vector<double> angles;
    for (std::size_t k = 0; k < count; ++k) angles.push_back(static_cast<double>(k));
    Manifold face = OnEllipse(angles, 1, 2);
    const std::vector<FeatureId> before = FeaturesOf(face);
    ReduceManifold({}, face);
    EXPECT_EQ(FeaturesOf(face), before);
  }
}

// A square of every second corner has 1/√2 of the area of a regular octagon.
TEST(ReduceManifold, KeepsASquareOfARegularOctagon) {
  Manifold face = Octagon(0.1);
  const double whole = AreaOf(face);
  ReduceManifold({}, face);
  ASSERT_EQ(face.count, 4);
  EXPECT_NEAR(AreaOf(face), whole / std::sqrt(2), 1e-12);
}

TEST(ReduceManifold, KeepsTheFeaturesOfThePreviousManifold) {
  // Both squares of the octagon have the same area to rounding.
  for (const unsigned other : {0u, 1u}) {
    Manifold before = Octagon(0);
    before.count = 0;
    for (unsigned k = 0; k < 4; ++k) {
      before.contacts[static_cast<std::size_t>(before.count++)] =
          Octagon(0).contacts[2 * k + other];
    }
    Manifold face = Octagon(1e-9);
    ReduceManifold(before.points(), face);
    EXPECT_EQ(FeaturesOf(face), FeaturesOf(before));
  }
}

TEST(ReduceManifold, KeepsTheEndsOfALine) {
  Manifold face =
      FaceOf({{0.3, 0, 0}, {-1, 0, 0}, {0.2, 0, 0}, {0.7, 0, 0}, {0, 0, 0}, {0.9, 0, 0}});
  ReduceManifold({}, face);
  EXPECT_EQ(FeaturesOf(face), (std::vector<FeatureId>{11, 15}));
}

TEST(ReduceManifold, KeepsAPointIfAllCoincide) {
  Manifold face = FaceOf(std::vector<Eigen::Vector3d>(6, {1, 2, 3}));
  ReduceManifold({}, face);
  ASSERT_GT(face.count, 0);
  EXPECT_EQ(face.contacts[0].p_WC, Eigen::Vector3d(1, 2, 3));
}

// Let a, b be the first two contact points and w, v the distances of the other two from
// the line through them, one on each side. The four points span the area |ab| (w + v)
// / 2. No corner is farther from a than b, so the face lies in a strip of the width w + v
// and within |ab| of a.
RC_GTEST_PROP(ReduceManifold, KeepsAtLeastAQuarterOfTheAreaOfAConvexFace, ()) {
  std::vector<double> angles;
  const int count = *rc::gen::inRange(5, 9);
  angles.reserve(8);
  for (int k = 0; k < count; ++k) {
    angles.push_back(2 * kPi * *rc::gen::inRange(0, 1000000) / 1e6);
  }
  std::sort(angles.begin(), angles.end());
  Manifold face = OnEllipse(angles, 1, *rc::gen::inRange(1, 1000) / 1e3);
  const double whole = AreaOf(face);
  ReduceManifold({}, face);
  RC_ASSERT(face.count <= 4);
  RC_ASSERT(AreaOf(face) >= whole / 4 - 1e-12);
}

}  // namespace
}  // namespace cookbook
