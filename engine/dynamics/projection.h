#pragma once

#include <span>
#include <vector>

#include "engine/dynamics/contact_solver.h"

namespace cookbook {

/** Moves of bodies that reduce overlap; velocities are left alone. */
class Projection {
 public:
  /** Fills `moves` with the displacement [m] and rotation [rad] of each body that remove
   Settings::projection_share of the depth beyond the slack. `mean` is what has moved the
   bodies during the step of length `h` since the contacts were found, `solved` how they
   move now: contacts that part on their own are let go. Returns false where there is
   nothing to move; `moves` is then as it was. */
  bool FindMoves(const ContactSolver& contacts, std::span<const InverseInertia> inertias,
                 std::span<const Velocity> mean, std::span<const Velocity> solved,
                 const Settings& settings, double h, std::span<Velocity> moves);

 private:
  /** A contact that is too deep. */
  struct Overlap {
    SolvedContact contact;
    double excess;       ///< To be removed. [m]
    double impulse = 0;  ///< [kg m]
  };

  std::vector<Overlap> overlaps_;
};

}  // namespace cookbook
