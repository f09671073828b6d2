#pragma once

#include <memory>

#include "oracles/bullet/bullet_module.h"
#include "oracles/simulation.h"

namespace touchstone {

/** Returns `world` in the hands of the Bullet of `module`.
 @pre Bullet can simulate it (BulletOracleInfo). */
std::unique_ptr<Simulation> BulletSimulation(const BulletModule& module,
                                             const World& world,
                                             BulletConstraints constraints);

}  // namespace touchstone
