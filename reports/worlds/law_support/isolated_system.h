#pragma once

#include <vector>

#include "scenarios/validate.h"
#include "scenarios/worlds/world_scenario.h"

namespace touchstone {

/** Returns what keeps the subjects of `claim` from being a system of their own: names
 that cannot be meant, springs and joints that reach out of it, damped particles and
 cloths, pinned cloths. What may touch it cannot be told from the world: the author
 vouches for that. */
std::vector<Fault> FaultsOfIsolation(const World& world, const Claim& claim);

}  // namespace touchstone
