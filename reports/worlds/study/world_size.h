#pragma once

#include "oracles/trajectory.h"
#include "scenarios/worlds/world.h"

namespace touchstone {

/** Returns the size of what moves in a world: the largest |coordinate| that a trajectory
 reaches plus the largest bounding radius of a moving body. Rounding errors of positions
 are multiples of this times the unit roundoff. [m] */
double SizeOf(const World& world, const Trajectory& trajectory);

/** Returns the largest bounding radius of a moving body, 0 where there is none. [m] */
double LargestRadius(const World& world);

}  // namespace touchstone
