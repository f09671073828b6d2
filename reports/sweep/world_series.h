#pragma once

#include <cstdint>
#include <string>

#include "scenarios/generators/worlds/world_family.h"
#include "scenarios/worlds/world_scenario.h"

namespace touchstone {

/** A seeded series of generated worlds, the same on every machine. */
struct WorldSeries {
  WorldFamily family = WorldFamily::kDrops;
  std::uint64_t seed = 1;
  std::uint64_t first = 0;  ///< Index of the first world.
  std::uint64_t count = 1000;
};

/** Returns the id of world `index`, such as "sweep/world/drops/seed_1/0...42". */
std::string IdOf(const WorldSeries& series, std::uint64_t index);

/** Returns world `index` of the family as a scenario. */
WorldScenario WorldAt(const WorldSeries& series, std::uint64_t index);

/** Returns the command line that repeats world `index`. */
std::string ReplayOf(const WorldSeries& series, std::uint64_t index);

}  // namespace touchstone
