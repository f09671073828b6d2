#pragma once

#include <Eigen/Core>

#include "oracles/oracle.h"
#include "scenarios/worlds/world.h"

namespace touchstone {

/** Returns a ball of 1.3 kg and 0.1 m at `p_W` that does not turn. */
RigidBody Ball(const Eigen::Vector3d& p_W);

/** Returns a static box whose upper face is y = 0. */
RigidBody Slab();

/** Returns a turned brick of 1.7 kg, bodies[1], that falls on a corner, sliding and
 spinning, onto the slab, bodies[0]. */
World BrickOnSlab();

/** Expects of the brick on the slab that its momentum after each step is what it started
 with and all that gravity, its force and the impulses of its contacts have given it, to
 `allowed` [N s], and that contacts push. `world` is BrickOnSlab() or a variant of it. */
void ExpectImpulsesChangeMomentum(const Oracle& oracle, const World& world,
                                  double allowed);

/** Expects that a brick that does not collide falls through the slab, which stays. */
void ExpectPassesThroughEverything(const Oracle& oracle);

/** Expects of a pendulum on a distance joint that the velocity along the rod after a step
 is what shortens the excess length by a fifth, to `allowed` [m/s], but for the share
 `undone` of what the joint is to change. */
void ExpectJointTakesBackAFifthOfItsError(const Oracle& oracle, double undone,
                                          double allowed);

/** Expects that a joint between a ball and a static body holds its length at the anchors,
 and that the ball ends in the same place, to `allowed` [m], if the joint's ends are
 exchanged. */
void ExpectJointHoldsEitherWayRound(const Oracle& oracle, double allowed);

/** Expects that a ball 1 mm deep in the slab stays there, and that the engine as shipped
 pushes it out at `speed` in the first step, both to `allowed` [m/s]. */
void ExpectPushesOverlapOutOnlyAsShipped(const Oracle& oracle, double speed,
                                         double allowed);

}  // namespace touchstone
