#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "scenarios/shape.h"

namespace touchstone {

/** One polygon of the boundary of a convex hull. */
struct ConvexFacet {
  Eigen::Vector3d n_B = Eigen::Vector3d::Zero();  ///< Outward unit normal, body frame.
  double offset = 0;         ///< Largest n_B·x of all corners of the hull. [m]
  std::vector<int> corners;  ///< Indices into ConvexFacets::corners, counterclockwise
                             ///< seen from outside; at least three.
};

/** The boundary of a convex hull, for engines that need faces in addition to vertices. */
struct ConvexFacets {
  /** The vertices that are corners, bit for bit and in their order. Vertices inside, on a
   face or on an edge (to kFlatness) are left out: engines that walk along edges get stuck
   on them. */
  std::vector<Eigen::Vector3d> corners;
  std::vector<ConvexFacet> facets;
  Eigen::Vector3d centre;  ///< Mean of the corners, a point inside. [m]
};

/** Distance up to which a vertex counts as lying on a plane, as a fraction of the largest
 |coordinate|. The corners of a flat face that was rotated and stored in doubles are each
 off by a few units of 2^-53. The plane through three of them misses the fourth by a few
 times that. */
inline constexpr double kFlatness = 32 * 0x1p-53;

/** Returns the boundary of `hull`, or nothing if it is flat, i.e. thinner than kFlatness.

 The triangulation uses exact signs; then faces that are coplanar to kFlatness are merged.
 Takes O(n²) steps for n vertices. */
std::optional<ConvexFacets> BoundaryOf(const ConvexHull& hull);

}  // namespace touchstone
