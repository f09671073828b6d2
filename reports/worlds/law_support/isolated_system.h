#pragma once

#include <vector>

#include "reports/worlds/law_support/subjects.h"
#include "scenarios/validate.h"
#include "scenarios/worlds/world_scenario.h"

namespace touchstone {

/** Returns the reasons why the subjects of `claim` are not an isolated system: unusable
 names, springs and joints to things outside it, damped particles and cloths, pinned
 cloths. Contacts with things outside cannot be predicted from the world: the author
 vouches for their absence. */
std::vector<Fault> FaultsOfIsolation(const World& world, const Claim& claim);

/** Returns the reasons why the energy of the subjects is not theirs alone: springs and
 joints to other moving things, and pushes. @pre FaultsOfSubjects() is empty. */
std::vector<Fault> FaultsOfEnergy(const World& world, const Claim& claim);

/** Returns the projection onto the direction (x, y, z) along which `claim` states that a
 quantity is conserved; the identity if it gives no direction. */
Eigen::Matrix3d ProjectionOf(const Claim& claim);

}  // namespace touchstone
