#pragma once

#include <string_view>
#include <vector>

#include "scenarios/validate.h"
#include "scenarios/worlds/world_scenario.h"

namespace touchstone {

/** Largest accepted deviation of a time from a multiple of the step, as a fraction of a
 step. It is above the rounding of time / dt for every allowed number of steps, and far
 below any intended difference. */
inline constexpr double kStepSlack = 1e-6;

/** Largest number of steps of a world: twice that of the longest in the catalogue, and a
 minute of a slow engine with six bodies. */
inline constexpr int kMostSteps = 1'000'000;

// These functions check each part on its own: finite numbers in their ranges. They return
// no faults for a valid part. `where` is the key that a file uses, e.g. "inertia[1]".

/** Also checks that a solid can have the inertia, or that the shape implies one, and that
 a body of mass 0 does not move. */
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

/** Returns the faults of the ends of a spring or a joint: both on the same body or
 particle, both immovable, or both at one point, where a rod has no direction. `where`
 starts with "A" or "B". @pre The anchors' bodies and particles exist in `world`. */
std::vector<Fault> FaultsOfEnds(const World& world, const Anchor& A, const Anchor& B);

/** Returns the faults of a push in its world: a body that never moves, or a time that is
 not between two steps. @pre Its body exists in `world`, whose clock has no faults. */
std::vector<Fault> FaultsIn(const World& world, const Push& push);

/** Returns the faults of an expectation by itself: a number that is not finite, a
 tolerance that is not positive, a direction of no length, a quaternion off unit length.
 */
std::vector<Fault> FaultsOf(const MotionExpectation& expectation);

/** Returns the faults of an expectation in its world: a name that the world does not
 have, or that never moves; a time that is not that of a sample, or after the end.
 @pre The clock of `world` has no faults. */
std::vector<Fault> FaultsIn(const World& world, const MotionExpectation& expectation);

/** Returns the key under which a file states what is expected: "position", "angle", … */
std::string_view KeyOf(const MotionExpectation& expectation);

/** Returns the key of its time, "at" or "by"; empty for a trajectory. */
std::string_view TimeKeyOf(const MotionExpectation& expectation);

/** Returns the faults of WorldScenario::horizon. */
std::vector<Fault> FaultsOfHorizon(double horizon);

/** Returns whether anything in `world` can move. */
bool Moves(const World& world);

/** Returns every fault of `world`; empty for a world that can be simulated. `where` is
 e.g. "bodies.ball.mass" or "springs[1].A"; a body without a valid name is given by its
 index.
 */
std::vector<Fault> FaultsOf(const World& world);

/** Returns every fault of `scenario`, including those of its world. It is empty for a
 scenario that WriteScenario() can write and ReadScenario() accepts. */
std::vector<Fault> FaultsOf(const WorldScenario& scenario);

}  // namespace touchstone
