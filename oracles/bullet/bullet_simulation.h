#pragma once

#include <memory>
#include <span>

#include "oracles/bullet/bullet_module.h"
#include "oracles/simulation.h"

namespace touchstone {

/** Returns a simulation of `world` by the build of Bullet in `module`, with a value for
 each BulletParameter.
 @pre Bullet can simulate it (BulletOracleInfo). */
std::unique_ptr<Simulation> BulletSimulation(const BulletModule& module,
                                             const World& world,
                                             std::span<const double> values);

}  // namespace touchstone
