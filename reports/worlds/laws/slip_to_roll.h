#pragma once

#include "reports/worlds/law_support/law.h"

namespace touchstone {

/** A sphere that slips on a level plane is turned by friction until it rolls. [m], [m/s],
 [rad/s]

 With inertia k m r², the slip s = v + ω × (−r n) falls along its own direction at
 μ g (1 + 1/k), to zero at t_r = |s₀|/(μ g (1 + 1/k)); then it rolls. All the while
 v = v₀ + (s − s₀)/(1 + 1/k), since the angular momentum about the contact is kept: the
 velocity of rolling does not depend on μ.

 The velocity is right to the solver's residual, as on a slope (laws/incline.h); in the
 step in which slip ends, to μ g h. Position: ½ h (v₀ − v) and what the sphere settles by,
 × 1.5. Plus 64 roundings a step. Solvers with two friction directions end the slip along
 another way, with the same rolling velocity; they are recognised by it.

 About: spheres. Numbers: expected_rolling_speed, expected_rolling_time (t_r). */
extern const Law kSlipToRoll;

}  // namespace touchstone
