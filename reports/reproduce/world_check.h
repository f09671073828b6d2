#pragma once

#include <vector>

#include "oracles/trajectory.h"
#include "reports/finding/finding.h"
#include "reports/reproduce/fault_check.h"
#include "scenarios/worlds/world_scenario.h"

namespace touchstone {

/** The check of a finding on a motion. */
struct WorldCheck {
  FaultCheck code;         ///< The statements read `states`, a std::map by step.
  std::vector<int> steps;  ///< The steps after which it needs the state.
};

/** Returns the check of `finding` on the motion `trajectory` of an engine. It repeats the
 measure's formula for the bodies and the time of the finding. These are those with which
 the formula gives the finding's value.

 Throws CannotReproduce if the verdict or the measure has no check, or if the value is not
 that of a state of the motion. */
WorldCheck CheckOf(const Finding& finding, const WorldScenario& scenario,
                   const Trajectory& trajectory);

}  // namespace touchstone
