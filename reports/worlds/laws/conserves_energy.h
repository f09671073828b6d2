#pragma once

#include "reports/worlds/law_support/law.h"

namespace touchstone {

/** The sum of kinetic energy and the potential energies of gravity, constant forces and
 springs is constant. [J]

 Any two samples are compared. The tolerance is the error law of semi-implicit Euler
 between them, at speeds that the truth allows (law_support/energy_bound.h). A motion that
 gains m g h V at each bounce, to within that tolerance, is recognised: its engine
 reflects the velocity after gravity has acted on it. That is legal, and the error
 vanishes with the step.

 About: bodies, particles and cloths without damping, whose contacts have no friction and
 restitution 1; the author vouches for the contacts. Numbers: expected_energy at the
 start, with gravity's potential zero at the world's origin. */
extern const Law kConservesEnergy;

}  // namespace touchstone
