#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cli/session.h"

namespace touchstone {

struct BenchWorldsArguments {
  std::vector<std::string> oracles;  ///< Names or groups; empty: all that simulate.
  std::vector<std::string> scenes;   ///< Empty: all of SceneNames().
  int steps = 240;                   ///< That are timed, after as many to settle.
  std::uint64_t seed = 1;
  int seconds = 60;  ///< CPU time after which an engine is stopped in a scene.
};

/** Returns the names of the scenes: "boxes100", …, "stack20", "spheres10000". */
std::vector<std::string> SceneNames();

/** Times a step of each engine in each scene, in turns, in one thread, with the settings
 that its users run, and shows beside it what the state is worth. Returns 0. */
int BenchWorldsCommand(const Session& session, const BenchWorldsArguments& arguments);

}  // namespace touchstone
