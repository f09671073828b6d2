#pragma once

#include <span>
#include <vector>

#include "engine/printed/collide.h"
#include "engine/printed/world.h"

namespace cookbook::printed {

/** Two touching bodies, given as indices, and their manifold. */
struct ContactPair {
  int A;
  int B;
  Manifold manifold;
};

/** Returns the touching pairs with at least one body that is not static. Every body is
 tested against every other. */
std::vector<ContactPair> TouchingPairs(std::span<const Body> bodies,
                                       const Errata& errata);

/** Applies the impulses of all contacts, iteration by iteration, and returns the impulse
 of each contact.

 In the corrected recipe, the target velocity of a contact is −e times its normal velocity
 before the first iteration. Its accumulated normal impulse is never negative, and its
 accumulated friction impulse never longer than μ times that. */
std::vector<ContactImpulse> ApplyImpulses(std::span<Body> bodies,
                                          std::span<const ContactPair> pairs,
                                          int iterations, const Errata& errata);

/** Position correction: moves the bodies of each pair apart by the fraction `share` of
 the depth beyond `tolerance` [m], in proportion to inverse mass. The corrected recipe
 also turns them: each contact pushes at its own position. */
void Project(std::span<Body> bodies, std::span<const ContactPair> pairs, double share,
             double tolerance, const Errata& errata);

}  // namespace cookbook::printed
