#include "scenarios/generators/random_shape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "scenarios/generators/hull_facets.h"
#include "scenarios/generators/portable_math.h"

namespace touchstone {
namespace {

/** Returns three random lengths, drawn in order (the evaluation order of call arguments
 is unspecified). */
Eigen::Vector3d Lengths(Random& random) {
  const double x = random.Uniform(0.2, 1.2);
  const double y = random.Uniform(0.2, 1.2);
  const double z = random.Uniform(0.2, 1.2);
  return {x, y, z};
}

/** Returns six points of the unit sphere, one near each half axis. */
std::vector<Eigen::Vector3d> PointsNearAxes(Random& random) {
  std::vector<Eigen::Vector3d> points;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {-1.0, 1.0}) {
      const double u = random.Uniform(-0.3, 0.3);
      const double v = random.Uniform(-0.3, 0.3);
      Eigen::Vector3d point;
      point[axis] = sign;
      point[(axis + 1) % 3] = u;
      point[(axis + 2) % 3] = v;
      points.push_back(Unit(point));
    }
  }
  return points;
}

/** Returns the hull of `points` and `others` more points of the unit sphere, scaled to an
 ellipsoid. */
ConvexHull HullOf(std::vector<Eigen::Vector3d> points, int others,
                  const Eigen::Vector3d& axes, Random& random) {
  for (int i = 0; i < others; ++i) points.push_back(random.Direction());
  for (Eigen::Vector3d& point : points) point = point.cwiseProduct(axes);
  return {points};
}

ConvexHull RandomHull(const Eigen::Vector3d& axes, Random& random) {
  // Points on the unit sphere, so that all are corners: one near each half axis, so that
  // the hull contains the origin, the rest anywhere. They are then scaled to an
  // ellipsoid. Take a unit n with S = Σ|n_i|. The mean of the three points near n's own
  // half axes, weighted by |n_i|, reaches (1 − 0.3 (S² − 1)) / (√1.18 S) along n: at
  // least 0.21, at S = √3. So the hull contains its ellipsoid scaled by 0.21, and thus a
  // ball of 0.04 m.
  const std::vector<Eigen::Vector3d> points = PointsNearAxes(random);
  const int others = 2 + random.Below(5);
  return HullOf(points, others, axes, random);
}

Shape ShapeOfSizes(ShapeKind kind, const Eigen::Vector3d& sizes, Random& random) {
  switch (kind) {
    case ShapeKind::kSphere:
      return Sphere{sizes[0]};
    case ShapeKind::kBox:
      return Box{sizes};
    case ShapeKind::kCapsule:
      return Capsule{sizes[0], sizes[1]};
    case ShapeKind::kCylinder:
      return Cylinder{sizes[0], sizes[1]};
    case ShapeKind::kCone:
      return Cone{sizes[0], sizes[1]};
    case ShapeKind::kConvexHull:
      return RandomHull(sizes, random);
    case ShapeKind::kHalfSpace:
      return HalfSpace{};
  }
  return HalfSpace{};
}

/** Returns the distance of a cone's lateral surface from its origin, which is at
 mid-height. The line from the apex (0, h) to the rim (r, −h) has the normal (2h, r). */
double DistanceToLateralSurface(const Cone& cone) {
  const double r = cone.radius, h = cone.half_height;
  return r * h / std::sqrt(4 * h * h + r * r);
}

struct InnerRadiusOf {
  double operator()(const Sphere& sphere) const { return sphere.radius; }
  double operator()(const Box& box) const { return box.half_extents.minCoeff(); }
  double operator()(const Capsule& capsule) const { return capsule.radius; }
  double operator()(const Cylinder& cylinder) const {
    return std::min(cylinder.radius, cylinder.half_length);
  }
  double operator()(const Cone& cone) const {
    return std::min(cone.half_height, DistanceToLateralSurface(cone));
  }
  double operator()(const ConvexHull& hull) const {
    double radius = std::numeric_limits<double>::infinity();
    for (const Facet& facet : FacetsOf(hull)) {
      radius = std::min(radius, Dot(facet.n_B, hull.vertices[facet.vertices[0]]));
    }
    return radius;
  }
  double operator()(const HalfSpace&) const { return 0; }
};

struct ThicknessOf {
  double operator()(const Sphere& sphere) const { return sphere.radius; }
  double operator()(const Box& box) const { return box.half_extents.minCoeff(); }
  double operator()(const Capsule& capsule) const {
    return std::min(capsule.radius, capsule.half_length);
  }
  double operator()(const Cylinder& cylinder) const {
    return std::min(cylinder.radius, cylinder.half_length);
  }
  double operator()(const Cone& cone) const {
    return std::min(cone.radius, cone.half_height);
  }
  double operator()(const ConvexHull& hull) const { return InnerRadiusOf{}(hull); }
  double operator()(const HalfSpace&) const { return 1; }
};

struct SupportPointAlong {
  const Eigen::Vector3d& n;

  Eigen::Vector3d RimPoint(double radius, double z) const {
    const double radial = std::sqrt(n.x() * n.x() + n.y() * n.y());
    if (radial == 0) return {0, 0, z};
    return {radius * (n.x() / radial), radius * (n.y() / radial), z};
  }

  Eigen::Vector3d operator()(const Sphere& sphere) const { return sphere.radius * n; }
  Eigen::Vector3d operator()(const Box& box) const {
    Eigen::Vector3d corner = box.half_extents;
    for (int i = 0; i < 3; ++i) {
      if (n[i] < 0) corner[i] = -corner[i];
    }
    return corner;
  }
  Eigen::Vector3d operator()(const Capsule& capsule) const {
    const double z = n.z() < 0 ? -capsule.half_length : capsule.half_length;
    return capsule.radius * n + z * Eigen::Vector3d::UnitZ();
  }
  Eigen::Vector3d operator()(const Cylinder& cylinder) const {
    return RimPoint(cylinder.radius,
                    n.z() < 0 ? -cylinder.half_length : cylinder.half_length);
  }
  Eigen::Vector3d operator()(const Cone& cone) const {
    const Eigen::Vector3d apex(0, 0, cone.half_height);
    const Eigen::Vector3d rim = RimPoint(cone.radius, -cone.half_height);
    return Dot(n, apex) < Dot(n, rim) ? rim : apex;
  }
  Eigen::Vector3d operator()(const ConvexHull& hull) const {
    return *std::max_element(hull.vertices.begin(), hull.vertices.end(),
                             [this](const Eigen::Vector3d& v, const Eigen::Vector3d& w) {
                               return Dot(n, v) < Dot(n, w);
                             });
  }
  Eigen::Vector3d operator()(const HalfSpace&) const { return Eigen::Vector3d::Zero(); }
};

}  // namespace

Shape RandomShape(ShapeKind kind, Random& random) {
  const Eigen::Vector3d sizes = Lengths(random);
  return ShapeOfSizes(kind, sizes, random);
}

Shape RandomLargeShape(ShapeKind kind, Random& random) {
  if (kind != ShapeKind::kConvexHull) return RandomShape(kind, random);
  constexpr std::array<int, 7> kVertices = {16, 32, 64, 125, 250, 500, 1000};
  const Eigen::Vector3d axes = Lengths(random);
  const std::vector<Eigen::Vector3d> points = PointsNearAxes(random);
  const int vertices = kVertices[static_cast<std::size_t>(random.Below(7))];
  return HullOf(points, vertices - static_cast<int>(points.size()), axes, random);
}

Shape RandomThinShape(ShapeKind kind, Random& random) {
  Eigen::Vector3d sizes = Lengths(random);
  const double thinner = random.Decades(-4, -1);
  // The indices of the thin sizes: one or two out of three, but exactly one of the two
  // that round shapes use.
  constexpr std::array<std::array<int, 2>, 6> kThin = {
      {{0, 0}, {1, 1}, {0, 2}, {1, 2}, {0, 2}, {1, 1}}};
  const std::array<int, 2> thin = kind == ShapeKind::kSphere
                                      ? kThin[0]
                                      : kThin[static_cast<std::size_t>(random.Below(6))];
  sizes[thin[0]] *= thinner;
  if (thin[1] != thin[0]) sizes[thin[1]] *= thinner;
  return ShapeOfSizes(kind, sizes, random);
}

double Thickness(const Shape& shape) {
  return std::visit(ThicknessOf{}, shape);
}

double InnerRadius(const Shape& shape) {
  return std::visit(InnerRadiusOf{}, shape);
}

Eigen::Vector3d SupportPoint(const Shape& shape, const Eigen::Vector3d& n_B) {
  return std::visit(SupportPointAlong{n_B}, shape);
}

}  // namespace touchstone
