#pragma once

#include "reports/worlds/law_support/law.h"

namespace touchstone {

/** Without pushes, the energy of a system never rises above any earlier value. [J]

 Contacts, friction and damping only take energy. The tolerance is that of
 conserves_energy (law_support/energy_bound.h), above the least energy so far:
 semi-implicit Euler lets the energy oscillate by that. Newton's restitution with Coulomb
 friction may gain energy in an eccentric impact, so pairs with enough restitution are
 granted the most that it can gain (law_support/impact_gain.h), and no others.

 About: bodies, particles and cloths. */
extern const Law kEnergyNeverRises;

}  // namespace touchstone
