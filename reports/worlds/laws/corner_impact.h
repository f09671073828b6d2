#pragma once

#include "reports/worlds/law_support/law.h"

namespace touchstone {

/** A box that flies without spin hits a static plane with a corner or an edge. [m/s],
 [rad/s], [m]

 Corner, without friction: J = −(1 + e) u_n/(1/m + (r × n)·I⁻¹ (r × n)) along n. Edge,
 moving across it, with friction: the motion stays in a plane, where K_nt couples normal
 and tangent. There rules differ (truth/impact.h): Newton's with Coulomb's law on the slip
 that is left is what `restitution` and `friction` of a world say; Poisson's, with
 friction acting all through the impact, is recognised. A corner with friction has no
 closed form.

 Held until another corner comes down. Velocity, position: the deviations of an impact a
 step early or late and of a contact point inside the box, × 1.5, as of
 laws/sphere_meeting.h. Spin: |ω − I⁻¹ L*|, with the angular momentum L* that the impact
 leaves and nothing changes after it; schemes of first order lose h ∫ of what
 laws/scheme_drift.h says. 1e-5 of the velocity for the solver, 64 roundings a step.

 About: one box, whose other corners are more than three steps of way higher. Numbers:
 expected_speed, expected_spin (sizes, after the impact), expected_impulse (its size). */
extern const Law kCornerImpact;

}  // namespace touchstone
