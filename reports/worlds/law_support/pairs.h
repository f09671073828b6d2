#pragma once

#include <utility>
#include <vector>

#include "reports/worlds/law_support/subjects.h"

namespace touchstone {

/** Returns whether two different bodies collide; two half-spaces never do. */
bool Collide(const World& world, int A, int B);

/** Returns the pairs of bodies that collide and of which at least one is a subject, each
 once. The first of a pair moves. */
std::vector<std::pair<int, int>> CollidingPairs(const World& world,
                                                const Subjects& subjects);

/** Returns the pairs of the subjects of `claim`, except those that another claim of the
 law judges. */
std::vector<std::pair<int, int>> CollidingPairs(const World& world, const Claim& claim);

}  // namespace touchstone
