#pragma once

#include <cstdint>

#include "scenarios/worlds/world.h"

namespace touchstone {

/** Returns `count` unit boxes in layers above a wide static floor whose top is y = 0,
 each a little turned and moved so that none falls like another: a pile after a second or
 two. Boxes of half 0.5 m and 1 kg, friction 0.6, no restitution, g = 9.82, dt = 1/240 s.
 Every coordinate follows from the seed, the same on every machine. @pre count > 0 */
World BoxPile(int count, std::uint64_t seed);

/** As BoxPile(), of spheres of radius 0.5 m. */
World SpherePile(int count, std::uint64_t seed);

/** Returns `height` unit boxes one upon the other, at rest on the floor. @pre height > 0
 */
World BoxStack(int height);

}  // namespace touchstone
