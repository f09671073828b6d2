#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "oracles/oracle.h"
#include "oracles/simulation.h"

namespace touchstone {

/** The solver of ODE that steps a world. */
enum class OdeStepper {
  kStep,       ///< dWorldStep: Dantzig's direct solver.
  kQuickStep,  ///< dWorldQuickStep: successive over-relaxation.
};

/** Returns why ODE cannot simulate `world`, whose features it has; empty if it can. */
std::string WhyNoOdeWorld(const World& world);

/** Returns a simulation of `world` by ODE, with `values` for the parameters that
 DescribeOdeWorlds() declares.
 @pre ODE can simulate it (DescribeOdeWorlds, WhyNoOdeWorld). ODE is initialised. */
std::unique_ptr<Simulation> OdeWorld(const World& world, OdeStepper stepper,
                                     std::span<const double> values);

/** Adds ODE's capabilities for worlds, and the settings and parameters used in them, to
 `info`. */
void DescribeOdeWorlds(OdeStepper stepper, OracleInfo& info);

}  // namespace touchstone
