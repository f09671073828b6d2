#pragma once

#include <vector>

#include "oracles/trajectory.h"
#include "scenarios/worlds/world.h"

namespace touchstone {

/** An overlap of two bodies on the way between two states: A, or a ball in it, that moves
 straight as seen from B. A motion without an overlap leaves the straight way by as much
 as `depth`, so it is proved to pass through if it can leave it by less. */
struct SweptOverlap {
  /** A certified lower bound of the distance by which a body would have had to leave the
   straight way to pass the other. 0 if it is apart from it all the way. [m] */
  double depth = 0;
  /** Upper bound on the distance by which points leave the way because the bodies turn,
   at the spins that lead from one state to the other. [m] */
  double bend = 0;
  double lever_A = 0;  ///< Distance at which a turn of A moves its points. [m]
  double lever_B = 0;  ///< Distance at which a turn of B moves A's points. [m]
};

/** Turns of two bodies between two states, however many times round. [rad] */
struct Turns {
  double A = 0;
  double B = 0;
  /** Up to which turn a body is known to turn evenly, the shorter way round; less than
   π. One that turns further is replaced by a ball in it. */
  double followed = 1;
};

/** Returns how A sweeps over B between two states in which they are apart, in up to three
 ways. Nothing if A is a box or a hull and the hull of A at both ends, as seen from B, is
 apart from B.
 - A sphere, or a ball about the origin inside another shape, sweeps a capsule. If the
   ball is apart from B before and behind the way, the way is taken longer at both ends,
   and the depth is that of a way around B.
 - The same with a ball in B, if B turns: two balls do not know that they turn.
 - A box or a hull moves in pieces of the way, in each without turning, and half the turn
   of a piece is part of `bend`. Another shape is replaced by the hull of points on its
   surface. Left out if a body turns by more than Turns::followed.

 Take the way of a piece, with the turn of A at its middle, and let β bound the distance
 of a point's true place from its place there. At every instant a plane separates the
 bodies, so the piece moved by β along its normal is apart from B at that instant. The
 normal of the nearest points is continuous, which makes a curve that is nowhere farther
 from the way than β and avoids the Minkowski difference M of B and A. If every shift of
 the way by less than its depth meets M, then a surface in M closes the tube of that
 radius around it. The curve crosses the tube, hence β is at least the depth.

 @pre Neither is a half-space. */
std::vector<SweptOverlap> SweptOverlapsOf(const World& world, const WorldState& from,
                                          const WorldState& to, int A, int B,
                                          const Turns& turns);

}  // namespace touchstone
