#pragma once

#include <vector>

#include "scenarios/worlds/world.h"

namespace touchstone {

/** Moving things of a world, by index: those that a claim is about. */
struct Subjects {
  std::vector<int> bodies;     ///< Indices into World::bodies; all of them move.
  std::vector<int> particles;  ///< Indices into World::particles; all of them move.
  std::vector<int> cloths;     ///< Indices into World::cloths.
};

/** Returns whether `anchor` is on one of the subjects. */
bool Has(const Subjects& subjects, const Anchor& anchor);

/** Returns the index of the first node of cloth `index` in WorldState::nodes. */
int FirstNodeOf(const World& world, int index);

}  // namespace touchstone
