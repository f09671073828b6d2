#pragma once

#include "oracles/trajectory.h"
#include "scenarios/worlds/world.h"

namespace touchstone {

/** Returns the size of a motion: the largest absolute coordinate of anything that moves
 plus the largest bounding radius of a moving body. Rounding errors of positions are
 multiples of this size times the unit roundoff. [m] */
double SizeOf(const World& world, const Trajectory& trajectory);

/** Returns the largest R (I_max/I_min − 1) |ω| T of a moving body, with its bounding
 radius R and the duration T of the motion. An orientation that is off by δ turns I; where
 an engine takes the spin from the angular momentum, that changes it by up to
 δ (I_max/I_min − 1) |ω|, and moves the surface for the rest of the motion. So roundings
 of orientations move bodies by multiples of this times the unit roundoff. 0 for isotropic
 bodies. [m] */
double SpinSizeOf(const World& world, const Trajectory& trajectory);

/** Returns the largest bounding radius of a moving body, 0 if there is none. [m] */
double LargestRadius(const World& world);

}  // namespace touchstone
