#pragma once

#include "reports/worlds/law_support/law.h"

namespace touchstone {

/** Two free spheres with spins hit each other at any angle. [m/s], [rad/s], [m], [-]

 J_n = (1 + e) |u_n|/(Σ 1/m). J_t ends the slip u_t, −u_t/(Σ 1/m + r²/I), if that is at
 most μ J_n; else it has that magnitude (hard spheres: Walton & Braun, J. Rheol. 30 (1986)
 949, with β₀ = 0; for central impacts Newton's, Poisson's and Stronge's restitution
 agree). The tolerance is that of law_support/sphere_meeting.h. Other friction cones are
 recognised.

 About: the two spheres. Numbers: expected_first_speed, expected_second_speed,
 expected_first_spin, expected_second_spin (magnitudes, after the impact),
 expected_energy_ratio (kinetic energy after to before). */
extern const Law kSphereImpact;

}  // namespace touchstone
