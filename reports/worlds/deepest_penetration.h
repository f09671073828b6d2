#pragma once

#include "oracles/trajectory.h"
#include "scenarios/worlds/world.h"

namespace touchstone {

/** Where two bodies of a world overlap most. */
struct Penetration {
  /** [m]; 0 where nothing overlaps, NaN where body A is nowhere. */
  double depth = 0;
  int A = -1;  ///< Into World::bodies; −1 where nothing overlaps.
  int B = -1;
};

/** Returns the deepest overlap of two bodies that collide and of which at least one
 moves, as the referee of contact queries certifies it: the middle of the enclosure. */
Penetration DeepestPenetration(const World& world, const WorldState& state);

}  // namespace touchstone
