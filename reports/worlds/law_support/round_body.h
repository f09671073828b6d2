#pragma once

#include "scenarios/worlds/world.h"

namespace touchstone {

/** Returns the radius of a sphere, a capsule or a cylinder. [m] */
double RadiusOf(const RigidBody& round);

/** Returns I/(m r²) of a round body about the axis on which it rolls, its inertia
 relative to that of a thin ring: 2/5 of a solid sphere, 1/2 of a solid cylinder. [-]
 @pre IsEvenSphere() or IsEvenRoller() */
double InertiaRatioOf(const RigidBody& round);

/** Returns whether `body` is a sphere with three equal moments of inertia. */
bool IsEvenSphere(const RigidBody& body);

/** Returns whether `body` is a capsule or a cylinder with equal moments of inertia across
 its axis, which is its z axis. */
bool IsEvenRoller(const RigidBody& body);

}  // namespace touchstone
