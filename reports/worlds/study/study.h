#pragma once

#include "oracles/oracle.h"
#include "scenarios/worlds/world_scenario.h"

namespace touchstone {

/** How one oracle moves one world, at the step that the world asks for and, where they
 were simulated, at a half and a quarter of it. */
struct Study {
  const WorldScenario& scenario;
  const OracleInfo& oracle;
  const Trajectory& trajectory;
  const Trajectory* half = nullptr;
  const Trajectory* quarter = nullptr;
};

/** Returns by how much rounding may move the places within `steps` steps. [m] */
double RoundingOf(const Study& study, double steps);

/** Returns from when on trajectories are not compared: the horizon of the scenario, or
 infinity. [s] */
double UntilOf(const Study& study);

}  // namespace touchstone
