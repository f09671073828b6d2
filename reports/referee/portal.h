#pragma once

#include "reports/referee/nearest_point.h"

namespace touchstone::referee {

/** Searches for the face of M where the ray from the middle of M through the origin
 leaves it, by Minkowski portal refinement (Snethen, Game Programming Gems 7, 2008).

 Near touching, this finds the normal where GJK cannot. There the vector from M to the
 origin, whose direction GJK follows, is as short as its own error; the normal of a portal
 is that of points as far apart as the face is wide. If the origin is at the distance d
 from M, the normal is off by what the face turns within some d.

 The result is a guess: three points of M, and the direction of the least overlap among
 the normals on the way. Its count is 0 if M is flat. */
struct Portal {
  Simplex<Precise> simplex;  ///< Points and weights of the point nearest to the origin.
  Vector<Precise> n;         ///< The direction, not normalised.
};
Portal FindPortal(const MinkowskiDifference& M);

}  // namespace touchstone::referee
