#pragma once

#include "reports/worlds/law_support/law.h"

namespace touchstone {

/** A sphere hits a static plane at an angle, with spin. [m/s], [rad/s], [m], [-]

 v_n' = −e v_n. The slip u_t = v_t + (ω × (−r n))_t ends if μ >= (2/7) |u_t|/((1 + e)
 |v_n|) for a solid sphere: v_t' = v_t − (2/7) u_t. Else v_t' = v_t − μ (1 + e) |v_n| û,
 Δω = (5/2) μ (1 + e) |v_n|/r (Walton & Braun, J. Rheol. 30 (1986) 949; Foerster et al.,
 Phys. Fluids 6 (1994) 1108). The tolerance is that of law_support/sphere_meeting.h. Other
 friction cones are recognised.

 Under gravity it is judged until the sphere comes down again.

 About: one sphere, in free flight at the start. Numbers: expected_normal_speed,
 expected_tangential_speed, expected_spin (magnitudes, after the impact),
 expected_energy_ratio (kinetic energy after to before). */
extern const Law kObliqueImpact;

}  // namespace touchstone
