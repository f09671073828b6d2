#pragma once

#include <vector>

#include "scenarios/validate.h"
#include "scenarios/worlds/world.h"

namespace touchstone {

/** The range of a mass [kg], a size [m] and a step [s] of a world. Velocities,
 accelerations, coordinates, stiffnesses and the like are at most as large as the upper
 bound, in SI units, and may be 0. Engines invert and multiply them: the product of any
 four, for example m r² ω², is then a normal float. An engine must not be blamed for a
 world that its numbers cannot hold. */
inline constexpr double kLeastMagnitude = 1e-9;
inline constexpr double kMostMagnitude = 1e9;

/** The range of a moment of inertia: that of a mass times a length squared. [kg m²] */
inline constexpr double kLeastInertia = 1e-27;
inline constexpr double kMostInertia = 1e27;

/** No coordinate [m] and no speed [m/s] may exceed this: a motion beyond it counts as
 diverged. A world must not ask for one. */
inline constexpr double kMostReached = 1e12;

/** The largest cost of a world. The slowest engines then need about a minute, which is
 their time limit. [body-steps] */
inline constexpr double kMostBodySteps = 6e6;

/** Returns the faults of the magnitudes in `world`: a mass, size, speed or the like that
 is out of range, free fall beyond kMostReached, and a cost above kMostBodySteps. Numbers
 that are not finite or have the wrong sign are not repeated here. `where` is the path in
 a file, e.g. "bodies.ball.mass". */
std::vector<Fault> FaultsOfMagnitudes(const World& world);

}  // namespace touchstone
