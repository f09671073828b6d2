#pragma once

#include "oracles/trajectory.h"
#include "scenarios/worlds/world.h"

namespace touchstone {

/** Returns the certified lower bound of how deep bodies A and B are in each other; 0
 where they are apart, or where neither could be said to be. [m]
 @pre Not both are half-spaces. */
double OverlapOf(const World& world, const WorldState& state, int A, int B);

/** Returns the shape of body `index` where `state` has it. */
Body PlacedAt(const World& world, const WorldState& state, int index);

}  // namespace touchstone
