#include "scenarios/shape.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace touchstone {
namespace {

struct Radius {
  double operator()(const Sphere& sphere) const { return sphere.radius; }
  double operator()(const Box& box) const { return box.half_extents.norm(); }
  double operator()(const Capsule& capsule) const {
    return capsule.half_length + capsule.radius;
  }
  double operator()(const Cylinder& cylinder) const {
    return std::hypot(cylinder.radius, cylinder.half_length);
  }
  double operator()(const Cone& cone) const {
    return std::hypot(cone.radius, cone.half_height);
  }
  double operator()(const ConvexHull& hull) const {
    double square = 0;
    for (const Eigen::Vector3d& v : hull.vertices)
      square = std::max(square, v.squaredNorm());
    return std::sqrt(square);
  }
  double operator()(const HalfSpace&) const { return 0; }
};

struct ResizedBy {
  double factor;

  Shape operator()(const Sphere& sphere) const { return Sphere{factor * sphere.radius}; }
  Shape operator()(const Box& box) const { return Box{factor * box.half_extents}; }
  Shape operator()(const Capsule& capsule) const {
    return Capsule{factor * capsule.radius, factor * capsule.half_length};
  }
  Shape operator()(const Cylinder& cylinder) const {
    return Cylinder{factor * cylinder.radius, factor * cylinder.half_length};
  }
  Shape operator()(const Cone& cone) const {
    return Cone{factor * cone.radius, factor * cone.half_height};
  }
  Shape operator()(const ConvexHull& hull) const {
    ConvexHull resized = hull;
    for (Eigen::Vector3d& vertex : resized.vertices) vertex *= factor;
    return resized;
  }
  Shape operator()(const HalfSpace& half_space) const { return half_space; }
};

}  // namespace

ShapeKind KindOf(const Shape& shape) {
  return static_cast<ShapeKind>(shape.index());
}

std::string_view NameOf(ShapeKind kind) {
  constexpr std::array<std::string_view, kShapeKinds> kNames = {
      "sphere", "box", "capsule", "cylinder", "cone", "convex_hull", "half_space"};
  return kNames[static_cast<std::size_t>(kind)];
}

double BoundingRadius(const Shape& shape) {
  return std::visit(Radius{}, shape);
}

Shape Resized(const Shape& shape, double factor) {
  return std::visit(ResizedBy{factor}, shape);
}

}  // namespace touchstone
