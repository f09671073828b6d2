#pragma once

#include "reports/worlds/law_support/law.h"

namespace touchstone {

/** A damped particle that nothing touches flies along v̇ = g − c v, c its damping
 (truth/damped_flight.h). [m], [m/s]

 Schemes of first order differ in what they do first: damp or pull, move or turn; and in
 damping by exp(−c h) or 1 − c h. All eight are stepped beside the truth; the tolerance is
 1.5 times the largest error so far, and 64 roundings a step.

 About: particles that no spring or joint holds. Numbers: expected_terminal_speed |g|/c,
 of the first. */
extern const Law kParticleFlight;

}  // namespace touchstone
