#pragma once

#include <string>

#include "scenarios/shape.h"

namespace touchstone {

/** Returns an expression that creates the shape. @pre It is a sphere or a box. */
std::string DartShape(const Shape& shape);

/** Returns the CMake lines that define the target `engine` as DART. */
std::string FindDart();

}  // namespace touchstone
