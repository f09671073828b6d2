#pragma once

#include "oracles/oracle.h"
#include "reports/worlds/study/world_seconds.h"
#include "scenarios/worlds/world_scenario.h"

namespace touchstone {

/** The motions of one world by one oracle: at the step of the world and, if they were
 simulated, at half and a quarter of it. */
struct Study {
  const WorldScenario& scenario;
  const OracleInfo& oracle;
  const Trajectory& trajectory;
  const Trajectory* half = nullptr;     ///< Null if not simulated.
  const Trajectory* quarter = nullptr;  ///< Null if not simulated.
  /** The first motion with a sample at every step; null if nobody took them. */
  const Trajectory* of_steps = nullptr;
  /** Where the judgement adds the time that each law takes; null: nobody asks. */
  SecondsByName* seconds_of_laws = nullptr;
};

/** Returns the largest change of positions by rounding within `steps` steps. [m] */
double RoundingOf(const Study& study, double steps);

/** Returns the time from which on trajectories are not compared: the horizon of the
 scenario, or infinity. [s] */
double UntilOf(const Study& study);

}  // namespace touchstone
