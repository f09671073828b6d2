#pragma once

#include <span>

#include "engine/collision/manifold.h"

namespace cookbook {

/** Contacts that hold a face about as well as all that its outline has. */
inline constexpr int kContactsPerFace = 4;

/** Leaves of the contacts of a face those that hold it widest: one far from their middle,
 the one farthest from that, and on either side of the line between the two the farthest
 from it. Contacts of the features of `before` are taken for a little wider than they are,
 so that a face at rest keeps them.
 @pre All are about in one plane, across the normal. */
void ReduceManifold(std::span<const ContactPoint> before, Manifold& manifold);

}  // namespace cookbook
