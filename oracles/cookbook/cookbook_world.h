#pragma once

#include <memory>

#include "oracles/oracle.h"
#include "oracles/simulation.h"

namespace touchstone {

/** Returns what the corrected engine can do of each feature of a world. */
decltype(OracleInfo::world_capabilities) CookbookWorldCapabilities();

/** Returns what is in force where the corrected engine simulates worlds. */
std::vector<Setting> CookbookWorldSettings();

/** How long the corrected engine may take to solve a step. */
enum class Care {
  kAll,        ///< Until it is solved to rounding, where that can be waited for.
  kAsShipped,  ///< As the engine's defaults say.
};

/** Returns `world` at its start, in the corrected engine, in `threads` threads: the bits
 do not depend on them.
 @pre The world is valid and within CookbookWorldCapabilities(). */
std::unique_ptr<Simulation> BeginCookbookWorld(const World& world, Care care,
                                               int threads = 1);

}  // namespace touchstone
