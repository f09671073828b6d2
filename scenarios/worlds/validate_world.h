#pragma once

#include <vector>

#include "scenarios/validate.h"
#include "scenarios/worlds/world_scenario.h"

namespace touchstone {

/** How far a time may be off a multiple of the step, as a share of a step: above the
 rounding of times / dt for all steps there can be, far below anything that means another
 step. */
inline constexpr double kStepSlack = 1e-6;

/** The most steps of a world, so that one refined a few times still counts in an int. */
inline constexpr int kMostSteps = 100'000'000;

// Each part on its own: finite numbers in their ranges. `where` is the key that a file
// uses, e.g. "inertia[1]"; empty for a valid part.

/** Also: an inertia that a solid can have, or a shape that implies one; nothing moves
 whose mass is 0. */
std::vector<Fault> FaultsOf(const RigidBody& body);
std::vector<Fault> FaultsOf(const Particle& particle);
std::vector<Fault> FaultsOf(const Spring& spring);
std::vector<Fault> FaultsOf(const DistanceJoint& joint);
std::vector<Fault> FaultsOf(const Cloth& cloth);
std::vector<Fault> FaultsOf(const Push& push);
std::vector<Fault> FaultsOf(const Claim& claim);
std::vector<Fault> FaultsOf(const Ensemble& ensemble);

/** Returns the faults of gravity, step and duration. `where` is e.g. "dt". */
std::vector<Fault> FaultsOfClock(const World& world);

/** Returns the faults of a spring's or a joint's ends: both on one thing, both immovable,
 or both at one point, where a rod has no direction. `where` starts with "A" or "B".
 @pre They are on things that `world` has. */
std::vector<Fault> FaultsOfEnds(const World& world, const Anchor& A, const Anchor& B);

/** Returns the faults of a push in its world: a body that never moves, a time that is not
 between two steps. @pre Its body is one of `world`, whose clock has no faults. */
std::vector<Fault> FaultsIn(const World& world, const Push& push);

/** Returns the faults of WorldScenario::horizon. */
std::vector<Fault> FaultsOfHorizon(double horizon);

/** Returns whether anything in `world` can move. */
bool Moves(const World& world);

/** Returns every fault of `world`; empty for one that may be simulated. `where` is e.g.
 "bodies.ball.mass", "springs[1].A"; by index where a body has no good name. */
std::vector<Fault> FaultsOf(const World& world);

/** Returns every fault of `scenario`, those of its world included; empty for one that
 WriteScenario() can write and ReadScenario() will accept. */
std::vector<Fault> FaultsOf(const WorldScenario& scenario);

}  // namespace touchstone
