#pragma once

#include <span>

#include "engine/dynamics/body/rigid_body.h"
#include "engine/dynamics/solver/contact_constraint.h"

namespace cookbook {

/** A change of velocity beyond this many times that of a free body in a step is treated
 as an impact. A contact that holds or slows down a body causes less. */
inline constexpr double kImpactFactor = 4;

/** Input and output of the integration of a step. All spans are indexed by body. */
struct Integration {
  std::span<RigidBody> bodies;       ///< In: at the start of the step. Out: at its end.
  std::span<const Velocity> before;  ///< At the start of the step.
  std::span<const Velocity> free;    ///< At the end of the step, without impulses.
  std::span<const Velocity> solved;  ///< At the end of the step.
  std::span<const ContactFlags> contact_flags;
  std::span<Velocity> mean;  ///< Out: the velocities that move the bodies.
  double h;                  ///< Time step. [s]
};

/** Coordinates and velocities from here on count as diverged. [SI units] */
inline constexpr double kDivergenceBound = 1e12;

/** Integrates `bodies`, for which RigidBody::moves_isotropically() is true, like
 World::IntegrateBody(), but four at once. Fills `travel` with the Travel() of each [m].
 Returns whether all numbers are below kDivergenceBound. */
bool IntegrateIsotropicBodies(const Integration& integration, std::span<const int> bodies,
                              std::span<double> travel);

/** Translates and rotates the bodies with the indices `corrected` by their `corrections`
 ([m], [rad], indexed by body), four at once. Fills `travel` with the Travel() of each
 [m]. */
void IntegratePositionCorrections(std::span<RigidBody> bodies,
                                  std::span<const Velocity> corrections,
                                  std::span<const int> corrected,
                                  std::span<double> travel);

}  // namespace cookbook
