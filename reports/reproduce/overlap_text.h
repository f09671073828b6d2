#pragma once

#include <string>

#include "scenarios/worlds/world.h"

namespace touchstone {

/** Returns the definition, at namespace scope, of

     double Overlap(const WorldState& state);

 the penetration depth of bodies A and B of `world` in a program with the table of
 BodiesText(); negative where they are apart by a sphere or a plane. Throws
 CannotReproduce unless both are spheres, boxes and half-spaces. */
std::string OverlapText(const World& world, int A, int B);

}  // namespace touchstone
