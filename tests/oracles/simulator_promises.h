#pragma once

#include <Eigen/Core>

#include "oracles/oracle.h"
#include "scenarios/worlds/world.h"

namespace touchstone {

/** Returns a ball of 1.3 kg and radius 0.1 m at rest at `p_W`. */
RigidBody Ball(const Eigen::Vector3d& p_W);

/** Returns a static box whose top face is at y = 0. */
RigidBody Slab();

/** Returns a world with a rotated brick of 1.7 kg, bodies[1]. It falls with a corner
 first, sliding and spinning, onto the slab, bodies[0]. */
World BrickOnSlab();

/** Expects that the momentum of the brick after each step is its initial momentum plus
 the impulses of gravity, its force and its contacts, to within `allowed` [N s]. Also
 expects that contacts only push. `world` is BrickOnSlab() or a variant of it. */
void ExpectImpulsesChangeMomentum(const Oracle& oracle, const World& world,
                                  double allowed);

/** Expects that a brick that does not collide falls through the slab, which stays in
 * place.
 */
void ExpectPassesThroughEverything(const Oracle& oracle);

/** Expects that a pendulum on a distance joint has, after each step, the velocity along
 the rod that corrects a fifth of the length error, to within `allowed` [m/s]. The
 fraction `undone` of the velocity change by the joint is expected to be missing. */
void ExpectJointTakesBackAFifthOfItsError(const Oracle& oracle, double undone,
                                          double allowed);

/** Expects that a joint between a ball and a static body keeps its length at the anchors.
 Also expects that the ball ends in the same place, to within `allowed` [m], if the ends
 of the joint are exchanged. */
void ExpectJointHoldsEitherWayRound(const Oracle& oracle, double allowed);

/** Expects that a ball 1 mm deep in the slab stays there, and that the engine with its
 default settings pushes it out at `speed` in the first step, both to within `allowed`
 [m/s]. It is asked in three ways to use its defaults: to begin as shipped, set up as
 shipped, and with the default of every parameter chosen; the three start alike. */
void ExpectPushesOverlapOutOnlyAsShipped(const Oracle& oracle, double speed,
                                         double allowed);

}  // namespace touchstone
