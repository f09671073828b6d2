#pragma once

#include "scenarios/worlds/body_steps.h"
#include "scenarios/worlds/world_scenario.h"

namespace touchstone {

/** The largest product of steps and the number of moving bodies, particles and cloth
 nodes at which a world is studied: about a second of the slowest engine. [body-steps] */
inline constexpr double kStudiedBodySteps = 1e5;

/** Returns whether a world is simulated at other steps and in variants too: it has at
 most kStudiedBodySteps body-steps. */
bool IsStudied(const WorldScenario& scenario);

}  // namespace touchstone
