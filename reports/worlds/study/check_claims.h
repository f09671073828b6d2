#pragma once

#include <vector>

#include "scenarios/diagnostic.h"
#include "scenarios/worlds/world_scenario.h"

namespace touchstone {

/** Returns what is wrong with the claims of a scenario: a law that nobody knows; a number
 that the law does not know; a law that does not apply to the world; a number that
 contradicts what the law derives. Each where it stands in the scenario's file; of a
 scenario without one, with its id for the file. */
std::vector<Diagnostic> ErrorsOfClaims(const WorldScenario& scenario);

}  // namespace touchstone
