#pragma once

namespace cookbook {

/** Unit roundoff u of double arithmetic. */
inline constexpr double kUnitRoundoff = 0x1p-53;

/** Bound on |computed gap − exact gap| of two boxes along the axis it is computed for, as
 a multiple of S = |p_AB|₁ + |h_A|₁ + |h_B|₁, the size of the pair. The distance from the
 world origin does not matter: p_AB is one subtraction.

 Derivation, to first order in u, with C = R_Aᵀ R_B as computed, each entry within 3u:
 - p_AB is off by u, and its components in a body frame by 3u more:        4u |p_AB|
 - A face of A (of B likewise): Σ h_B |C| is off by 3u + 3u (product, two sums):
                                                        ≤ 7u |h_B|₁ + 2u |h_A|₁
 - An edge axis n = e_i × C_j / L is *defined* by the computed C, so that n·a_k are
   entries of C and n·b_k are 2×2 minors of C, both evaluated as such. A minor is off by
   at most 2u |e_i × C_j|, that is 2u L: dividing by L, however small, leaves 2u. C_k
   differs from b_k by 3√3 u. With products and sums:
                                     ≤ (5.2 + 4)u |h_B|₁ + 4u |h_A|₁ + 6u |p_AB|
 - The division by L (two products, a sum, a root, a quotient) and the last sums add
   3u + 2u of the result, which is at most S.
 - Rotating n to the world frame leaves n_AB_W off by 3√3 u, which shifts the gap along
   it by ≤ 6u S.
 Together below 21 u S. */
inline constexpr double kOverlapRounding = 24 * kUnitRoundoff;

/** Bound on the rounding of a coordinate of one box's corner along the axes of the other,
 as a multiple of S. The coordinate is t ± h_1 C_1 ± h_2 C_2 ± h_3 C_3, with t within
 4u |p_AB|, each product within (3 + 1)u h and three sums within 3u S. Together 7u S.

 Corners and edges that lie flush are inside each other's bounds to within this tolerance.
 It is not larger, since a contact clamped to a bound leaves the other surface by as
 much. */
inline constexpr double kFlush = 8 * kUnitRoundoff;

/** Corners are one contact if they differ by no more than this multiple of their rounding
 bound kFlush S. This is far above the spread that rounding causes, and far below any
 difference that matters to a solver. */
inline constexpr double kSameCorner = 12;

/** Lead in the gap, as a multiple of S, that another axis needs to be chosen instead of a
 face of A, and an edge axis instead of any face. Equal gaps are computed within twice
 kOverlapRounding of each other at worst, but roundings seldom add up: a third of
 kOverlapRounding keeps the choice steady from step to step. Verdict and contacts are
 right at any value. The depth can be too large by this lead, so it should be small. */
inline constexpr double kTie = kOverlapRounding / 3;

/** Bound on |computed separation − true separation| of touching boxes, as a multiple of
 S. Also the half-width of the band around zero in which either verdict is acceptable.

 The computed candidates are *exact* candidates of a slightly different pair: A and the
 box B′ whose axes are the columns of C. B′ is within 3√3 u |h_B|₁ of B, and the depth
 changes by no more than the shapes do, since it is the distance of a point to the
 boundary of the Minkowski difference A − B. Faces: the column b_j is the normal of B only
 as far as R_B is orthogonal, to 8u here, and B′ differs as much again: ≤ 30u S. Choosing
 by rounded values costs 2 kOverlapRounding, the preference for faces kTie, skipping
 parallel axes 2u. Together at most 88 u S. Matrices that are rotations only to δ > 8u add
 2δ S. */
inline constexpr double kDepthRounding = 88 * kUnitRoundoff;

/** Squared length up to which an edge axis a_i × b_j is skipped: |sin| ≤ u. Rotating B by
 u about its centre would make the two edges exactly parallel, and would move no point of
 B by more than u |h_B|. Skipping the axis costs at most that much depth. Above this
 bound, squares are far from underflow. */
inline constexpr double kParallelSquared = kUnitRoundoff * kUnitRoundoff;

/** Least squared length whose square root keeps full relative precision: DBL_MIN / u.
 Centres closer than its root, 1.5e-146 m, count as coincident. */
inline constexpr double kLeastSquaredLength = 0x1p-1022 / kUnitRoundoff;

}  // namespace cookbook
