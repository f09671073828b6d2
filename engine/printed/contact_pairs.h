#pragma once

#include <span>
#include <vector>

#include "engine/printed/collide.h"
#include "engine/printed/world.h"

namespace cookbook::printed {

/** Two bodies that touch. */
struct ContactPair {
  int A;
  int B;
  Manifold manifold;
};

/** Returns the touching pairs, of which at least one body moves, every body tried against
 every other. */
std::vector<ContactPair> TouchingPairs(std::span<const Body> bodies,
                                       const Errata& errata);

/** Applies the impulses of all contacts, sweep by sweep, and returns what each gave.

 Put right: each contact aims at −e times its normal velocity from before the first sweep;
 its sum of normal impulses is never negative, its sum of friction never longer than μ
 times that. */
std::vector<ContactImpulse> ApplyImpulses(std::span<Body> bodies,
                                          std::span<const ContactPair> pairs,
                                          int iterations, const Errata& errata);

/** Moves the bodies of each pair apart by a share of the depth beyond the slack, by
 inverse mass; put right, it also turns them, each contact pushing at its own place. */
void Project(std::span<Body> bodies, std::span<const ContactPair> pairs, double share,
             double slack, const Errata& errata);

}  // namespace cookbook::printed
