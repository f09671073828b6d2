#pragma once

#include <Eigen/Core>

#include "scenarios/contact_query.h"

namespace touchstone::referee {

/** Returns true only if the point `p_W` is certainly farther than `distance` [m] from
 `body`; false proves nothing. It is a filter in double before SignedDistance(), for which
 it can only save time: a plane proves the distance, whatever direction is tried.

 Tried are `n_W`, and the direction from the nearest point of a core that is a point, a
 segment or a box.
 @pre The rounding mode is to nearest: the error bounds are those of standard
 arithmetic. */
bool IsProvedFarther(const Body& body, const Eigen::Vector3d& p_W,
                     const Eigen::Vector3d& n_W, double distance);

}  // namespace touchstone::referee
