#pragma once

#include <span>

#include "engine/dynamics/solver/constraint_group.h"
#include "engine/threads/thread_pool.h"
#include "engine/dynamics/body/settings.h"

namespace cookbook {

/** Fills `moves` with the displacement [m] and rotation [rad] of each body that remove
 Settings::projection_share of the depth beyond the slack; velocities are left alone.
 `overlaps` are as ContactSolver notes them, of a world that `is_large` or not. `mean` is
 what has moved the bodies during the step of length `h` since the contacts were found,
 `solved` how they move now. Returns false where there is nothing to move; `moves` is then
 as it was. */
template <class Real>
bool FindMoves(std::span<Overlaps<Real>> overlaps, bool is_large,
               std::span<const Velocity> mean, std::span<const Velocity> solved,
               const Settings& settings, double h, Crew& crew,
               std::span<SweptVelocity<Real>> moves);

}  // namespace cookbook
