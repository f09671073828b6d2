#pragma once

#include <optional>

#include "reports/referee/minkowski_difference.h"

namespace touchstone::referee {

/** A depth of M and the direction along which it is reached. */
struct CoreDepth {
  /** Signed overlap along the best candidate: the depth where `lo` > 0. Where it is not,
   the origin is outside M or on it, and only −hi, a lower bound on the distance, has a
   meaning. */
  Enclosure depth;         ///< [m]
  Eigen::Vector3d n_AB_W;  ///< Unit.
};

/** Returns true for the cores that are zonotopes: points, segments and boxes. */
bool IsZonotope(const Core& core);

/** Returns the least overlap of two zonotopes over the normals of the faces of M; empty
 where M has no faces, being a point or a segment.

 M = c + Σ [−h_k, h_k] g_k is itself a zonotope, with the edges of both as generators.
 Each of its faces is spanned by two of them, so the cross products of all pairs hold
 every face normal (face normals of A, of B, and edge crosses alike), and along a face
 normal max n·x = n·c + Σ h_k |n·g_k|. For an origin inside a full-dimensional M, the
 least of these per unit length is the depth. */
std::optional<CoreDepth> ZonotopeDepth(const MinkowskiDifference& M);

}  // namespace touchstone::referee
