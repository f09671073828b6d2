#pragma once

#include <memory>

#include "oracles/oracle.h"
#include "oracles/simulation.h"

namespace touchstone {

/** Returns whether the corrected engine supports each feature of a world. */
decltype(OracleInfo::world_capabilities) CookbookWorldCapabilities();

/** Returns the settings of the corrected engine for worlds. */
std::vector<Setting> CookbookWorldSettings();

/** Returns `world` at its start, in the corrected engine with its default settings. Its
 steps use `threads` threads; the results are bitwise identical for any number.
 @pre The world is valid and within CookbookWorldCapabilities(). */
std::unique_ptr<Simulation> BeginCookbookWorld(const World& world, int threads = 1);

}  // namespace touchstone
