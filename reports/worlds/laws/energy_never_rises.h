#pragma once

#include "reports/worlds/law_support/law.h"

namespace touchstone {

/** Without pushes, energy is at no time above what it was at any time before. [J]

 Contact, friction and damping only take energy. The tolerance is that of conserves_energy
 (laws/energy_bound.h): what semi-implicit Euler moves to and fro, above the least energy
 so far. Newton's restitution with Coulomb friction may gain energy where the impact is
 eccentric (up to 18 % at e = 1, μ = ½; none was found for e <= 0.8 where friction opposes
 the slip after the impact, 5 % at e = ½ where it opposes the slip before it): worlds
 where bodies other than spheres meet with e >= ½ and μ > 0 are refused.

 About: bodies, particles and cloths. */
extern const Law kEnergyNeverRises;

}  // namespace touchstone
