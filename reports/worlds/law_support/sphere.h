#pragma once

#include "scenarios/worlds/world.h"

namespace touchstone {

/** Returns the radius of a body that is a sphere. [m] */
double RadiusOf(const RigidBody& sphere);

/** Returns I/(m r²) of a sphere, its inertia relative to that of a thin ring: 2/5 if it
 is solid. [-] @pre IsEvenSphere() */
double InertiaRatioOf(const RigidBody& sphere);

/** Returns whether `body` is a sphere with three equal moments of inertia. */
bool IsEvenSphere(const RigidBody& body);

}  // namespace touchstone
