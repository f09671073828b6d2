#pragma once

#include <dart/dynamics/Shape.hpp>

#include "scenarios/pose.h"
#include "scenarios/shape.h"

namespace touchstone {

/** Returns a sphere or a box as DART has it. @pre It is one of them. */
dart::dynamics::ShapePtr ToDart(const Shape& shape);

/** Returns the pose with the very matrix that was asked about. */
Eigen::Isometry3d ToDart(const Pose& X_WB);

}  // namespace touchstone
