#pragma once

#include <vector>

#include "oracles/oracle.h"
#include "reports/finding/finding.h"
#include "reports/worlds/study/ensemble_statistics.h"
#include "scenarios/worlds/world_scenario.h"

namespace touchstone {

/** The judgement of an ensemble. */
struct EnsembleJudgement {
  /** The worst findings of all members: answering first, then one group per claim. */
  std::vector<std::vector<Finding>> groups;
  EnsembleStatistics statistics;
};

/** Simulates and judges the members of an ensemble other than the first. `first` is the
 motion of that one, and `groups` are its findings by JudgeWorldByClaim().
 @pre scenario.ensemble is set. */
EnsembleJudgement JudgeEnsemble(const WorldScenario& scenario, const Oracle& oracle,
                                const Trajectory& first,
                                std::vector<std::vector<Finding>> groups);

}  // namespace touchstone
