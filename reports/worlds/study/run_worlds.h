#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "oracles/oracle.h"
#include "reports/finding/finding.h"
#include "reports/threads/stop.h"
#include "reports/worlds/study/examine_world.h"
#include "reports/worlds/study/world_result.h"
#include "scenarios/worlds/world_scenario.h"

namespace touchstone {

/** Further arguments of RunWorlds(). Its functions may be called from any thread, and may
 be empty. */
struct WorldsOptions {
  int jobs = 0;  ///< Number of threads; 0: one per core.
  /** Called after each pair of world and oracle with its share of WorkOfWorlds(). */
  std::function<void(double body_steps)> on_done = {};
  /** Returns the result of a pair if it is known already. */
  std::function<std::optional<Examination>(const WorldScenario&, const OracleInfo&)>
      find = {};
  /** Keeps the result of a pair. */
  std::function<void(const WorldScenario&, const OracleInfo&, const Examination&)> keep =
      {};
  Stop stop = {};  ///< No further pair is then begun, and the report lacks the others.
};

/** The results of RunWorlds(). */
struct WorldsReport {
  std::vector<WorldResult> worlds;  ///< In the order of the scenarios.
  /** Sorted by world, then oracle, then measure. Oracles that only answer contact queries
   have none. */
  std::vector<Finding> findings;
};

/** Simulates every world with every oracle that can simulate, and judges the motions.
 Each world is simulated at its step; if IsStudied(), also at half of it, with a moved
 start and in its variants, and at a quarter of it where a claim is judged by order or
 limit, or a failure needs its cause. Each member of an ensemble is simulated once, and
 the worst finding per claim and measure is kept. Larger worlds are simulated once only.
 CompareWithShipped() then asks with the engine's shipped settings.

 The report does not depend on the number of jobs. */
WorldsReport RunWorlds(std::span<const WorldScenario> worlds,
                       std::span<const Oracle* const> oracles,
                       const WorldsOptions& options);

/** Returns the number of times that RunWorlds() calls WorldsOptions::on_done. */
std::size_t CountOfWorldRuns(std::span<const WorldScenario> worlds,
                             std::span<const Oracle* const> oracles);

/** Returns the approximate cost of all of them. [body-steps] */
double WorkOfWorlds(std::span<const WorldScenario> worlds,
                    std::span<const Oracle* const> oracles);

}  // namespace touchstone
