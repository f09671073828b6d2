#pragma once

#include <memory>
#include <span>
#include <string>

#include "oracles/oracle.h"
#include "oracles/simulation.h"

namespace touchstone {

/** The integrator of MuJoCo that steps a world. */
enum class MujocoIntegrator {
  kEuler,  ///< Semi-implicit Euler.
  kRk4,    ///< Fourth-order Runge-Kutta method.
};

/** Returns why MuJoCo cannot simulate `world`, whose features it has; empty if it can. */
std::string WhyNoMujocoWorld(const World& world);

/** Returns a simulation of `world` by MuJoCo, with `values` for the parameters that
 DescribeMujocoWorlds() declares.
 @pre MuJoCo can simulate it (DescribeMujocoWorlds, WhyNoMujocoWorld) and is initialised.
 @throws std::runtime_error if MuJoCo refuses the model. */
std::unique_ptr<Simulation> MujocoWorld(const World& world, MujocoIntegrator integrator,
                                        std::span<const double> values);

/** Adds MuJoCo's capabilities for worlds, and the settings and parameters used in them,
 to `info`. */
void DescribeMujocoWorlds(MujocoIntegrator integrator, OracleInfo& info);

}  // namespace touchstone
