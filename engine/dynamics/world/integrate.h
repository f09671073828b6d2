#pragma once

#include <span>

#include "engine/dynamics/body/rigid_body.h"
#include "engine/dynamics/solver/contact_constraint.h"

namespace cookbook {

/** A change of velocity in a step beyond this many times what the forces make of a free
 body is taken for a impact. A contact that holds or slows a body makes less. */
inline constexpr double kImpactFactor = 4;

/** A step of some bodies, all by body index. */
struct Motion {
  std::span<RigidBody> bodies;       ///< At its start, then at its end.
  std::span<const Velocity> before;  ///< At its start.
  std::span<const Velocity> free;    ///< At its end, without impulses.
  std::span<const Velocity> solved;  ///< At its end.
  std::span<const Touch> touches;
  std::span<Velocity> mean;  ///< Out: what moves the bodies during the step.
  double h;                  ///< [s]
};

/** Beyond any world that means something. */
inline constexpr double kLargest = 1e12;

/** Moves bodies that RigidBody::moves_isotropically() as World::MoveBody() does, four at once,
 and fills `ways` with the Travel() of each. Returns whether all numbers are below
 kLargest.
 */
bool MoveRound(const Motion& motion, std::span<const int> bodies, std::span<double> ways);

/** Displaces and turns `some` of the bodies by their `moves` ([m], [rad], by body index),
 four at once, and fills `ways` with the Travel() of each. */
void Shift(std::span<RigidBody> bodies, std::span<const Velocity> moves,
           std::span<const int> some, std::span<double> ways);

}  // namespace cookbook
