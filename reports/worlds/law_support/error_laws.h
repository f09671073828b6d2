#pragma once

#include <cmath>

#include "reports/worlds/law_support/law.h"

namespace touchstone {

/** By how much a derived error law of the step is exceeded before it counts: covers the
 terms of second order that the laws leave out, and schemes of first order that differ
 from semi-implicit Euler in the order of their updates. [-] */
inline constexpr double kSafety = 1.5;

/** Roundings of a state that one step may cost: velocities gain forces (3 operations a
 coordinate: sum, times dt/m, added), contacts (some 20: relative velocity 9, its part
 along n 5, effective mass 2, impulse applied 4) and damping (1); poses gain velocities
 (2) and a quaternion product (7 a coordinate) with its normalisation (9); an adapter
 carries the state out and in (a rotation, 5, each way). The sum, 52, rounded up to a
 power of two.
 [-] */
inline constexpr double kRoundingsPerStep = 64;

/** Returns the share by which rounding alone may move a state in `steps` steps, and in
 the reading of the world itself. Roundings add at worst (Higham, Accuracy and Stability
 of Numerical Algorithms, 2nd ed., §3.1). [-] */
inline double RoundingOf(const OracleInfo& oracle, double steps) {
  return kRoundingsPerStep * oracle.unit_roundoff * (steps + 1);
}

/** Share of a velocity by which an iterative contact solver may stop short. Rigid solvers
 were measured to meet the closed forms of slopes to 1e-6 and of rolling to 1e-5 where
 they iterate to their end; ten sweeps of projected Gauss-Seidel leave 1e-3. [-] */
inline constexpr double kSolverResidual = 1e-5;

/** Returns the number of steps before sample `s`. */
inline double StepsBefore(const Motion& motion, std::size_t s) {
  return std::round(motion.trajectory.times[s] / motion.world.dt);
}

/** Returns the longest time from a sample to the next. [s] */
inline double SampleSpacing(const World& world) {
  return world.dt * world.sample_every;
}

}  // namespace touchstone
