#pragma once

#include "oracles/oracle.h"
#include "oracles/trajectory.h"
#include "reports/worlds/law_support/citing.h"
#include "scenarios/worlds/world.h"

namespace touchstone {

/** Returns the proof that the first sample of `trajectory` is not the starting state of
 `world`, by their first difference; an empty sentence if they agree to 64 roundings of
 the oracle's format. An engine with another starting state simulates another world, and
 no law applies to its motion.

 Positions are rounded relative to the largest coordinate plus the largest radius of all
 moving things, and at least to the body's own distance from the origin. Velocities are
 rounded relative to |v| + |ω| times that size, since some engines store them about the
 origin.
 @pre The trajectory is answered. */
CitingProof DeviationFromStart(const World& world, const OracleInfo& oracle,
                               const Trajectory& trajectory);

}  // namespace touchstone
