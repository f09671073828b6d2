#pragma once

#include "oracles/simulation.h"

namespace touchstone {

/** Average time of a step. Sent as plain bytes. [µs] */
struct StepTime {
  double cpu = 0;   ///< CPU time of the thread that requests the step, without helpers.
  double wall = 0;  ///< Wall time, including other work of the machine.
  /** Time for which threads were ready to run but had no processor, summed over threads;
   0 if the system does not report it. */
  double waited = 0;
};

/** Takes `steps` > 0 steps and returns the average time of one. The CPU time of one
 thread excludes other work of the machine. With several threads it is meaningless, since
 one may work while the others wait. */
StepTime TimeSteps(Simulation& simulation, int steps);

}  // namespace touchstone
