#pragma once

#include "reports/worlds/law_support/law.h"

namespace touchstone {

/** A sphere that rolls on a static plane goes on rolling: v = v₀ + a t, a = a_t/(1 + k)
 along the plane with a_t of gravity and force, inertia k m r²; ω = n × v/r, and what it
 spins about the normal stays. [m/s], [rad/s], [m]

 Friction k/(1 + k) |a_t| holds it, less than μ a_n. Tolerances are those of a slope
 (laws/incline.h).

 About: spheres that start rolling, to 1e-9 of their speed. Numbers:
 expected_acceleration. */
extern const Law kRolls;

}  // namespace touchstone
