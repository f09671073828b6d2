#pragma once

#include <string>

#include "scenarios/shape.h"

namespace touchstone {

/** Returns an expression that creates the geom of `shape` in no space; "" for a
 half-space, whose geom needs the pose. Throws CannotReproduce. */
std::string OdeShape(const Shape& shape);

/** Returns the CMake lines that define the target `engine` as ODE. */
std::string FindOde();

}  // namespace touchstone
