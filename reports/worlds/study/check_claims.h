#pragma once

#include <vector>

#include "scenarios/diagnostic.h"
#include "scenarios/schema/scenario_schema.h"
#include "scenarios/worlds/world_scenario.h"

namespace touchstone {

/** Returns every name that a claim may have, with its documentation, sorted by name. */
std::vector<ClaimName> ClaimNames();

/** Returns the errors in the claims of a scenario: an unknown law; a number that the law
 does not know; a law that does not apply to the world; a number that contradicts what
 the law derives. Each error carries its position in the scenario's file. The id of the
 scenario replaces the file name if the scenario has no file. */
std::vector<Diagnostic> ErrorsOfClaims(const WorldScenario& scenario);

}  // namespace touchstone
