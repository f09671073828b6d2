#pragma once

namespace cookbook {

/** Unit roundoff u of double arithmetic. */
inline constexpr double kUnitRoundoff = 0x1p-53;

/** Bound on |computed − exact gap of two boxes along the axis it is computed for|, as a
 multiple of S = |p_AB|₁ + |h_A|₁ + |h_B|₁, the size of the pair (not of its place: p_AB
 is one subtraction, so boxes far from the origin lose nothing more).

 Derivation, in first order of u, with C = R_Aᵀ R_B as computed, each entry within 3u:
 - p_AB rounds by u, its components in a body frame by 3u more:        4u |p_AB|
 - A face: Σ h_B |C| is off by 3u + 3u (product, two sums):           ≤ 7u |h_B|₁ + 2u
 |h_A|₁
 - an edge axis n = e_i × C_j / L is *defined* by the computed C, so n·a_k are entries of
 C and n·b_k are 2×2 minors of C, both evaluated as such. A minor rounds by 2u |e_i × C_j|
 at most, that is by 2u L: dividing by L, however small, leaves 2u. C_k differs from b_k
 by 3√3 u. With products and sums:               ≤ (5.2 + 4)u |h_B|₁ + 4u |h_A|₁ + 6u
 |p_AB|
 - dividing by L (two products, a sum, a root, a quotient) and the last sums: 3u + 2u of
 the result, which is at most S. - turning n to the world: n_AB_W is off by 3√3 u, which
 shifts the gap along it by ≤ 6u S. Together below 21 u S. */
inline constexpr double kOverlapRounding = 24 * kUnitRoundoff;

/** Bound on the rounding of where a corner of one box lies along the axes of the other,
 as a multiple of S: a coordinate is t ± h_1 C_1 ± h_2 C_2 ± h_3 C_3, with t within
 4u |p_AB|, each product within (3 + 1)u h and three sums within 3u S. Together 7u S.

 Corners and edges that lie flush are in each other's bounds to within this; it is not
 larger, since a contact brought back to a bound leaves the other surface by as much. */
inline constexpr double kFlush = 8 * kUnitRoundoff;

/** Corners that differ by no more than this many times what they may be out are one
 contact. Far above what rounding sets apart, far below what a solver could tell apart. */
inline constexpr double kSameCorner = 12;

/** How much better, as a multiple of S, another axis must be than a face of A, and an
 edge axis than any face, to be chosen. Gaps that are equal are computed within twice
 kOverlapRounding of each other at worst, but roundings seldom add up: a third of one
 keeps the choice steady from step to step. No answer hangs on it, neither verdict nor
 contacts, and it is given up as depth, so it should be small. */
inline constexpr double kTie = kOverlapRounding / 3;

/** Bound on |computed separation − true separation| of touching boxes, as a multiple of
 S; also the half-width of the band around zero inside which the verdict may be either.

 The computed candidates are *exact* candidates of a slightly different pair, A and the
 box B′ whose axes are the columns of C: B′ is within 3√3 u |h_B|₁ of B, and depth changes
 by no more than the shapes do (it is the distance of a point to the boundary of A − B).
 Faces: the column b_j is the normal of B only as far as R_B is orthogonal, to 8u here,
 and B′ differs as much again: ≤ 30u S. Choosing by rounded values costs 2
 kOverlapRounding, preferring faces kTie, skipping parallel axes 2u. Together at most
 88 u S. Matrices that are rotations only to δ > 8u add 2δ S. */
inline constexpr double kDepthRounding = 88 * kUnitRoundoff;

/** Squared length below which an edge axis a_i × b_j is skipped: |sin| ≤ u. Turning B by
 u about its centre makes the two edges exactly parallel, their axis vanish, and moves no
 point of B by more than u |h_B|: skipping costs that much depth. Above it, squares are
 far from underflow. */
inline constexpr double kParallelSquared = kUnitRoundoff * kUnitRoundoff;

/** Least squared length whose square root keeps full relative precision, DBL_MIN / u.
 Centres closer than its root, 1.5e-146 m, count as one point. */
inline constexpr double kLeastSquaredLength = 0x1p-1022 / kUnitRoundoff;

}  // namespace cookbook
