#pragma once

#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "reports/finding/cited.h"
#include "scenarios/worlds/world_scenario.h"

namespace touchstone {

/** A world and a claim whose names occur in no sentence but where they are meant. */
struct Unmistakable {
  World world;
  Claim claim;
};

/** Renames all bodies, particles and cloths. */
Unmistakable WithUnmistakableNames(World world, Claim claim);

/** Succeeds if `cited` has what `sentence` names: the same parts of `world` in the same
 order, its moment if it names any, and points that it shows. The world has
 unmistakable names. */
testing::AssertionResult CitesWhatItSays(const World& world, std::string_view sentence,
                                         const Cited& cited);

}  // namespace touchstone
