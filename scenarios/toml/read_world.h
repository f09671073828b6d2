#pragma once

#include "scenarios/toml/file_log.h"
#include "scenarios/worlds/world_scenario.h"

namespace touchstone {

/** Returns the world scenario of a file, and logs invalid values that have the right
 * type.
 */
WorldScenario WorldFrom(const toml::table& file, FileLog& log);

}  // namespace touchstone
