#pragma once

#include "reports/worlds/law_support/law.h"

namespace touchstone {

/** A sphere that slips on a level plane is braked and spun by friction until it rolls.
 [m], [m/s], [rad/s]

 With inertia k m r², the slip s = v + ω × (−r n) decreases along its own direction at μ g
 (1 + 1/k), to zero at t_r = |s₀|/(μ g (1 + 1/k)); then it rolls. At all times v = v₀ + (s
 − s₀)/(1 + 1/k), since the angular momentum about the contact is conserved: the velocity
 of rolling does not depend on μ.

 The velocity is exact to the solver's residual, as on a slope (laws/incline.h); in the
 step in which slip ends, to μ g h. Position: ½ h (v₀ − v) and the settling distance, ×
 1.5. 64 roundings per step are added. Solvers with two friction directions end the slip
 along another path with the same rolling velocity; such motions are recognised.

 About: spheres. Numbers: expected_rolling_speed, expected_rolling_time (t_r). */
extern const Law kSlipToRoll;

}  // namespace touchstone
