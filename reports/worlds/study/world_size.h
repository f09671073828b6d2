#pragma once

#include "oracles/trajectory.h"
#include "scenarios/worlds/world.h"

namespace touchstone {

/** Returns the size of a motion: the largest absolute coordinate of anything that moves
 plus the largest bounding radius of a moving body. Rounding errors of positions are
 multiples of this size times the unit roundoff. [m] */
double SizeOf(const World& world, const Trajectory& trajectory);

/** Returns the largest bounding radius of a moving body, 0 if there is none. [m] */
double LargestRadius(const World& world);

}  // namespace touchstone
