#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "oracles/oracle.h"
#include "reports/finding/finding.h"
#include "reports/worlds/study/world_result.h"
#include "scenarios/worlds/world_scenario.h"

namespace touchstone {

/** The results of RunWorlds(). */
struct WorldsReport {
  std::vector<WorldResult> worlds;  ///< In the order of the scenarios.
  /** Sorted by world, then oracle, then measure. Oracles that only answer contact queries
   have none. */
  std::vector<Finding> findings;
};

/** Simulates every world with every oracle that can simulate, and judges the motions.
 Each world is simulated at its step; if IsStudied(), also at half and a quarter of it,
 with a moved start and in its variants. Each member of an ensemble is simulated once, and
 the worst finding per claim and measure is kept. Larger worlds are simulated once only. A
 world with a failure is asked again as shipped, see CompareWithShipped().

 The report does not depend on the number of jobs. `on_done` is called after each pair of
 world and oracle, from any thread. */
WorldsReport RunWorlds(std::span<const WorldScenario> worlds,
                       std::span<const Oracle* const> oracles, int jobs,
                       const std::function<void()>& on_done);

/** Returns the number of times that RunWorlds() calls `on_done`. */
std::size_t CountOfWorldRuns(std::span<const WorldScenario> worlds,
                             std::span<const Oracle* const> oracles);

}  // namespace touchstone
