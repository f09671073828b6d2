#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cli/session.h"
#include "reports/bench/turns.h"

namespace touchstone {

/** The arguments of `touchstone bench worlds`. */
struct BenchWorldsArguments {
  std::vector<std::string> oracles;  ///< Names or groups; empty: all that simulate.
  std::vector<std::string> scenes;   ///< Names of scenes; empty: all of SceneNames().
  std::uint64_t seed = 1;
  TurnSettings turns;
};

/** Prints the time per step of each engine in each scene, the quality of the final state,
 and the growth of the times with the size of a scene. The engines take turns and run with
 their shipped settings. With one thread, the time is its CPU time. With several, all
 engines are timed by wall time: this is fair on an idle machine, and a line is printed
 for each row that had to wait for a processor. Returns 0.
 @throws InputError if an oracle is unknown, or nothing was measured. */
int BenchWorldsCommand(const Session& session, const BenchWorldsArguments& arguments);

}  // namespace touchstone
