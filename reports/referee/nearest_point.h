#pragma once

#include <array>

#include "reports/referee/minkowski_difference.h"

namespace touchstone::referee {

/** A simplex of GJK: up to four points of M with positive weights, and v, their convex
 combination. */
template <typename Real>
struct Simplex {
  std::array<DifferencePoint<Real>, 4> points;
  std::array<Real, 4> weights;  ///< Weights of the points: positive, not normalised.
  int count = 0;
  Vector<Real> v;  ///< The convex combination, to rounding. [m]
  bool encloses_origin =
      false;  ///< Whether it is a tetrahedron around the origin, to rounding.
};

/** Searches for the point of M nearest to the origin by GJK. It tries every face of the
 simplex, so that no rounding leads it into a wrong branch. Starts from `start`, which may
 be empty. The result is a guess: CertifyNearest() proves bounds from it. */
template <typename Real>
Simplex<Real> FindNearest(const MinkowskiDifference& M, const Simplex<Real>& start);

/** Returns the face of `simplex` nearest to the origin, with its weights. */
template <typename Real>
Simplex<Real> NearestOnSimplex(const Simplex<Real>& simplex);

/** Returns the same points in higher precision, with the weights computed again. */
template <typename Real>
Simplex<Real> Sharpen(const MinkowskiDifference& M, const Simplex<double>& simplex);

/** Returns an enclosure of the signed distance of the origin from M, negative inside. Its
 lower end is the support gap along −v, its upper end |v|. It is valid for every simplex,
 and tight for a good one. [m] */
template <typename Real>
Enclosure CertifyNearest(const MinkowskiDifference& M, const Simplex<Real>& simplex);

}  // namespace touchstone::referee
