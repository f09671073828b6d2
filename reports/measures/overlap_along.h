#pragma once

#include <Eigen/Core>

#include "reports/referee/contact_truth.h"
#include "scenarios/contact_query.h"

namespace touchstone {

/** Returns an enclosure of the overlap o(n) = max_A n·x − min_B n·x, for half-spaces too.
 [m] The overlap of a half-space is infinite along every direction except its own normal
 h, and no rounded normal equals h. Here the half-space is cut off at the size L of the
 scene. Its overlap along n is that along h plus |n − h| L, the most by which tilting the
 plane by that much lifts it within reach. A normal off by an ulp then costs an ulp.
 @pre `n_W` is finite and not zero.
 @see reports/referee/referee.h, Overlap(). */
Enclosure OverlapAlong(const ContactQuery& query, const Eigen::Vector3d& n_W);

/** Returns the direction to pass to the referee in place of `n_W`: the normal of a
 half-space, from A to B, if the query has one, otherwise `n_W` itself. */
Eigen::Vector3d SupportingDirection(const ContactQuery& query,
                                    const Eigen::Vector3d& n_W);

}  // namespace touchstone
