#pragma once

#include <memory>

#include "oracles/oracle.h"
#include "oracles/simulation.h"

namespace touchstone {

/** Returns whether the corrected engine supports each feature of a world. */
decltype(OracleInfo::world_capabilities) CookbookWorldCapabilities();

/** Returns the settings in force when the corrected engine simulates worlds. */
std::vector<Setting> CookbookWorldSettings();

/** How accurately the corrected engine solves a step. */
enum class Care {
  kAll,        ///< To rounding, if a large iteration budget suffices.
  kAsShipped,  ///< With the engine's default settings.
};

/** Returns `world` at its start, in the corrected engine. Its steps use `threads`
 threads; the results are bitwise identical for any number.
 @pre The world is valid and within CookbookWorldCapabilities(). */
std::unique_ptr<Simulation> BeginCookbookWorld(const World& world, Care care,
                                               int threads = 1);

}  // namespace touchstone
