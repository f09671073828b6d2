#pragma once

#include <vector>

#include <Eigen/Core>

#include "oracles/contact_answer.h"
#include "scenarios/contact_query.h"

namespace touchstone {

class JudgedAnswer;

/** Returns the points p − n s/2 and p + n s/2 of a contact with the unit normal `n_AB_W`.
 In the project's convention (oracles/contact_answer.h) a contact lies midway through the
 overlap, so these two are its points on A and on B. Source: the convention; the same
 identity defines Drake's penetration_as_point_pair.h:17. */
WitnessPoints SurfacePointsOf(const ContactPoint& contact, const Eigen::Vector3d& n_AB_W);

/** Returns the distance of two points from the surfaces of A and B, the larger of the
 two, as far as it is proved. [m] */
double SurfaceError(const ContactQuery& query, const WitnessPoints& points);

/** The points of a contact on both bodies, or the witness points. */
struct PointsOnSurfaces {
  WitnessPoints points;
  Eigen::Vector3d n_W;  ///< The unit normal; zero if there is none to judge.
  double gap;           ///< The separation of a contact; 0 for witness points. [m]
};

/** Returns all of an answer: of the witness points, then of each contact. Witness points
 of bodies that are apart have no normal to judge, since their duality gap is judged. */
std::vector<PointsOnSurfaces> AllPointsOf(const JudgedAnswer& judged);

/** Judges whether all points of contacts lie on the surfaces. */
void CheckSurfacePoints(JudgedAnswer& judged);

}  // namespace touchstone
