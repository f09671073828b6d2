#pragma once

#include <vector>

#include "oracles/oracle.h"
#include "reports/finding/finding.h"
#include "reports/worlds/study/ensemble_statistics.h"
#include "reports/worlds/study/world_seconds.h"
#include "scenarios/worlds/world_scenario.h"

namespace touchstone {

/** The judgement of an ensemble. */
struct EnsembleJudgement {
  /** The worst findings of all members: answering first, then one group per claim. */
  std::vector<std::vector<Finding>> groups;
  EnsembleStatistics statistics;
  double seconds = 0;  ///< That the oracle took for the members other than the first. [s]
};

/** Simulates and judges the members of an ensemble other than the first. `first` is the
 motion of that one, and `groups` are its findings by JudgeWorldByClaim();
 `seconds_of_laws` as in Study.
 @pre scenario.ensemble is set. */
EnsembleJudgement JudgeEnsemble(const WorldScenario& scenario, const Oracle& oracle,
                                const Trajectory& first,
                                std::vector<std::vector<Finding>> groups,
                                SecondsByName* seconds_of_laws = nullptr);

}  // namespace touchstone
