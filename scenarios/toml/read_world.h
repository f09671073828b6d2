#pragma once

#include <filesystem>

#include "scenarios/toml/file_log.h"
#include "scenarios/worlds/world_scenario.h"

namespace touchstone {

/** Returns the world scenario of a file, and logs invalid values that have the right
 type. Files that it names are looked up in `folder`. */
WorldScenario WorldFrom(const toml::table& file, const std::filesystem::path& folder,
                        FileLog& log);

}  // namespace touchstone
