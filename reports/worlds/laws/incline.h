#pragma once

#include "reports/worlds/law_support/law.h"

namespace touchstone {

/** A body that starts at rest on a slope of angle θ stays, slides or rolls. [m/s], [m],
 [rad/s]

 Box (Gazebo "FrictionDemo"): stays if μ >= tan θ, else a = g (sin θ − μ cos θ). Sphere of
 inertia k m r² (Drake inclined_plane_test): rolls with a = g sin θ/(1 + k) if μ >= tan θ
 k/(1 + k), else slips with a = g (sin θ − μ cos θ), α = μ g cos θ/(k r).

 The velocity is exact to the solver's residual: the friction impulse is μ times the
 normal impulse, and that cancels gravity's, however late the contact is detected. Two
 errors remain, × 1.5. The body's current velocity v_n along the normal contributes (1 +
 μ) |v_n|. A contact at depth δ contributes δ/r of the velocity, where δ is the settling
 distance and r the radius, or the bounding radius of a box. Position: ½ a h t and the
 settling distance, × 1.5. 64 roundings per step.

 Solvers with two friction directions hold more (box cone) or less (diamond cone) between
 their axes; bodies that move accordingly are recognised.

 About: boxes that lie flat, spheres. Numbers: expected_acceleration. */
extern const Law kIncline;

}  // namespace touchstone
