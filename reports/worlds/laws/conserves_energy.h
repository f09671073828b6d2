#pragma once

#include "reports/worlds/law_support/law.h"

namespace touchstone {

/** Kinetic energy, gravity's, that of constant forces and of springs stay one sum. [J]

 The tolerance is the error law of semi-implicit Euler along the motion itself
 (laws/energy_bound.h). A motion that gains m g h V at each bounce, to within that
 tolerance, is recognised: its engine reflects the velocity after gravity has acted on it,
 which is legal, and vanishes with the step.

 About: bodies, particles and cloths without damping, that no friction and no restitution
 below 1 slows: the author vouches for that. Numbers: expected_energy, at the start, with
 gravity's counted from the world's origin. */
extern const Law kConservesEnergy;

/** Returns what keeps the energy of the subjects from being a quantity of their own, for
 laws of energy: names, springs to what else moves, pushes; and damping unless `damped`.
 */
std::vector<Fault> FaultsOfEnergy(const World& world, const Claim& claim, bool damped);

}  // namespace touchstone
