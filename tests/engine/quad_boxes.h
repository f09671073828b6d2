#pragma once

#include <array>

#include "engine/collision/shape.h"

namespace cookbook::test {

/** A number of 113 bits: the reference is 2⁶⁰ times finer than the results it checks. */
__extension__ typedef __float128 Quad;
using QuadVector = std::array<Quad, 3>;

/** A box as the affine image of [−1, 1]³ under the exact doubles of its pose. */
struct QuadBox {
  QuadVector centre;                     ///< [m]
  std::array<QuadVector, 3> half_edges;  ///< Column k of R_WB times half extent k. [m]

  QuadBox(const Box& box, const Pose& X_WB);
};

Quad Dot(const QuadVector& a, const QuadVector& b);
Quad Length(const QuadVector& a);

/** Returns max_A n·x − min_B n·x along the unit vector of `n_W`. [m] */
Quad OverlapAlong(const QuadBox& A, const QuadBox& B, const QuadVector& n_W);

/** Returns the true signed gap along the best of the 15 axes: minus the depth if the
 boxes overlap, a positive lower bound of their distance if they are apart. The algorithm
 is independent of the engine's. It uses no relative rotation and no minors, skips only
 axes that are exactly zero, and takes the normals of the parallelepipeds that the poses
 really make. [m] */
Quad GreatestGap(const QuadBox& A, const QuadBox& B);

/** Returns the distance of B's centre from A's, along the unit `direction_W`, at which
 the greatest gap is `gap`. Each of the 15 gaps is linear in that distance, so the result
 is the least of 15 quotients. [m] */
double DistanceForGap(const QuadBox& A, const QuadBox& B,
                      const Eigen::Vector3d& direction_W, double gap);

/** Returns the distance of `p_W` from the surface of `box`, positive inside and outside.
 [m] */
double DistanceFromSurface(const Box& box, const Pose& X_WB, const QuadVector& p_W);

/** Returns the unit of the engine's rounding bounds: |p_AB|₁ + |h_A|₁ + |h_B|₁. [m] */
double PairSize(const Box& A, const Pose& X_WA, const Box& B, const Pose& X_WB);

}  // namespace cookbook::test
