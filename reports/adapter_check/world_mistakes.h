#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "oracles/trajectory.h"
#include "scenarios/worlds/world.h"

namespace touchstone {

/** A mistake that adapters make with worlds, as the world that the engine in effect
 simulated, or as the motion that it in effect returned. */
struct WorldMistake {
  std::string sentence;  ///< What the adapter does: "it leaves out gravity".
  /** Returns the world that the engine simulates; nothing if the mistake changes nothing
   about it. Empty for a mistake in the answer. */
  std::function<std::optional<World>(const World&)> simulated;
  /** Changes a motion with the mistake into what it was before. Empty for a mistake in
   the question. */
  std::function<void(const World&, Trajectory&)> undo;
};

/** Returns the mistakes that we know, the simpler ones first. */
const std::vector<WorldMistake>& WorldMistakes();

}  // namespace touchstone
