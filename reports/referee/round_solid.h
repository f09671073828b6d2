#pragma once

#include <optional>

#include "reports/referee/minkowski_difference.h"

namespace touchstone::referee {

/** Returns the signed distance of a point from a cylinder or a cone, in closed form,
 where M is the difference of such a pair, in either order, and the matrix is a rotation
 to rounding. Empty for other pairs. [m]

 In the plane of the axis and the point the solid is a rectangle or a triangle. The matrix
 stretches by factors in 1 ± 2δ, δ its orthonormality defect (input_rounding.cc), and with
 it every distance from the surface. */
std::optional<Enclosure> DistanceFromRoundSolid(const MinkowskiDifference& M);

}  // namespace touchstone::referee
