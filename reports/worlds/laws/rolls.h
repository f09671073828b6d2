#pragma once

#include "reports/worlds/law_support/law.h"

namespace touchstone {

/** A sphere, or a capsule or cylinder on its side, that rolls on a static plane keeps
 rolling. Its acceleration along the plane
 is a = a_t/(1 + k), where a_t is the part of gravity and force along the plane and k m r²
 the inertia. So v = v₀ + a t and ω = n × v/r, and the spin about the normal is constant.
 [m/s], [rad/s], [m]

 Friction supplies k/(1 + k) |a_t|, at most μ a_n. The tolerances are those of a slope
 (laws/incline.h).

 About: spheres, and capsules and cylinders that move across their axis, that start
 rolling, to 1e-9 of their speed. Numbers:
 expected_acceleration. */
extern const Law kRolls;

}  // namespace touchstone
