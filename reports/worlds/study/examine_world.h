#pragma once

#include <vector>

#include "oracles/oracle.h"
#include "reports/finding/finding.h"
#include "reports/worlds/study/ensemble_statistics.h"
#include "reports/worlds/study/motion_drifts.h"
#include "reports/worlds/study/wanted_neighbours.h"
#include "reports/worlds/study/world_seconds.h"
#include "scenarios/worlds/world_scenario.h"

namespace touchstone {

/** The results of all simulations of one world by one oracle. */
struct Examination {
  Trajectory trajectory;        ///< Motion of the world itself.
  MotionDrifts drifts;          ///< Those of that motion.
  EnsembleStatistics ensemble;  ///< 0 members unless the world has an ensemble.
  std::vector<Finding> findings;
  WorldSeconds seconds;
};

/** Simulates the world, its neighbours and the members of its ensemble, and judges the
 motions. */
Examination ExamineWorld(const WorldScenario& scenario, const Oracle& oracle);

/** The same for a world whose motion is known already: `of_steps` is that of
 EveryStep(scenario.world) by `oracle`. */
Examination ExamineMotion(const WorldScenario& scenario, const Oracle& oracle,
                          const Trajectory& of_steps, const WantedNeighbours& wanted);

}  // namespace touchstone
