#pragma once

#include "reports/referee/contact_truth.h"
#include "scenarios/contact_query.h"

namespace touchstone {

/** The comparison of an enclosure with the separation computed exactly, in rational
 arithmetic. */
struct ExactComparison {
  bool lo_holds;      ///< lo <= the exact separation.
  bool hi_holds;      ///< hi >= the exact separation.
  double separation;  ///< The exact separation, to rounding. [m]
};

/** Compares `separation` with the exact separation of `query` by CGAL's exact kernel,
 which shares nothing with the referee: the convex hull of all differences of corners, and
 the least distance of the origin from its facets.
 @pre Both shapes are boxes or hulls, and their difference has a volume. */
ExactComparison CompareExactly(const ContactQuery& query, const Enclosure& separation);

}  // namespace touchstone
