#pragma once

#include <span>

#include "engine/dynamics/solver/constraint_group.h"
#include "engine/dynamics/solver/step_context.h"

namespace cookbook {

/** Fills `moves` with the displacement [m] and rotation [rad] of each body that remove
 Settings::position_correction_fraction of the depth beyond the slop; velocities are left
 alone. `overlaps` are as ContactSolver notes them, of a world that `is_large` or not.
 `mean` is what has moved the bodies during the step of length `h` since the contacts were
 found, `solved` how they move now. Returns false where there is nothing to move; `moves`
 is then as it was. */
template <class Real>
bool FindPositionCorrections(std::span<Overlaps<Real>> overlaps, bool is_large,
                             const StepMotion& motion, const StepContext& step,
                             std::span<SolverVelocity<Real>> corrections);

}  // namespace cookbook
