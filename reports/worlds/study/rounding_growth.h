#pragma once

#include <limits>
#include <span>

#include "oracles/trajectory.h"
#include "reports/worlds/study/study.h"

namespace touchstone {

/** The factor by which a motion amplifies rounding errors: the largest distance to the
 motion with a moved start, over the distance by which the start was moved; at least 1. */
struct RoundingGrowth {
  double gain = 1;         ///< Largest factor over all compared samples. [-]
  double gain_before = 1;  ///< Largest factor over the samples before the horizon. [-]
  /** The time of the first sample from which on rounding decides the motion: the gain
   exceeds kLargestGain, and amplified rounding exceeds the discretisation error. Infinity
   if there is none. [s] */
  double horizon = std::numeric_limits<double>::infinity();
  /** Tolerance for events that come a step late, in a world claimed to be stable. [m] */
  double late = 0;
  /** The most that rounding explains of a difference of two motions. A motion that jumps
   does so whatever the size of the change that makes it jump: the gain times all
   roundings would explain many times the jump. Infinity if it was not measured. [m] */
  double most = std::numeric_limits<double>::infinity();
};

/** The largest gain at which variants are still compared: a flight, a swing and a few
 bounces stay below it. A motion with a larger gain falls over, scatters or jumps, as does
 a row of balls that just touch. [-] */
inline constexpr double kLargestGain = 1e3;

/** Measures the growth by `nudged`, the motion of the same world with its start moved by
 the rounding error of one step, RoundingOf(study, 1).
 @pre study.half is set; all three motions are answered and did not diverge. */
RoundingGrowth GrowthOf(const Study& study, const Trajectory& nudged);

/** Returns RoundingGrowth::most: ten times the largest distance to a motion in `nudged`,
 those with the start moved by the roundings of all steps. Infinity if none of them was
 answered. [m] */
double MostThatRoundingExplains(const Study& study, std::span<const Trajectory> nudged);

}  // namespace touchstone
