#pragma once

#include "scenarios/worlds/world_scenario.h"

namespace touchstone {

/** Returns member `index` of the ensemble of `scenario`: its world with each coordinate
 of the initial position of each moving part displaced by up to the jitter. The result is
 the same on every machine. Member 0 is the world itself.
 @pre The scenario has an ensemble, and 0 <= index < members. */
World MemberOf(const WorldScenario& scenario, int index);

}  // namespace touchstone
