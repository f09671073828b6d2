#pragma once

#include <span>

#include "engine/dynamics/body/settings.h"
#include "engine/dynamics/solver/constraint_group.h"
#include "engine/threads/thread_pool.h"

namespace cookbook {

/** Fills `moves` with the displacement [m] and rotation [rad] of each body that remove
 Settings::position_correction_fraction of the depth beyond the slop; velocities are left
 alone. `overlaps` are as ContactSolver notes them, of a world that `is_large` or not.
 `mean` is what has moved the bodies during the step of length `h` since the contacts were
 found, `solved` how they move now. Returns false where there is nothing to move; `moves`
 is then as it was. */
template <class Real>
bool FindPositionCorrections(std::span<Overlaps<Real>> overlaps, bool is_large,
                             std::span<const Velocity> mean,
                             std::span<const Velocity> solved, const Settings& settings,
                             double h, ThreadPool& pool,
                             std::span<SolverVelocity<Real>> moves);

}  // namespace cookbook
