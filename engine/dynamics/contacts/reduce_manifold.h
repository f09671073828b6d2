#pragma once

#include <span>

#include "engine/collision/manifold.h"

namespace cookbook {

/** Number of contact points that support a face about as well as all of its corners. */
inline constexpr int kContactsPerFace = 4;

/** Manifold reduction: keeps four contact points of a face that span a large area. The
 first is the farthest from their mean, the second the farthest from the first. The others
 are the farthest from the line through these two, one on each side. Features of `before`
 are preferred a little, so that a face at rest keeps its contact points.
 @pre All contact points are about in one plane perpendicular to the normal. */
void ReduceManifold(std::span<const ContactPoint> before, Manifold& manifold);

}  // namespace cookbook
