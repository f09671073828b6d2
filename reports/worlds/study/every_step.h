#pragma once

#include "oracles/trajectory.h"
#include "scenarios/worlds/world.h"

namespace touchstone {

/** Returns `world` with a sample at every step. */
World EveryStep(const World& world);

/** Returns a motion of EveryStep(world) with the samples that `world` asks for. */
Trajectory SampledAs(const World& world, const Trajectory& of_steps);

}  // namespace touchstone
