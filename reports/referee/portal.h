#pragma once

#include "reports/referee/nearest_point.h"

namespace touchstone::referee {

/** Searches for the face of M where the ray from the middle of M through the origin
 leaves it, by Minkowski portal refinement (Snethen, Game Programming Gems 7, 2008).

 Near touching, this finds the normal where GJK cannot. GJK takes the normal from the
 vector between M and the origin, which there is as short as its own error. A portal takes
 it from three points of a face. If the origin is at the distance d from M, the error is
 the change of the surface normal over a distance of about d.

 The result is a guess: three points of M, and the direction of the least overlap among
 the normals on the way. Its count is 0 if M is flat. */
template <typename Real>
struct Portal {
  Simplex<Real> simplex;  ///< Points and weights of the point nearest to the origin.
  Vector<Real> n;         ///< The direction, not normalised.
};
template <typename Real>
Portal<Real> FindPortal(const MinkowskiDifference& M);

}  // namespace touchstone::referee
