#pragma once

#include "oracles/contact_answer.h"
#include "scenarios/contact_query.h"

namespace touchstone {

/** Returns the points p − n s/2 and p + n s/2 of a contact with the unit normal `n_AB_W`.
 In the project's convention (oracles/contact_answer.h) a contact lies midway through the
 overlap, so these two are its points on A and on B. Source: the convention; the same
 identity defines Drake's penetration_as_point_pair.h:17. */
WitnessPoints SurfacePointsOf(const ContactPoint& contact, const Eigen::Vector3d& n_AB_W);

/** Returns the distance of two points from the surfaces of A and B, the larger of the
 two, as far as it is proved. [m] */
double SurfaceError(const ContactQuery& query, const WitnessPoints& points);

}  // namespace touchstone
