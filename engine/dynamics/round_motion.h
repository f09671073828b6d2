#pragma once

#include <span>

#include "engine/dynamics/contact_batch.h"
#include "engine/dynamics/rigid_body.h"

namespace cookbook {

/** A change of velocity in a step beyond this many times what the forces make of a free
 body is taken for a blow. A contact that holds or slows a body makes less. */
inline constexpr double kBlow = 4;

/** A step of some bodies, all by body index. */
struct Motion {
  std::span<RigidBody> bodies;       ///< At its start, then at its end.
  std::span<const Velocity> before;  ///< At its start.
  std::span<const Velocity> free;    ///< At its end, without impulses.
  std::span<const Velocity> solved;  ///< At its end.
  std::span<const Touch> touches;
  std::span<Velocity> mean;  ///< Out: what moves the bodies during the step.
  std::span<double> shares;  ///< Out: see JointSolver::Correct().
  double h;                  ///< [s]
};

/** Returns whether a body moves, has a volume, and is as easy to turn about any axis. */
inline bool IsRound(const RigidBody& body) {
  const Eigen::Vector3d& turning = body.inverse_moments;
  return turning[0] > 0 && turning[0] == turning[1] && turning[1] == turning[2] &&
         !body.is_static();
}

/** Moves bodies of which IsRound() is true as World::MoveBody() does, four at once, and
 fills `ways` with the Travel() of each. */
void MoveRound(const Motion& motion, std::span<const int> bodies, std::span<double> ways);

}  // namespace cookbook
