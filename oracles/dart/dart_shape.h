#pragma once

#include <dart/dynamics/Shape.hpp>

#include "scenarios/pose.h"
#include "scenarios/shape.h"

namespace touchstone {

/** Returns a sphere or a box in DART's type. @pre `shape` is one of these. */
dart::dynamics::ShapePtr ToDart(const Shape& shape);

/** Returns the pose in DART's type, with the same rotation matrix bit for bit. */
Eigen::Isometry3d ToDart(const Pose& X_WB);

}  // namespace touchstone
