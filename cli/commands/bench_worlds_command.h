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
  int seconds = 60;  ///< CPU time a thread after which an engine is stopped in a scene.
  int threads = 1;   ///< More: engines that know how are stepped with so many as well.
};

/** Returns the names of the scenes: "boxes100", …, "stack20", "spheres10000". */
std::vector<std::string> SceneNames();

/** Times a step of each engine in each scene, in turns, with the settings that its users
 run, and shows beside it what the state is worth, and how the times grow with the size of
 a scene. All run in one thread, and by its CPU time; where some are to have several
 threads too, all are timed by the clock on the wall, which is fair to both on a machine
 that does nothing else, and told where it did something else. Returns 0.
 @throws InputError where an oracle is unknown, or there is nothing to show. */
int BenchWorldsCommand(const Session& session, const BenchWorldsArguments& arguments);

}  // namespace touchstone
