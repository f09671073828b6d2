#pragma once

#include <string>

#include "oracles/oracle.h"
#include "oracles/trajectory.h"
#include "scenarios/worlds/world.h"

namespace touchstone {

/** Returns a description of the first difference between the first sample of `trajectory`
 and the starting state of `world`; empty if they agree to 64 roundings of the oracle's
 format. An engine with another starting state simulates another world, and no law applies
 to its motion.

 Positions are rounded relative to the largest coordinate plus the largest radius of all
 moving things, and at least to the body's own distance from the origin. Velocities are
 rounded relative to |v| + |ω| times that size, since some engines store them about the
 origin.
 @pre The trajectory is answered. */
std::string DeviationFromStart(const World& world, const OracleInfo& oracle,
                               const Trajectory& trajectory);

}  // namespace touchstone
