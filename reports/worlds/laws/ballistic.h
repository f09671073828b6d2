#pragma once

#include "reports/worlds/law_support/law.h"

namespace touchstone {

/** A body in free flight moves along x = x₀ + v₀ t + ½ a t², v = v₀ + a t, with a = g +
 F/m. A push J at t_J adds (t − t_J) J/m and J/m. [m], [m/s]

 Semi-implicit Euler is off by exactly +½ a h t in position, explicit Euler by −½ a h t,
 and both are exact in velocity: N steps of v += a h, x += v h sum to v₀ t + a h² N
 (N+1)/2. The tolerance is 1.5 times that, in addition to rounding.

 About: bodies, and particles without damping, that no spring, joint or contact holds.
 Measures: position, velocity. */
extern const Law kBallistic;

}  // namespace touchstone
