#include "oracles/libccd/ccd_body.h"

#include <cmath>
#include <variant>

#include <ccd/vec3.h>

namespace touchstone {
namespace {

using Eigen::Vector3d;

// ccdSign() is 0 within CCD_EPS of 0.
double Sign(double x) {
  return ccdSign(x);
}

struct Support {
  Vector3d d;  // Body frame.

  // The support point of a disc of `radius` in the xy plane.
  Vector3d OnDisc(double radius) const {
    const double length = std::hypot(d.x(), d.y());
    if (ccdIsZero(length)) return Vector3d::Zero();
    return {radius / length * d.x(), radius / length * d.y(), 0};
  }

  Vector3d operator()(const Sphere& s) const { return s.radius * d.normalized(); }
  Vector3d operator()(const Box& s) const {
    return Vector3d(Sign(d.x()), Sign(d.y()), Sign(d.z())).cwiseProduct(s.half_extents);
  }
  Vector3d operator()(const Capsule& s) const {
    return s.radius * d.normalized() + Sign(d.z()) * s.half_length * Vector3d::UnitZ();
  }
  Vector3d operator()(const Cylinder& s) const {
    return OnDisc(s.radius) + Sign(d.z()) * s.half_length * Vector3d::UnitZ();
  }
  Vector3d operator()(const Cone& s) const {
    const Vector3d apex = s.half_height * Vector3d::UnitZ();
    const Vector3d rim = OnDisc(s.radius) - apex;
    return d.dot(apex) > d.dot(rim) ? apex : rim;
  }
  Vector3d operator()(const ConvexHull& s) const {
    const Vector3d* farthest = &s.vertices.front();
    for (const Vector3d& vertex : s.vertices) {
      if (d.dot(vertex) > d.dot(*farthest)) farthest = &vertex;
    }
    return *farthest;
  }
  Vector3d operator()(const HalfSpace&) const { return Vector3d::Zero(); }
};

}  // namespace

Eigen::Vector3d CcdSupport(const Body& body, const Eigen::Vector3d& direction_W) {
  const Vector3d direction_B = body.X_WB.R_WB.transpose() * direction_W;
  return body.X_WB * std::visit(Support{direction_B}, body.shape);
}

Eigen::Vector3d CcdCentre(const Body& body) {
  const auto* hull = std::get_if<ConvexHull>(&body.shape);
  if (hull == nullptr) return body.X_WB.p_WB;
  Vector3d sum = Vector3d::Zero();
  for (const Vector3d& vertex : hull->vertices) sum += vertex;
  return body.X_WB * Vector3d(sum / static_cast<double>(hull->vertices.size()));
}

}  // namespace touchstone
