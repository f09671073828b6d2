#pragma once

#include <vector>

#include "oracles/trajectory.h"
#include "reports/worlds/study/ensemble_statistics.h"
#include "reports/worlds/study/motion_drifts.h"
#include "reports/worlds/study/world_seconds.h"
#include "scenarios/worlds/world_scenario.h"

namespace touchstone {

/** A world with its motion by every oracle. */
struct WorldResult {
  WorldScenario scenario;
  /** Indexed by oracle; kUnsupported for those that do not simulate. */
  std::vector<Trajectory> trajectories;
  /** Indexed by oracle; all 0 for a motion that was not answered. */
  std::vector<MotionDrifts> drifts;
  /** Statistics of the world's ensemble, indexed by oracle; 0 members without one. */
  std::vector<EnsembleStatistics> ensembles;
  /** Indexed by oracle, 0 for those that were not asked; empty if nobody looked. */
  std::vector<WorldSeconds> seconds = {};
};

}  // namespace touchstone
