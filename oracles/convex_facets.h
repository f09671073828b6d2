#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "scenarios/shape.h"

namespace touchstone {

/** One polygon of the boundary of a convex hull. */
struct ConvexFacet {
  Eigen::Vector3d n_B = Eigen::Vector3d::Zero();  ///< Outward unit normal, body frame.
  double offset = 0;         ///< No corner of the hull has n_B·x above this. [m]
  std::vector<int> corners;  ///< Indices into ConvexFacets::corners, counterclockwise
                             ///< seen from outside; at least three.
};

/** The boundary of a convex hull, for engines that want faces and not only vertices. */
struct ConvexFacets {
  /** The vertices that are corners, bit for bit and in their order; those inside, on a
   face or on an edge (to kFlatness) are left out, since engines that walk along edges get
   stuck on them. */
  std::vector<Eigen::Vector3d> corners;
  std::vector<ConvexFacet> facets;
  Eigen::Vector3d centre;  ///< Mean of the corners: inside. [m]
};

/** Vertices this far from a plane, as a share of the largest |coordinate|, count as on
 it: the corners of a flat face that was turned and stored in doubles are each off by a
 few units of 2^-53, and the plane through three of them by a few times that at the
 fourth. */
inline constexpr double kFlatness = 32 * 0x1p-53;

/** Returns the boundary of `hull`, or nothing where it is flat: thinner than kFlatness.

 Which points are corners is decided by exact signs, then faces are merged that are
 coplanar to kFlatness. Takes O(n²) steps for n vertices. */
std::optional<ConvexFacets> BoundaryOf(const ConvexHull& hull);

}  // namespace touchstone
