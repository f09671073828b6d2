#pragma once

#include "reports/worlds/law_support/law.h"

namespace touchstone {

/** What starts at rest on a slope of angle θ stays, slides or rolls. [m/s], [m], [rad/s]

 Box (Gazebo "FrictionDemo"): stays where μ >= tan θ, else a = g (sin θ − μ cos θ). Sphere
 of inertia k m r² (Drake inclined_plane_test): rolls with a = g sin θ/(1 + k) where μ >=
 tan θ k/(1 + k), else slips with a = g (sin θ − μ cos θ), α = μ g cos θ/(k r).

 The velocity is right to the solver's residual: friction's impulse is μ times the normal
 impulse, and that is what gravity gave, however late the contact is seen, but for the
 velocity v_n that the body has across the slope at the moment: (1 + μ) |v_n|, and as much
 as the contact is inside the sphere, δ/r with δ what the body settles by. Position: ½ a h
 t and what it settles by, × 1.5. Plus 64 roundings a step.

 Solvers with two friction directions hold more (box) or less (diamond) across their axes;
 boxes that move so are recognised.

 About: boxes that lie flat, spheres. Numbers: expected_acceleration. */
extern const Law kIncline;

}  // namespace touchstone
