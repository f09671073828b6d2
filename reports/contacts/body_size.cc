#include "reports/contacts/body_size.h"

#include <algorithm>
#include <limits>
#include <variant>

#include <Eigen/Core>

namespace touchstone {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Eigen::Vector3d SidesOf(const ConvexHull& hull) {
  Eigen::Vector3d lo = Eigen::Vector3d::Constant(kInfinity);
  Eigen::Vector3d hi = -lo;
  for (const Eigen::Vector3d& v : hull.vertices) {
    lo = lo.cwiseMin(v);
    hi = hi.cwiseMax(v);
  }
  return hi - lo;
}

struct FeatureOf {
  double operator()(const Sphere& sphere) const { return sphere.radius; }
  double operator()(const Box& box) const { return box.half_extents.minCoeff(); }
  double operator()(const Capsule& capsule) const { return capsule.radius; }
  double operator()(const Cylinder& cylinder) const {
    return std::min(cylinder.radius, cylinder.half_length);
  }
  double operator()(const Cone& cone) const {
    return std::min(cone.radius, cone.half_height);
  }
  double operator()(const ConvexHull& hull) const {
    const Eigen::Vector3d sides = SidesOf(hull);
    // A flat hull has no thickness; its extents within the plane are its features.
    const double none = 0x1p-40 * sides.maxCoeff();
    double least = sides.maxCoeff();
    for (const double side : {sides.x(), sides.y(), sides.z()}) {
      if (side > none) least = std::min(least, side);
    }
    return least / 2;
  }
  double operator()(const HalfSpace&) const { return kInfinity; }
};

/** Returns the greatest extent of a shape, infinite for a half-space. [m] */
double ExtentOf(const Shape& shape) {
  if (const auto* hull = std::get_if<ConvexHull>(&shape)) return SidesOf(*hull).norm();
  if (std::holds_alternative<HalfSpace>(shape)) return kInfinity;
  return 2 * BoundingRadius(shape);
}

}  // namespace

double SmallestFeature(const ContactQuery& query) {
  return std::min(std::visit(FeatureOf{}, query.A.shape),
                  std::visit(FeatureOf{}, query.B.shape));
}

double SmallerExtent(const ContactQuery& query) {
  return std::min(ExtentOf(query.A.shape), ExtentOf(query.B.shape));
}

double SumOfExtents(const ContactQuery& query) {
  double sum = 0;
  for (const Body* body : {&query.A, &query.B}) {
    const double extent = ExtentOf(body->shape);
    if (extent < kInfinity) sum += extent;
  }
  return sum;
}

}  // namespace touchstone
