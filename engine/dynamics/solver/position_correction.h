#pragma once

#include <span>

#include "engine/dynamics/solver/position_constraint.h"
#include "engine/dynamics/solver/step_context.h"

namespace cookbook {

/** Position correction (split impulse): fills `corrections`,
 indexed by body, with a displacement [m] and a rotation [rad] of each body that together
 remove Settings::position_correction_fraction of the depth beyond the slop. Velocities do
 not change, so that no energy is added. A large world removes at most a fifth.

 `constraints` holds one list for each thread, and last one that all threads share; no two
 lists have a moving body in common. `motion` is the motion since the contacts were found.
 Returns false, and leaves `corrections` unchanged, if there is no constraint. */
template <class Real>
bool FindPositionCorrections(std::span<PositionConstraints<Real>> constraints,
                             bool is_large, const StepMotion& motion,
                             const StepContext& step,
                             std::span<SolverVelocity<Real>> corrections);

}  // namespace cookbook
