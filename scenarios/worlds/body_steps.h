#pragma once

#include "scenarios/worlds/world.h"

namespace touchstone {

/** Returns the approximate cost of one simulation: the product of steps and the number of
 moving bodies, particles and cloth nodes. [body-steps] */
double BodySteps(const World& world);

}  // namespace touchstone
