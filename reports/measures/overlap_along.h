#pragma once

#include <Eigen/Core>

#include "reports/referee/contact_truth.h"
#include "scenarios/contact_query.h"

namespace touchstone {

/** Returns an enclosure of the overlap o(n) = max_A n·x − min_B n·x, for half-spaces too.
 [m]

 A half-space overlaps without end along every direction but its own normal h, which no
 rounded normal can hit. Here it is cut off at the size L of the scene, and its overlap
 along n is that along h plus |n − h| L: the most by which tilting the plane by that much
 lifts it within reach. A normal off by an ulp then costs an ulp.

 @pre `n_W` is finite and not zero.
 @see reports/referee/referee.h, Overlap(). */
Enclosure OverlapAlong(const ContactQuery& query, const Eigen::Vector3d& n_W);

/** Returns the direction along which the referee can be asked in place of `n_W`: the
 normal of a half-space, from A to B, where the query has one, else `n_W` itself. */
Eigen::Vector3d SupportingDirection(const ContactQuery& query,
                                    const Eigen::Vector3d& n_W);

}  // namespace touchstone
