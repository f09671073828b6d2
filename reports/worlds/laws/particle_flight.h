#pragma once

#include "reports/worlds/law_support/law.h"

namespace touchstone {

/** A damped particle in free flight moves by v̇ = g − c v, where c is its damping
 (truth/damped_flight.h). [m], [m/s]

 First-order schemes differ in the order of damping and gravity, in the order of position
 and velocity, and in damping by exp(−c h) or 1 − c h. All eight are stepped next to the
 truth; the tolerance is 1.5 times the largest error so far, and 64 roundings per step.

 About: particles that no spring or joint holds. Numbers: expected_terminal_speed |g|/c,
 of the first. */
extern const Law kParticleFlight;

}  // namespace touchstone
