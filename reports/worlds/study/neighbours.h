#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "oracles/oracle.h"
#include "reports/worlds/study/wanted_neighbours.h"
#include "reports/worlds/study/world_variants.h"
#include "scenarios/worlds/world_scenario.h"

namespace touchstone {

/** A variant of a world with its motion by one oracle. */
struct VariantMotion {
  WorldVariant variant;
  Trajectory trajectory;
};

/** The motions of the changed copies of a world by one oracle. All but `again` are left
 empty unless IsStudied(), and those that are not wanted. */
struct Neighbours {
  Trajectory half;                    ///< At half the step.
  std::optional<Trajectory> quarter;  ///< At a quarter of the step.
  std::vector<Trajectory> nudged;     ///< With the start moved, one way and the other.
  std::vector<VariantMotion> variants;
  Trajectory again;  ///< A second run; only with the claim `deterministic`.
};

/** Simulates `count` copies of a world with its start moved by up to `nudge` [m] along
 each axis: every second one is moved opposite to the one before. */
std::vector<Trajectory> SimulateNudged(const WorldScenario& scenario,
                                       const Oracle& oracle, double nudge,
                                       std::size_t count);

/** Simulates the wanted ones in one batch, so that an isolated oracle forks only once.
 Half the step is among them unless the moved starts alone are wanted, which say whether a
 world is stable. A quarter of the step is among them only if a claim is judged by order
 or limit; whether causes need it, the judgement of the others tells. `nudge` is the
 largest move of a start along each axis. [m] */
Neighbours SimulateNeighbours(const WorldScenario& scenario, const Oracle& oracle,
                              double nudge, const WantedNeighbours& wanted);

}  // namespace touchstone
