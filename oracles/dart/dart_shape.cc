#include "oracles/dart/dart_shape.h"

#include <memory>
#include <variant>

#include <dart/dynamics/BoxShape.hpp>
#include <dart/dynamics/SphereShape.hpp>

namespace touchstone {

dart::dynamics::ShapePtr ToDart(const Shape& shape) {
  if (const auto* sphere = std::get_if<Sphere>(&shape))
    return std::make_shared<dart::dynamics::SphereShape>(sphere->radius);
  const Eigen::Vector3d sides = 2 * std::get<Box>(shape).half_extents;
  return std::make_shared<dart::dynamics::BoxShape>(sides);
}

Eigen::Isometry3d ToDart(const Pose& X_WB) {
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  X.linear() = X_WB.R_WB;
  X.translation() = X_WB.p_WB;
  return X;
}

}  // namespace touchstone
