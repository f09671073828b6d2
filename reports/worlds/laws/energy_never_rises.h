#pragma once

#include "reports/worlds/law_support/law.h"

namespace touchstone {

/** Without pushes, the energy of a system never rises above any earlier value. [J]

 Contacts, friction and damping only take energy. The tolerance is that of
 conserves_energy (law_support/energy_bound.h), above the least energy so far:
 semi-implicit Euler lets the energy oscillate by that. Newton's restitution with Coulomb
 friction may gain energy in an eccentric impact: up to 18 % at e = 1, μ = ½. None was
 found for e <= 0.8 if friction opposes the slip after the impact, but 5 % at e = ½ if it
 opposes the slip before it. So worlds in which bodies other than spheres may collide with
 e >= ½ and μ > 0 are refused.

 About: bodies, particles and cloths. */
extern const Law kEnergyNeverRises;

}  // namespace touchstone
