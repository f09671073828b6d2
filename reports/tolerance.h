#pragma once

#include <string>

#include "oracles/oracle.h"
#include "reports/referee/contact_truth.h"
#include "scenarios/scenario.h"

namespace touchstone {

/** How much error is acceptable, and the argument for it. */
struct Tolerance {
  double value = 0;
  std::string because;  ///< One sentence, quoted in the report.
};

/** Roundings of the scene's size that a right computation of a separation may accumulate.

 The longest path is that of a separating-axis test, in units of u times the size (Higham,
 Accuracy and Stability of Numerical Algorithms, 2nd ed., §3.1: a dot product of k terms
 is off by at most k u |x|ᵀ|y|): the input rounded to the engine's precision 1; p_B − p_A
 into A's frame 4; R_Aᵀ R_B composed 3; the axis a × b crossed and normalised 6; half
 extents along the axis, 3 + 3 terms of products, 7; the centre distance along it and the
 difference 4; a contact carried back to the world 4. The sum, 29, is for |x|ᵀ|y|, which
 for unit directions is up to √3 |x| |y|: 50. The axis is then chosen by rounded overlaps:
 the one chosen may be longer than the least by the error of both, twice that: 100.
 Rounded up to a power of two, since terms may be ordered otherwise. [-] */
inline constexpr double kRoundings = 128;

/** Roundings that the length of a unit normal may be off by: normalising costs 4 (a sum
 of three squares 3, a root and a division half each), rotating it by a matrix 4 more.
 Doubled, for engines that normalise in one frame and again in another. [-] */
inline constexpr double kNormalRoundings = 16;

/** What an oracle may be off by in one scenario. */
struct Tolerances {
  /** Of every length along the normal: separations, overlaps, distances from a surface.
   * [m] */
  Tolerance separation;
  /** Of what depends on a normal where the bodies are apart. The normal is then the
   direction between two nearest points, each off by e: it tilts by e / distance, on a
   lever as long as the scene. [m] */
  Tolerance apart;
  /** Of where a deepest contact lies across the normal. A depth off by e moves the
   deepest point of a surface of radius r by √(2 r e), and that of a nearly parallel face
   as far. [m] */
  Tolerance across;
  /** Of angles between normals that should be one: e over the smallest feature. [rad] */
  Tolerance angle;
  /** Of the length of a unit normal. [-] */
  double unit_normal = 0;
};

/** Returns the rounding of `oracle` on a scene: kRoundings u SceneSize(). [m] */
double RoundingOf(const OracleInfo& oracle, const ContactQuery& query);

/** Returns what `oracle` may be off by in `scenario`: its rounding, the rounding of the
 input, its documented error, and what the scenario's author grants. */
Tolerances TolerancesOf(const OracleInfo& oracle, const Scenario& scenario,
                        const ContactTruth& truth);

}  // namespace touchstone
