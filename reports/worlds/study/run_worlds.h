#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "oracles/oracle.h"
#include "reports/finding/finding.h"
#include "reports/worlds/study/ensemble_statistics.h"
#include "scenarios/worlds/world_scenario.h"

namespace touchstone {

/** One world with every motion of it. */
struct WorldResult {
  WorldScenario scenario;
  /** In the order of the oracles; kUnsupported for those that do not simulate. */
  std::vector<Trajectory> trajectories;
  /** The same of what the members of its ensemble, if it has one, have in common. */
  std::vector<EnsembleStatistics> ensembles;
};

/** What came of the worlds. */
struct WorldsReport {
  std::vector<WorldResult> worlds;  ///< In the order of the questions.
  /** By world, then oracle, then measure. Oracles that answer contact queries only have
   none. */
  std::vector<Finding> findings;
};

/** Puts every world to every oracle that simulates, at its step and where it is worth it
 at a half and a quarter, with its variants, and judges the motions; of an ensemble every
 member once, and the worst finding of each kind counts. Worlds of more than
 kStudiedBodySteps body-steps are simulated once.

 Deterministic whatever the number of jobs. `on_done` is called after each pair of world
 and oracle, from any thread. */
WorldsReport RunWorlds(std::span<const WorldScenario> worlds,
                       std::span<const Oracle* const> oracles, int jobs,
                       const std::function<void()>& on_done);

/** Returns how often RunWorlds() calls `on_done`. */
std::size_t CountOfWorldRuns(std::span<const WorldScenario> worlds,
                             std::span<const Oracle* const> oracles);

/** The claim that a second run gives the same bits. No law of one motion can tell it. */
inline constexpr std::string_view kDeterministic = "deterministic";

/** The claim that what moves the start moves the motion by no more than `gain` times as
 much, a number of the claim: then variants are compared to the end, whatever an engine
 makes of rounding. Of worlds that are studied. */
inline constexpr std::string_view kStable = "stable";
inline constexpr std::string_view kStableGain = "gain";

/** Whether a world is small enough to be simulated at other steps and in variants. */
bool IsStudied(const WorldScenario& scenario);

/** The bodies and nodes times steps up to which a world is simulated at other steps and
 in variants: a second or so of the slowest engine. */
inline constexpr double kStudiedBodySteps = 1e5;

}  // namespace touchstone
