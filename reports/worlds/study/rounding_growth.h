#pragma once

#include <limits>

#include "oracles/trajectory.h"
#include "reports/worlds/study/study.h"

namespace touchstone {

/** What a motion makes of rounding: how many times as far as its start was moved it ends,
 at most, at least 1. */
struct RoundingGrowth {
  double gain = 1;         ///< Of all samples that are compared. [-]
  double gain_before = 1;  ///< Of those before the horizon. [-]
  /** The first sample from which on rounding decides where the motion goes: it makes more
   than kLargestGain times as much of it, and more than the step makes of its error.
   Infinity where there is none. [s] */
  double horizon = std::numeric_limits<double>::infinity();
  /** Of a world that is known to be stable, what is granted for events a step late. [m]
   */
  double late = 0;
};

/** Up to here what a motion makes of rounding is granted and its variants compared: a
 flight, a swing, a few bounces. What multiplies it by more falls over, scatters or jumps,
 as where a row of balls just touches. [-] */
inline constexpr double kLargestGain = 1e3;

/** Measures it by `nudged`, the motion of the same world whose start is moved by the
 rounding of one step, RoundingOf(study, 1).
 @pre study.half is there; all three are answered and did not diverge. */
RoundingGrowth GrowthOf(const Study& study, const Trajectory& nudged);

}  // namespace touchstone
