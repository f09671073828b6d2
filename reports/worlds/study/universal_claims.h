#pragma once

#include <vector>

#include "scenarios/worlds/world_scenario.h"

namespace touchstone {

/** Returns the claims by which every motion of the world is judged although its file does
 not state them, in the order of Laws(); see Law::universal. Claims of the file replace
 them:

 - a claim about everything replaces that of its law, unless it speaks of one direction
   alone; conserves_energy replaces energy_never_rises too;
 - a claim about some things replaces it for those, if the law judges each by itself, and
   for their pairs with the others (Claim::claimed). */
std::vector<Claim> UniversalClaims(const WorldScenario& scenario);

}  // namespace touchstone
