#pragma once

#include <array>

#include "reports/referee/precise.h"
#include "reports/referee/vector.h"
#include "scenarios/contact_query.h"

namespace touchstone::referee {

/** A point of A and a point of B, each as a convex combination, with the same weights, of
 points in the body frames. For a sphere or a capsule the points are those of its core. */
template <typename Real>
struct Witnesses {
  std::array<Vector<Real>, 4> q_A;  ///< [m]
  std::array<Vector<Real>, 4> q_B;  ///< [m]
  std::array<Real, 4> weights;      ///< Positive, not normalised.
  int count = 0;                    ///< 0 if there are no witnesses.
};

/** Returns an upper bound on the signed separation that `witnesses` prove: the distance
 of both points, less the radii of spheres and capsules. Infinite if a point is not
 certainly in its shape, or a weight not positive. It shares no formula with the searches,
 like SupportOf(). [m]
 @pre Neither body is a half-space. */
template <typename Real>
double ProvedSeparation(const ContactQuery& query, const Witnesses<Real>& witnesses);

/** Returns an upper bound on the signed separation of the shapes: `most`, an upper bound
 on that of their cores [m], less the radii of both shapes. [m] */
template <typename Real>
double LessRadii(const ContactQuery& query, double most);

}  // namespace touchstone::referee
