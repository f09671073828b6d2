#pragma once

#include <string>
#include <vector>

#include "scenarios/worlds/world_scenario.h"

namespace touchstone {

/** Returns what is wrong with the claims of a scenario, one sentence each: a law that
 nobody knows, with the nearest name; a law that does not apply to the world. */
std::vector<std::string> FaultsOfClaims(const WorldScenario& scenario);

}  // namespace touchstone
