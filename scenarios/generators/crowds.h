#pragma once

#include <cstdint>

#include "scenarios/worlds/world.h"

namespace touchstone {

/** Returns `count` unit boxes in layers above a wide static floor whose top is y = 0.
 Each box is rotated and displaced a little, so that no two fall alike; they form a pile
 after a second or two. Boxes have half extents of 0.5 m, 1 kg, friction 0.6 and no
 restitution; g = 9.82 m/s², dt = 1/240 s. Every coordinate follows from the seed and is
 the same on every machine. @pre count > 0 */
World BoxPile(int count, std::uint64_t seed);

/** Like BoxPile(), with spheres of radius 0.5 m. */
World SpherePile(int count, std::uint64_t seed);

/** Returns a stack of `height` unit boxes, at rest on the floor. @pre height > 0 */
World BoxStack(int height);

}  // namespace touchstone
