#pragma once

#include <memory>
#include <vector>

#include "oracles/oracle.h"
#include "oracles/simulation.h"

namespace touchstone {

/** Which of ODE's solvers steps a world. */
enum class OdeStepper {
  kStep,       ///< dWorldStep: Dantzig's direct solver.
  kQuickStep,  ///< dWorldQuickStep: successive over-relaxation.
};

/** How constraints are stabilised, and how long QuickStep iterates. */
enum class OdeConstraints {
  kRigid,      ///< As rigid as ODE can make them; overlap is not pushed out.
  kAsShipped,  ///< ODE's defaults.
};

/** Returns `world` in the hands of ODE.
 @pre ODE can simulate it (DescribeOdeWorlds). ODE is initialised. */
std::unique_ptr<Simulation> OdeWorld(const World& world, OdeStepper stepper,
                                     OdeConstraints constraints);

/** Adds to `info` what ODE can do of worlds, and what is set in them. */
void DescribeOdeWorlds(OdeStepper stepper, OracleInfo& info);

}  // namespace touchstone
