#pragma once

#include <memory>

#include "oracles/oracle.h"
#include "oracles/simulation.h"

namespace touchstone {

/** Which of MuJoCo's integrators moves a world. */
enum class MujocoIntegrator {
  kEuler,  ///< Semi-implicit Euler.
  kRk4,    ///< Runge and Kutta's of fourth order.
};

/** How stiff contacts and rods are, and how they are solved. */
enum class MujocoContacts {
  kRigid,      ///< As rigid as MuJoCo can make them, Coulomb's circular cone.
  kAsShipped,  ///< MuJoCo's defaults: soft over 20 ms, a pyramid for a cone.
};

/** Returns `world` in the hands of MuJoCo.
 @pre MuJoCo can simulate it (DescribeMujocoWorlds) and is initialised.
 @throws std::runtime_error where it refuses the model. */
std::unique_ptr<Simulation> MujocoWorld(const World& world, MujocoIntegrator integrator,
                                        MujocoContacts contacts);

/** Adds to `info` what MuJoCo can do of worlds, and what is set in them. */
void DescribeMujocoWorlds(MujocoIntegrator integrator, OracleInfo& info);

}  // namespace touchstone
