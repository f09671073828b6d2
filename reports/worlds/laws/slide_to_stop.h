#pragma once

#include "reports/worlds/law_support/law.h"

namespace touchstone {

/** A box that slides on a level plane stops after v/(μ g), at v²/(2 μ g) along its
 heading. [m],
 [-]

 Chrono "sliding_gravity" (Xiang et al. 2009); heading sweep of Jolt "TestFriction".
 Semi-implicit Euler is short by ½ μ g h t, at the end ½ v h. × 1.5, with what the body
 settles by (laws/on_plane.h), the residual of iterative solvers (1e-5 of the velocity),
 and 64 roundings a step. Friction: μ = (v₀ − v)/(g t) at the sample nearest half of the
 way, known to the tolerance of v over g t.

 Solvers with two friction directions stop elsewhere: on the box cone at
 (v_x², v_y²)/(2 μ g), on the diamond at ((v_x² + v_y²)/2, v_x v_y)/(μ g) for v_x >= v_y;
 they are recognised by that, in the frames that follow from the normal.

 About: boxes that lie flat and are low enough not to tip, μ times the height of the
 centre below the nearer edge. Numbers: expected_distance, expected_time. */
extern const Law kSlideToStop;

}  // namespace touchstone
