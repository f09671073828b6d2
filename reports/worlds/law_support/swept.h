#pragma once

#include "oracles/trajectory.h"
#include "scenarios/worlds/world.h"

namespace touchstone {

/** The overlap of two bodies along the chord of their relative path between two states.
 */
struct SweptOverlap {
  /** A certified lower bound of the penetration depth of the volume that A sweeps, seen
   from B: the least distance by which A would have had to leave the chord to pass B. 0 if
   the swept volume is apart from B. [m] */
  double depth = 0;
  /** Upper bound on the distance between the path of a point of A, seen from B, and its
   chord that the rotation of the bodies causes. [m] */
  double bend = 0;
};

/** Returns how A sweeps over B between two states. The swept volume is exact for spheres,
 and for boxes and hulls that do not turn. It is the convex hull of the shape at both ends
 of the chord, which a body that turns leaves by at most `bend`. A sphere, and any body
 that turns by more than a radian, is replaced by a ball inside it. Another curved shape
 is replaced by the hull of points on its surface.

 @pre Neither is a half-space. */
SweptOverlap SweptOverlapOf(const World& world, const WorldState& from,
                            const WorldState& to, int A, int B);

}  // namespace touchstone
