#pragma once

#include "scenarios/toml/file_log.h"
#include "scenarios/worlds/world_scenario.h"

namespace touchstone {

/** Returns the world of a file with all that is said of it, and logs values of the right
 type that cannot be. */
WorldScenario WorldFrom(const toml::table& file, FileLog& log);

}  // namespace touchstone
