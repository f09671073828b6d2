#pragma once

#include <cmath>

#include "reports/worlds/law_support/law.h"

namespace touchstone {

/** Safety factor of an error law that is derived from the step. It covers the
 second-order terms that the laws leave out, and first-order schemes that differ from
 semi-implicit Euler in the order of their updates. [-] */
inline constexpr double kSafety = 1.5;

/** Roundings of a state that one step may cost. Velocities gain forces (3 operations per
 coordinate: sum, times dt/m, added), contacts (some 20: relative velocity 9, its part
 along n 5, effective mass 2, impulse applied 4) and damping (1). Poses gain velocities
 (2) and a quaternion product (7 per coordinate) with its normalisation (9). An adapter
 converts the state both ways (a rotation, 5, each way). The sum, 52, is rounded up to a
 power of two. [-] */
inline constexpr double kRoundingsPerStep = 64;

/** Returns the relative error of a state from rounding alone, in `steps` steps and in
 reading the world itself. Rounding errors add at worst (Higham, Accuracy and Stability of
 Numerical Algorithms, 2nd ed., §3.1). [-] */
inline double RoundingOf(const OracleInfo& oracle, double steps) {
  return kRoundingsPerStep * oracle.unit_roundoff * (steps + 1);
}

/** Returns the relative error that rounding in a solver leaves in an impulse, for each
 contact of a step: √u of the unit roundoff u. MuJoCo minimises a cost until it no longer
 falls, and a cost is flat to rounding within √u of its minimum (Press et al., Numerical
 Recipes, 3rd ed., §10.2). It exceeds the roundings of a solver that sums three
 constraints in 1000 iterations. All engines are granted the same. [-] */
inline double SolverRoundingOf(const OracleInfo& oracle) {
  return std::sqrt(oracle.unit_roundoff);
}

/** Relative error of a velocity that an iterative contact solver may leave. Rigid solvers
 were measured to meet the closed forms of slopes to 1e-6 and of rolling to 1e-5 if they
 iterate to convergence; ten iterations of projected Gauss-Seidel leave 1e-3. [-] */
inline constexpr double kSolverResidual = 1e-5;

/** Returns the number of steps before sample `s`. */
inline double StepsBefore(const Motion& motion, std::size_t s) {
  return std::round(motion.trajectory.times[s] / motion.world.dt);
}

/** Returns that number as a counter of steps. */
inline long WholeStepsBefore(const Motion& motion, std::size_t s) {
  return std::lround(StepsBefore(motion, s));
}

/** Returns the longest time from one sample to the next. [s] */
inline double SampleSpacing(const World& world) {
  return world.dt * world.sample_every;
}

}  // namespace touchstone
