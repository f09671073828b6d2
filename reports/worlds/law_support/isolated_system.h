#pragma once

#include <vector>

#include "scenarios/validate.h"
#include "scenarios/worlds/world_scenario.h"

namespace touchstone {

/** Returns the reasons why the subjects of `claim` are not an isolated system: unusable
 names, springs and joints to things outside it, damped particles and cloths, pinned
 cloths. Contacts with things outside cannot be predicted from the world: the author
 vouches for their absence. */
std::vector<Fault> FaultsOfIsolation(const World& world, const Claim& claim);

}  // namespace touchstone
