#pragma once

#include <memory>

#include "oracles/oracle.h"
#include "oracles/simulation.h"

namespace touchstone {

/** The integrator of MuJoCo that steps a world. */
enum class MujocoIntegrator {
  kEuler,  ///< Semi-implicit Euler.
  kRk4,    ///< Fourth-order Runge-Kutta method.
};

/** The stiffness of contacts and rods, and the way they are solved. */
enum class MujocoContacts {
  kRigid,      ///< The most rigid that MuJoCo allows, with Coulomb's circular cone.
  kAsShipped,  ///< MuJoCo's defaults: soft over 20 ms, with a friction pyramid.
};

/** Returns a simulation of `world` by MuJoCo.
 @pre MuJoCo can simulate it (DescribeMujocoWorlds) and is initialised.
 @throws std::runtime_error if MuJoCo refuses the model. */
std::unique_ptr<Simulation> MujocoWorld(const World& world, MujocoIntegrator integrator,
                                        MujocoContacts contacts);

/** Adds MuJoCo's capabilities for worlds, and the settings used in them, to `info`. */
void DescribeMujocoWorlds(MujocoIntegrator integrator, OracleInfo& info);

}  // namespace touchstone
