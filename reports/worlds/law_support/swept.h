#pragma once

#include "oracles/trajectory.h"
#include "scenarios/worlds/world.h"

namespace touchstone {

/** How far two bodies passed into each other on the straight way between two states. */
struct SweptOverlap {
  /** A certified lower bound of the penetration depth of the volume that A sweeps, seen
   from B: the least distance by which A would have had to leave the straight way to pass
   B. 0 if the swept volume is apart from B. [m] */
  double depth = 0;
  /** The most by which the turning of the bodies may bend the way of a point of A, seen
   from B. [m] */
  double bend = 0;
};

/** Returns how A sweeps over B between two states. The swept volume is exact for spheres,
 and for boxes and hulls that do not turn. It is the convex hull of the shape at both ends
 of the way, which a body that turns leaves by at most `bend`. A body that turns by more
 than a radian, and a sphere, are swept as a ball, which lies in the body; other curved
 shapes as a hull of points on their surface.

 @pre Neither is a half-space. */
SweptOverlap SweptOverlapOf(const World& world, const WorldState& from,
                            const WorldState& to, int A, int B);

}  // namespace touchstone
