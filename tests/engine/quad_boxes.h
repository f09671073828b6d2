#pragma once

#include <array>

#include "engine/collision/shape.h"

namespace cookbook::test {

/** 113 bits of mantissa: the ruler is 2⁶⁰ times finer than what it measures. */
__extension__ typedef __float128 Quad;
using QuadVector = std::array<Quad, 3>;

/** A box as the affine image of [−1, 1]³ under the very doubles of its pose. */
struct QuadBox {
  QuadVector centre;                     ///< [m]
  std::array<QuadVector, 3> half_edges;  ///< Column k of R_WB times half extent k. [m]

  QuadBox(const Box& box, const Pose& X_WB);
};

Quad Dot(const QuadVector& a, const QuadVector& b);
Quad Length(const QuadVector& a);

/** Returns max_A n·x − min_B n·x along the unit vector of `n_W`. [m] */
Quad OverlapAlong(const QuadBox& A, const QuadBox& B, const QuadVector& n_W);

/** Returns the true signed gap along the best of the 15 axes: minus the depth of boxes
 that overlap; of boxes apart, a positive lower bound of their distance. Independent of
 the engine: no relative rotation, no minors, no skipping but of exact zeros, normals of
 the parallelepipeds that the poses really make. [m] */
Quad GreatestGap(const QuadBox& A, const QuadBox& B);

/** Returns how far B's centre must be from A's, along the unit `direction_W`, for the
 greatest gap to be `gap`: each of the 15 gaps is linear in that distance, so the least of
 15 quotients. [m] */
double DistanceForGap(const QuadBox& A, const QuadBox& B,
                      const Eigen::Vector3d& direction_W, double gap);

/** Returns how far `p_W` is from the surface of `box`, inside and outside alike. [m] */
double DistanceFromSurface(const Box& box, const Pose& X_WB, const QuadVector& p_W);

/** Returns the size that the engine's bounds are multiples of: |p_AB|₁ + |h_A|₁ + |h_B|₁.
 * [m] */
double PairSize(const Box& A, const Pose& X_WA, const Box& B, const Pose& X_WB);

}  // namespace cookbook::test
