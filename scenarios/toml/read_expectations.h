#pragma once

#include <filesystem>
#include <vector>

#include "scenarios/toml/file_log.h"
#include "scenarios/toml/world_names.h"
#include "scenarios/worlds/motion_expectation.h"

namespace touchstone {

/** The world that expectations are about. */
struct ExpectedOf {
  const World& world;
  bool clock_is_good;                   ///< Whether its clock has no faults.
  const std::filesystem::path& folder;  ///< The folder of the scenario's file.
};

/** Returns the list [[expect]] of a world's file, and logs invalid ones. */
std::vector<MotionExpectation> ExpectationsFrom(const toml::table& file,
                                                const ExpectedOf& of, WorldNames& names,
                                                FileLog& log);

}  // namespace touchstone
