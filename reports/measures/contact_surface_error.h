#pragma once

#include "oracles/contact_answer.h"
#include "scenarios/contact_query.h"

namespace touchstone {

/** Returns how far the points p − n s/2 and p + n s/2 of a contact are from the surfaces
 of A and B, the larger of the two, as far as it is proved. [m]

 By the project's convention (oracles/contact_answer.h) a contact lies midway through the
 overlap, so that these two are its points on A and on B. The contact's own normal is used
 where it has one, else `n_AB_W`.
 Source: the convention; the same identity defines Drake's penetration_as_point_pair.h:17.
 */
double ContactSurfaceError(const ContactQuery& query, const Eigen::Vector3d& n_AB_W,
                           const ContactPoint& contact);

/** Returns how far witness points are from the surfaces of their bodies, the larger. [m]
 */
double WitnessSurfaceError(const ContactQuery& query, const WitnessPoints& witnesses);

}  // namespace touchstone
