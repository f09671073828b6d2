#pragma once

#include <string>

#include <Eigen/Core>

#include "scenarios/shape.h"

namespace touchstone {

/** Returns an expression that creates the geom of `shape` in no space; "" for a
 half-space, whose geom needs the pose. Throws CannotReproduce, also for a hull, whose
 geom needs arrays: OdeConvexOf(). */
std::string OdeShape(const Shape& shape);

/** A convex geom of ODE, as in the adapter (oracles/ode/ode_geom.cc). */
struct OdeConvex {
  std::string definition;    ///< Statements that define the geom and its arrays.
  Eigen::Vector3d origin_B;  ///< The geom's origin in the frame of the hull. [m]
};

/** Returns the geom `name` of a hull in no space. Throws CannotReproduce for a flat one,
 which has no faces. */
OdeConvex OdeConvexOf(char name, const ConvexHull& hull);

/** Returns the CMake lines that define the target `engine` as ODE. */
std::string FindOde();

}  // namespace touchstone
