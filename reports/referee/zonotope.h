#pragma once

#include <optional>

#include "reports/referee/minkowski_difference.h"

namespace touchstone::referee {

/** The depth of the origin in M and the direction along which it is reached. */
struct CoreDepth {
  /** Signed overlap along the best candidate. If M has a volume and `lo` >= 0, it is the
   depth. Otherwise the origin may be outside M, and only −hi has a meaning: it is a lower
   bound on the distance. [m] */
  Enclosure depth;
  Eigen::Vector3d n_AB_W;  ///< Unit direction from A to B.
};

/** Returns true if the core is a zonotope: a point, a segment or a box. */
bool IsZonotope(const Core& core);

/** Returns the least overlap of two zonotopes over the normals of the faces of M. Empty
 if M is a point or a segment and has no faces.

 M = c + Σ [−h_k, h_k] g_k is itself a zonotope, with the edges of both as generators.
 Each of its faces is spanned by two of them. The cross products of all pairs therefore
 include every face normal: face normals of A, of B, and edge crosses alike. Along a face
 normal max n·x = n·c + Σ h_k |n·g_k|. If the origin is inside a full-dimensional M, the
 least of these per unit length is the depth. */
std::optional<CoreDepth> ZonotopeDepth(const MinkowskiDifference& M);

}  // namespace touchstone::referee
