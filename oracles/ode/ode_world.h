#pragma once

#include <memory>
#include <vector>

#include "oracles/oracle.h"
#include "oracles/simulation.h"

namespace touchstone {

/** The solver of ODE that steps a world. */
enum class OdeStepper {
  kStep,       ///< dWorldStep: Dantzig's direct solver.
  kQuickStep,  ///< dWorldQuickStep: successive over-relaxation.
};

/** The stabilisation of constraints, and the number of iterations of QuickStep. */
enum class OdeConstraints {
  kRigid,      ///< The most rigid that ODE allows; overlap is not pushed out.
  kAsShipped,  ///< ODE's defaults.
};

/** Returns a simulation of `world` by ODE.
 @pre ODE can simulate it (DescribeOdeWorlds). ODE is initialised. */
std::unique_ptr<Simulation> OdeWorld(const World& world, OdeStepper stepper,
                                     OdeConstraints constraints);

/** Adds ODE's capabilities for worlds, and the settings used in them, to `info`. */
void DescribeOdeWorlds(OdeStepper stepper, OracleInfo& info);

}  // namespace touchstone
