#pragma once

#include "oracles/trajectory.h"
#include "scenarios/worlds/world.h"

namespace touchstone {

/** Returns a certified lower bound of the penetration depth of bodies A and B; 0 if they
 are apart, or if neither is certain. [m]

 @pre Not both are half-spaces. */
double OverlapOf(const World& world, const WorldState& state, int A, int B);

/** Returns the shape of body `index` at its pose in `state`. */
Body PlacedAt(const World& world, const WorldState& state, int index);

}  // namespace touchstone
