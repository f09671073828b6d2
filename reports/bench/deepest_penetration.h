#pragma once

#include "oracles/trajectory.h"
#include "scenarios/worlds/world.h"

namespace touchstone {

/** The two bodies of a world that overlap most. */
struct Penetration {
  /** 0 if nothing overlaps; NaN if the pose of body A is not finite. [m] */
  double depth = 0;
  int A = -1;  ///< Index into World::bodies; −1 if nothing overlaps.
  int B = -1;  ///< The same; also −1 if the pose of A is not finite.
};

/** Returns the deepest overlap of any two bodies that collide, at least one of which can
 move. The referee of contact queries certifies each depth; the middle of its enclosure is
 used. */
Penetration DeepestPenetration(const World& world, const WorldState& state);

}  // namespace touchstone
