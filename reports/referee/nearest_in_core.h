#pragma once

#include <optional>

#include "reports/referee/core_truth.h"

namespace touchstone::referee {

/** Returns the point of a core that is nearest to a point outside it, and the direction
 from there, by closed forms in the frame of the body, in double-double. It is a guess:
 the forms hold for a rotation, which a matrix of doubles almost is, and Proved() proves
 bounds from it. Near a surface the direction is the normal of the face that the point is
 farthest beyond; elsewhere it is the difference of both points.

 `separation` of the result has no meaning. Empty for hulls, which have no closed form,
 and for a point that is not outside.
 @pre `M` is the difference of any core and a point. */
std::optional<CoreTruth<DoubleDouble>> NearestInCore(const MinkowskiDifference& M);

}  // namespace touchstone::referee
