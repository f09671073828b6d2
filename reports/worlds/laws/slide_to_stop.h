#pragma once

#include "reports/worlds/law_support/law.h"

namespace touchstone {

/** A box that slides on a level plane stops after v/(μ g), at the distance v²/(2 μ g)
 along its heading. [m], [-]

 Chrono "sliding_gravity" (Xiang et al. 2009); heading sweep of Jolt "TestFriction".
 Semi-implicit Euler falls short by ½ μ g h t, at the end by ½ v h. The tolerance is 1.5
 times that and the settling distance (law_support/on_plane.h), the residual of iterative
 solvers (1e-5 of the velocity), and 64 roundings per step. Friction: μ = (v₀ − v)/(g t)
 at samples between a quarter and three quarters of the time to stop. Its relative
 tolerance is 1.5 h/t, for the step in which friction begins.

 Solvers with two friction directions stop elsewhere: with the box cone at (v_x², v_y²)/(2
 μ g), with the diamond at ((v_x² + v_y²)/2, v_x v_y)/(μ g) for v_x >= v_y. Such motions
 are recognised, in the frames that follow from the normal.

 About: boxes that lie flat and are low enough not to tip: μ times the height of the
 centre is less than the distance to the nearer edge. Numbers: expected_distance,
 expected_time. */
extern const Law kSlideToStop;

}  // namespace touchstone
