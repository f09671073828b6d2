#pragma once

#include <Eigen/Core>

#include "scenarios/contact_query.h"

namespace touchstone {

/** Returns |−separation − o(n)|: does the depth of an answer agree with its own normal.
 [m]

 Moving B by o(n) = max_A n·x − min_B n·x along n just separates the shapes; an answer of
 depth d along n claims o(n) = d, whether or not n is the best direction. Holds apart as
 well, where −o(n) is the gap along n. Needs no truth beyond support functions. Source:
 Ericson, Real-Time Collision Detection (2005), §4.4.1 and §5.2.1.
 @pre `n_W` is finite and not zero. */
double ConsistencyError(const ContactQuery& query, const Eigen::Vector3d& n_W,
                        double separation);

}  // namespace touchstone
