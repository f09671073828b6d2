#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scenarios/worlds/world.h"

namespace touchstone {

/** A world to be timed. */
struct Scene {
  std::string_view name;    ///< E.g. "boxes100".
  std::string_view title;   ///< E.g. "a pile of 100 boxes".
  std::string_view bodies;  ///< Kind of its bodies, shared by scenes of several sizes.
  int size;                 ///< Number of bodies.
  World (*make)(std::uint64_t seed);
};

/** Returns all scenes: piles of boxes or spheres of several sizes, and a stack. */
std::span<const Scene> Scenes();

/** Returns the names of all scenes. */
std::vector<std::string> SceneNames();

}  // namespace touchstone
