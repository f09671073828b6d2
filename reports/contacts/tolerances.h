#pragma once

#include "oracles/oracle.h"
#include "reports/referee/contact_truth.h"
#include "scenarios/scenario.h"

namespace touchstone {

/** The number of roundings of the scene's size L that a correct computation of an overlap
 along an axis, and of the axis itself, may accumulate. The longest path is that of a
 separating-axis test in the frame of A. The costs below are first-order in the unit
 roundoff u (Higham, Accuracy and Stability of Numerical Algorithms, 2nd ed., §3.1: a dot
 product of k terms is off by at most k u |x|ᵀ|y|). For a rotation, |R| |x| is up to √3 as
 long as x. With a = |p|∞ of each body, ρ its bounding radius, P = ρ_A + ρ_B and D = |p_B
 − p_A|, the steps cost, in units of u:
    input rounded to the engine's precision   √3 (a_A + a_B) + (√3 + 1) P
    p_B − p_A, brought into A's frame         (1 + 3 √3) D
    R_Aᵀ R_B, on B's extents                  9 ρ_B
    the axis on the extents of A and B        3 P + 3 √3 ρ_B
    the axis on the centre distance           3 D
    differences 2, the axis normalised 3.5    5.5 max(D, P)
    the axis turned to the world, on a lever  3 √3 (D + P)
 The definition of L implies a_A + a_B ≤ 2 L − P, hence D ≤ √3 (2 L − P). If the bodies
 touch, D ≤ P: the sum is greatest for D = P = 2 √3 / (1 + √3) L and ρ_B = L, 54.5 L. If
 they are apart, without the lever, which Tolerances::apart grants, it is greatest for P =
 0: 54.4 L. Rounded up to a power of two, since an engine may order the terms otherwise.
 [-] */
inline constexpr double kRoundings = 64;

/** The number of roundings that the length of a unit normal may be off by. Normalising
 costs 4: a sum of three squares 3, a root and a division half each. Rotating by a matrix
 costs 4 more. Doubled, for engines that normalise in one frame and again in another. [-]
 */
inline constexpr double kNormalRoundings = 16;

/** The factor by which kRoundings exceeds the sum that it is derived from, 54.5. A value
 that exceeds its tolerance by no more than this factor may owe that to the order of an
 engine's terms. [-] */
inline constexpr double kRoundingsSafety = kRoundings / 54.5;

/** The largest tolerance, as a fraction of the smaller body, within which an answer is
 called right. [-] */
inline constexpr double kFine = 0.01;

/** The tolerances of one oracle in one scenario. */
struct Tolerances {
  /** Tolerance of every length along the normal: separations and overlaps. The error of
   the least of several overlaps is at most the largest of their errors. [m] */
  double separation = 0;
  /** Tolerance of the distance of a position from a surface. Equal to `separation`, but a
   position always rounds like the largest coordinate of the scene. [m] */
  double position = 0;
  /** Tolerance of values that depend on a normal. If the answer says apart, the normal is
   the direction between two nearest points, each off by e: it tilts by e / distance, on a
   lever as long as both bodies, which also bounds the overlap along any direction. [m] */
  double apart = 0;
  /** Tolerance of the excess of the overlap along a normal over the least overlap. The
   normal is chosen by computed overlaps: the true overlap along it may be larger than
   computed, and the least one smaller, each by its rounding and by that of the input. [m]
   */
  double excess = 0;
  /** Tolerance of the position of a deepest contact across the normal. A depth off by e
   moves the deepest point of a surface of radius r by √(2 r e), and that of a nearly
   parallel edge or face as far, at most across the smaller body. The sharper of two
   surfaces decides, so r is at most the extent of the smaller body. [m] */
  double across = 0;
  /** Tolerance of angles between normals that should be equal: e over the smallest
   feature. [rad] */
  double angle = 0;
  /** Tolerance of the length of a unit normal. [-] */
  double unit_normal = 0;
  /** The largest tolerance of a pass; within a larger one an answer is undecidable: kFine
   of the smallest feature, plus kFine of |separation| of bodies that are apart. [m] */
  double fine = 0;
};

/** Returns the size of which the lengths of `oracle` are rounded. [m] */
double RoundedSize(const OracleInfo& oracle, const ContactQuery& query);

/** Returns the rounding of `oracle` on a scene: kRoundings u SceneSize(). If the oracle
 subtracts the positions first and both are representable in its precision, the scene is
 as large as the distance of the positions and the larger body. [m] */
double RoundingOf(const OracleInfo& oracle, const ContactQuery& query);

/** Returns the error that the engine documents for the pair: a length, and a share of the
 separation. [m] */
double DocumentedFor(const OracleInfo& oracle, const ContactQuery& query,
                     const ContactTruth& truth);

/** Returns what OracleInfo::tolerance grants on a scene. [m] */
double StatedFor(const OracleInfo& oracle, const ContactQuery& query);

/** Returns the tolerances of `oracle` in `scenario` for an answer that says `touching`:
 its rounding, the rounding of the input, its documented error, the tolerance that was
 stated for it, and the tolerance that the scenario's author grants. */
Tolerances TolerancesOf(const OracleInfo& oracle, const Scenario& scenario,
                        const ContactTruth& truth, bool touching);

/** The same for a question of its own.
 @param granted The tolerance of the scenario's author; 0 if there is none. [m] */
Tolerances TolerancesOf(const OracleInfo& oracle, const ContactQuery& query,
                        double granted, const ContactTruth& truth, bool touching);

}  // namespace touchstone
