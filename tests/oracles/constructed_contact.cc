#include "tests/oracles/constructed_contact.h"

#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "tests/oracles/surface.h"

namespace touchstone {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// A shape and one of its features.
struct Feature {
  Shape shape;
  Vector3d p_B;  // A point of the feature. [m]
  Vector3d n_B;  // The outward normal at this point.

  bool is_flat() const {
    return !std::holds_alternative<Sphere>(shape) &&
           !std::holds_alternative<Capsule>(shape);
  }
};

ConvexHull Cuboid(const Vector3d& half_extents) {
  ConvexHull hull;
  for (int i = 0; i < 8; ++i) {
    const Vector3d signs((i & 1) != 0 ? 1 : -1, (i & 2) != 0 ? 1 : -1,
                         (i & 4) != 0 ? 1 : -1);
    hull.vertices.emplace_back(signs.cwiseProduct(half_extents));
  }
  return hull;
}

Feature FeatureOf(ShapeKind kind) {
  const Vector3d x = Vector3d::UnitX();
  const Vector3d z = Vector3d::UnitZ();
  switch (kind) {
    case ShapeKind::kSphere: {
      const Vector3d n = Vector3d(0.3, -0.5, 0.8).normalized();
      return {Sphere{0.37}, 0.37 * n, n};
    }
    case ShapeKind::kBox:
      return {Box{{0.41, 0.33, 0.27}}, 0.27 * z, z};
    case ShapeKind::kCapsule:
      return {Capsule{0.23, 0.31}, 0.23 * x, x};
    case ShapeKind::kCylinder:
      return {Cylinder{0.35, 0.29}, 0.29 * z, z};
    case ShapeKind::kCone:
      return {Cone{0.43, 0.34}, -0.34 * z, -z};
    case ShapeKind::kConvexHull:
      return {Cuboid({0.25, 0.44, 0.38}), -0.25 * x, -x};
    case ShapeKind::kHalfSpace:
      return {HalfSpace{}, Vector3d::Zero(), z};
  }
  return {};
}

// The rotation that takes the unit vector `from` to `to`, then by the angle `spin` about
// it.
Matrix3d Turn(const Vector3d& from, const Vector3d& to, double spin) {
  return (Eigen::AngleAxisd(spin, to) * Eigen::Quaterniond::FromTwoVectors(from, to))
      .toRotationMatrix();
}

}  // namespace

ConstructedContact PutTogether(ShapeKind a, ShapeKind b, double separation) {
  const Feature A = FeatureOf(a);
  const Feature B = FeatureOf(b);
  const Vector3d n_W = Vector3d(-0.48, 0.61, 0.35).normalized();
  const Vector3d p_WM(0.83, -1.27, 2.09);
  const Vector3d sideways = n_W.cross(Vector3d(0.2, 0.9, -0.4)).normalized();

  const Matrix3d R_WA = Turn(A.n_B, n_W, 0.4);
  const Matrix3d R_WB = Turn(B.n_B, -n_W, 1.1);
  const Vector3d p_WFa = p_WM - separation / 2 * n_W;
  // Much smaller than the width of any feature, much larger than rounding.
  const double shift = A.is_flat() || B.is_flat() ? 0.031 : 0;
  const Vector3d p_WFb = p_WM + separation / 2 * n_W + shift * sideways;
  return {{{A.shape, Pose::FromMatrix(p_WFa - R_WA * A.p_B, R_WA)},
           {B.shape, Pose::FromMatrix(p_WFb - R_WB * B.p_B, R_WB)}},
          n_W,
          separation,
          p_WM};
}

std::vector<std::pair<ShapeKind, ShapeKind>> AllPairs() {
  std::vector<std::pair<ShapeKind, ShapeKind>> pairs;
  for (int a = 0; a < kShapeKinds; ++a) {
    for (int b = 0; b < kShapeKinds; ++b) {
      pairs.emplace_back(static_cast<ShapeKind>(a), static_cast<ShapeKind>(b));
    }
  }
  return pairs;
}

namespace {

/** Returns three draws of `number`. Each has its own statement, because the compiler
 chooses the order within one expression. */
template <typename Distribution>
Vector3d Three(Distribution& number, std::mt19937_64& random) {
  const double z = number(random);
  const double y = number(random);
  const double x = number(random);
  return {x, y, z};
}

}  // namespace

Shape RandomShape(ShapeKind kind, std::mt19937_64& random) {
  std::uniform_real_distribution<double> size(0.2, 1);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  const auto s = [&] { return size(random); };
  switch (kind) {
    case ShapeKind::kSphere:
      return Sphere{s()};
    case ShapeKind::kBox:
      return Box{{s(), s(), s()}};
    case ShapeKind::kCapsule:
      return Capsule{s() / 2, s()};
    case ShapeKind::kCylinder:
      return Cylinder{s(), s()};
    case ShapeKind::kCone:
      return Cone{s(), s()};
    case ShapeKind::kConvexHull: {
      ConvexHull hull;
      for (int i = 0; i < 14; ++i) {
        hull.vertices.push_back(Three(coordinate, random));
      }
      return hull;
    }
    case ShapeKind::kHalfSpace:
      return HalfSpace{};
  }
  return {};
}

Pose RandomPose(double reach, std::mt19937_64& random) {
  std::uniform_real_distribution<double> coordinate(-reach, reach);
  std::normal_distribution<double> normal;
  const Vector3d imaginary = Three(normal, random);
  const double real = normal(random);
  const Eigen::Quaterniond q =
      Eigen::Quaterniond(real, imaginary.x(), imaginary.y(), imaginary.z()).normalized();
  return Pose::FromQuaternion(Three(coordinate, random), q);
}

void ExpectMatches(const ContactAnswer& answer, const ConstructedContact& truth,
                   const Allowed& allowed) {
  ASSERT_EQ(answer.status, AnswerStatus::kAnswered) << answer.reason;
  EXPECT_EQ(answer.touching, truth.separation <= 0);
  if (answer.separation) {
    EXPECT_NEAR(*answer.separation, truth.separation, allowed.length);
  }
  if (answer.n_AB_W) {
    EXPECT_LE((*answer.n_AB_W - truth.n_AB_W).norm(), allowed.angle);
  }
  for (const ContactPoint& point : answer.points) {
    const bool is_deepest =
        std::abs(point.separation - truth.separation) <= allowed.length;
    if (!is_deepest) continue;
    EXPECT_NEAR(truth.n_AB_W.dot(point.p_WC - truth.p_WM), 0, allowed.point);
  }
  if (answer.witnesses) {
    EXPECT_NEAR(HeightAboveSurface(truth.query.A, answer.witnesses->p_WCa), 0,
                allowed.length);
    EXPECT_NEAR(HeightAboveSurface(truth.query.B, answer.witnesses->p_WCb), 0,
                allowed.length);
  }
}

}  // namespace touchstone
