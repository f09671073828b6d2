#pragma once

#include "oracles/contact_answer.h"
#include "scenarios/contact_query.h"

namespace touchstone {

/** Returns the distance of the points p − n s/2 and p + n s/2 of a contact from the
 surfaces of A and B, the larger of the two, as far as it is proved. [m] In the project's
 convention (oracles/contact_answer.h) a contact lies midway through the overlap, so these
 two are its points on A and on B. The contact's own normal is used if it has one,
 otherwise `n_AB_W`. Source: the convention; the same identity defines Drake's
 penetration_as_point_pair.h:17. */
double ContactSurfaceError(const ContactQuery& query, const Eigen::Vector3d& n_AB_W,
                           const ContactPoint& contact);

/** Returns the distance of the witness points from the surfaces of their bodies, the
 larger of the two. [m] */
double WitnessSurfaceError(const ContactQuery& query, const WitnessPoints& witnesses);

}  // namespace touchstone
