#pragma once

#include <span>

#include "engine/dynamics/solver/position_constraint.h"
#include "engine/dynamics/solver/step_context.h"

namespace cookbook {

/** Position correction by split impulses. Fills `corrections`, indexed by body, with the
 displacement [m] and the rotation [rad] that remove
 Settings::position_correction_fraction of the depth beyond the slop. The caller moves the
 bodies; no velocity changes here.

 `constraints` holds one list for each thread, and last one that all threads share; no two
 lists have a moving body in common. `motion` is the motion since the contacts were found.
 Returns false, and leaves `corrections` unchanged, if there is no constraint. */
template <class Real>
bool FindPositionCorrections(std::span<PositionConstraints<Real>> constraints,
                             const StepMotion& motion, const StepContext& step,
                             std::span<SolverVelocity<Real>> corrections);

}  // namespace cookbook
