#include <algorithm>
#include <cstddef>

#include <Eigen/Geometry>

#include "reports/shrink/reductions.h"

namespace touchstone {
namespace {

/** Returns the half extents of a box along the body axes that holds `shape`. A hull need
 not be centred on its origin; the box is. [m] @pre It is no half-space. */
struct HalfExtents {
  Eigen::Vector3d operator()(const Sphere& s) const {
    return Eigen::Vector3d::Constant(s.radius);
  }
  Eigen::Vector3d operator()(const Box& s) const { return s.half_extents; }
  Eigen::Vector3d operator()(const Capsule& s) const {
    return {s.radius, s.radius, s.half_length + s.radius};
  }
  Eigen::Vector3d operator()(const Cylinder& s) const {
    return {s.radius, s.radius, s.half_length};
  }
  Eigen::Vector3d operator()(const Cone& s) const {
    return {s.radius, s.radius, s.half_height};
  }
  Eigen::Vector3d operator()(const ConvexHull& s) const {
    Eigen::Vector3d most = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& vertex : s.vertices)
      most = most.cwiseMax(vertex.cwiseAbs());
    return most;
  }
  Eigen::Vector3d operator()(const HalfSpace&) const { return Eigen::Vector3d::Zero(); }
};

std::vector<Shape> SimplerThan(const Shape& shape) {
  if (KindOf(shape) == ShapeKind::kHalfSpace || KindOf(shape) == ShapeKind::kSphere)
    return {};
  const Eigen::Vector3d half = std::visit(HalfExtents{}, shape);
  std::vector<Shape> simpler = {Sphere{half.minCoeff()}, Sphere{half.maxCoeff()}};
  if (KindOf(shape) == ShapeKind::kBox) return simpler;
  simpler.emplace_back(Box{half});
  if (const auto* const capsule = std::get_if<Capsule>(&shape))
    simpler.emplace_back(Box{{capsule->radius, capsule->radius, capsule->half_length}});
  if (const auto* const cone = std::get_if<Cone>(&shape))
    simpler.emplace_back(Cylinder{cone->radius, cone->half_height});
  return simpler;
}

}  // namespace

void SimplerShapes(const Question& question, const Candidates& take) {
  const std::vector<const Body*> bodies = BodiesOf(question);
  const auto add = [&](std::size_t i, const Shape& shape) {
    Question simpler = question;
    BodiesOf(simpler)[i]->shape = shape;
    take(std::move(simpler));
  };
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    for (const Shape& shape : SimplerThan(bodies[i]->shape)) add(i, shape);
  }
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    for (std::size_t j = 0; j < bodies.size(); ++j) {
      if (i != j) add(i, bodies[j]->shape);
    }
  }
}

}  // namespace touchstone
