#pragma once

#include <span>
#include <vector>

#include "oracles/oracle.h"
#include "reports/finding/finding.h"
#include "scenarios/worlds/world_scenario.h"

namespace touchstone {

/** A motion with its findings. */
struct JudgedMotion {
  Trajectory trajectory;
  std::vector<Finding> findings;  ///< Sorted by measure; faults have a grade.
};

/** Simulates each world once, at its own step, and judges the motions by JudgeWorld():
 claims, laws of every motion, expectations. It asks nothing of other steps, of variants
 and of an ensemble, as RunWorlds() does, so it costs a tenth of that.

 Only a motion that fails is simulated at half and a quarter of its step, if IsStudied(),
 and only for the causes of its failures: the findings and their values are the same
 without. All worlds are simulated in two batches at most. */
std::vector<JudgedMotion> JudgeOnce(std::span<const WorldScenario> scenarios,
                                    const Oracle& oracle);

}  // namespace touchstone
