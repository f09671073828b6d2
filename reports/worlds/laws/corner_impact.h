#pragma once

#include "reports/worlds/law_support/law.h"

namespace touchstone {

/** A box that flies without spin hits a static plane with a corner or an edge. [m/s],
 [rad/s], [m]

 Corner without friction: J = −(1 + e) u_n/(1/m + (r × n)·I⁻¹ (r × n)) along n. Edge that
 moves across its own direction, with friction: the motion stays in a plane, where K_nt
 couples normal and tangent, and the impact rules differ (truth/impact.h). The truth is
 Newton's restitution with Coulomb's law on the remaining slip, since that is what a
 world's `restitution` and `friction` mean. Poisson's rule, with friction acting all
 through the impact, is recognised. A corner with friction has no closed form, unless the
 box moves in one plane.

 Judged until another corner comes down. Tolerance of velocity and position: the
 deviations of an impact up to a step early or late, with its contact point inside the
 box, × 1.5, as in law_support/sphere_meeting.h. Spin: |ω − I⁻¹ L*|, where L* is the
 angular momentum after the impact, which stays constant. First-order schemes lose h ∫ of
 the rates in law_support/scheme_drift.h. 1e-5 of the velocity for the solver, 64
 roundings per step.

 About: one box whose other corners are higher by more than three steps of motion.
 Numbers: expected_speed, expected_spin (magnitudes, after the impact), expected_impulse
 (its magnitude). */
extern const Law kCornerImpact;

}  // namespace touchstone
