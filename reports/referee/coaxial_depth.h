#pragma once

#include <optional>

#include "reports/referee/depth_proof.h"
#include "reports/referee/minkowski_difference.h"

namespace touchstone::referee {

/** Returns the depth of two solids of revolution whose axes are almost parallel; a point
 counts as having every axis. Empty for other pairs, and where the origin is not certainly
 inside. With parallel axes M is itself a solid of revolution. In the half-plane of its
 axis and the origin it is a polygon. The sides of the polygon are those of both profiles,
 and the depth is the least overlap along their normals. If that overlap is reached all
 around the axis, this is the only proof that does not have to tile a circle.

 Axes that differ, and matrices that are not exact rotations, widen the enclosure by how
 far they move the farthest point of each core. R = Q S with the nearest rotation Q moves
 it by at most 2 δ ρ (input_rounding.cc). Turning Q e_z onto the common axis z moves it by
 |Q e_z − z| ρ <= (|R e_z − z| + 2 δ) ρ. */
template <typename Real>
std::optional<DepthProof> CoaxialDepth(const MinkowskiDifference& M);

}  // namespace touchstone::referee
