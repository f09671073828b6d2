#pragma once

#include <string>

#include "oracles/oracle.h"
#include "oracles/trajectory.h"
#include "scenarios/worlds/world.h"

namespace touchstone {

/** Says where the first sample of `trajectory` is not the state that `world` gives, to 64
 roundings of the oracle's format; empty where it is: an engine that starts elsewhere
 moves another world, and what laws say of it is void.

 Positions round as large as the farthest thing is from the origin and as large as it is
 itself; velocities with them where an engine keeps them about the origin: |v| + |ω| that.
 @pre The trajectory is answered. */
std::string DeviationFromStart(const World& world, const OracleInfo& oracle,
                               const Trajectory& trajectory);

}  // namespace touchstone
