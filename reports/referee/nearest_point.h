#pragma once

#include <array>

#include "reports/referee/minkowski_difference.h"

namespace touchstone::referee {

/** Up to four points of M with positive weights: a convex mixture of them, v, and what it
 says about the origin. */
template <typename Real>
struct Simplex {
  std::array<DifferencePoint<Real>, 4> points;
  std::array<Real, 4> weights;  ///< Positive, not normalised.
  int count = 0;
  Vector<Real> v;                ///< The mixture, to rounding. [m]
  bool encloses_origin = false;  ///< A tetrahedron around the origin, to rounding.
};

/** Searches for the point of M nearest to the origin: GJK with every face of the simplex
 tried, so that no rounding sends it down a wrong branch. Starts from `start`, which may
 be empty. The result is a guess; CertifyNearest() proves what it is worth. */
template <typename Real>
Simplex<Real> FindNearest(const MinkowskiDifference& M, const Simplex<Real>& start);

/** Returns the same points over more digits, with the weights solved anew. */
Simplex<Precise> Sharpen(const MinkowskiDifference& M, const Simplex<double>& simplex);

/** Returns an enclosure of the signed distance of the origin from M, negative inside: no
 less than the support gap along −v, no more than |v|. Valid for every simplex, tight for
 a good one. [m] */
template <typename Real>
Enclosure CertifyNearest(const MinkowskiDifference& M, const Simplex<Real>& simplex);

}  // namespace touchstone::referee
