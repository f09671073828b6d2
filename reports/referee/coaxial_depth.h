#pragma once

#include <optional>

#include "reports/referee/depth_proof.h"
#include "reports/referee/minkowski_difference.h"

namespace touchstone::referee {

/** Returns the depth of two solids of revolution whose axes are almost parallel; a point
 has every axis. Empty for other pairs, and where the origin is not certainly inside.

 With parallel axes M is itself a solid of revolution. In the half-plane of its axis and
 the origin it is a polygon, whose sides are those of both profiles, and the depth is the
 least overlap along their normals. Where it is reached all around the axis, this is the
 only proof that does not have to tile a circle. Axes that differ, and matrices that are
 not quite rotations, widen it by how far they move the farthest point of each core: R = Q
 S with the nearest rotation Q moves it by at most 2 δ ρ (input_rounding.cc), and turning
 Q e_z onto the common axis z by |Q e_z − z| ρ <= (|R e_z − z| + 2 δ) ρ. */
std::optional<DepthProof> CoaxialDepth(const MinkowskiDifference& M);

}  // namespace touchstone::referee
