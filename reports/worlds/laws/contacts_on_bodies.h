#pragma once

#include "reports/worlds/law_support/law.h"

namespace touchstone {

/** Every contact that an engine reports is on both bodies, with the gap that it states.

 A contact states a point p, a normal n from A to B, and a separation s. On the line
 p + t n let A end at t = a and B begin at t = b. Then s = b − a, and p is between the two
 surfaces: b ≤ 0 ≤ a if the bodies overlap there, a ≤ 0 ≤ b if they are apart. The measure
 is the least ε by which surfaces must move for that to hold: with the surface of the
 faster body anywhere within ε of its place, that of the other within its share of ε, by
 its speed, and that of a static body within a rounding, a and b are known up to
 intervals, and s and p have to fit those. So a line along an edge, which meets a box or
 passes it, is no error. A box ends where its face towards n does: a line through a corner
 meets another face farther on, which is no contact. [m]

 The normal n is judged where only one is right. Let R be the smaller radius of the two.
 - Half-space: its normal n' does not turn. |n − n'| R has a tolerance of rounding alone.
 - Sphere with a sphere or a box: the normal lies along the vector w from the nearest
 point of the other shape to the centre, unless the centre is inside. Moving both bodies
 by δ changes w by at most δ, so the measure contains the distance of w from the ray along
 n. It also contains R ||n| − 1|.

 An engine collides its bodies at the start of a step, at an impact within it, or at its
 end. The measure is that at the start; or, if that is more than rounding, the least of
 those at the start, at the end, and where the surfaces have the separation s along the
 line if the bodies move on at the velocities of the start, or back at those of the end.
 The true moment may lie between impacts and have none of these poses, but from the start
 no surface moves by more than V h. So the tolerance is 1.5 × V h, with the speed V of the
 faster of the two surfaces, at most what the truth allows; 64 roundings of the positions;
 and the error that the engine documents for the pair. It is 1.5 × a h² and rounding where
 bodies rest under the load a, since an engine may add the load before it collides. A body
 with several contacts in the step may be struck and stopped again before its end: V is
 then up to twice that of the fastest body that touches it in the step, directly or
 through others, at most its own and what the impulses of the step give. Twice is what a
 light body gains from a heavy one. Springs and joints reach farther, so bodies that they
 hold are granted the fastest of all. No other body counts. Only contacts of the steps
 that start at a sample are judged, since only those poses are known.

 The law does not ask whether all contacts are there, nor whether the n of two boxes is
 the direction of least depth: engines choose among several.

 Judges only engines that report contact impulses. About: spheres and boxes. Contacts with
 other shapes than spheres, boxes and half-spaces are left out. Numbers: none. */
extern const Law kContactsOnBodies;

}  // namespace touchstone
