#pragma once

#include "reports/worlds/law_support/law.h"

namespace touchstone {

/** A damped system comes to rest at a minimum of its energy. [m], [J]

 An independent minimiser (truth/net.h) finds the minimum of −Σ m g·x + Σ ½ k (|p_AB| −
 L)² nearest to the last sample. The measures are the distance of the points from it and
 the energy, kinetic and potential, above it. A stationary shape carries its weight, so
 that needs no claim of its own.

 That minimum is the truth if the one downhill from the start is not lower. Otherwise the
 truth is the minimum that an independent integration comes to (truth/net_motion.h). If
 that is uncertain, nothing is judged.

 Tolerance: the amplitude at the start (of position, speed and energy) times e^{−γ t}, and
 the energy at the start times e^{−2 γ t}, both × 1.5; γ is the slowest decay of small
 motion by the damping of particles and nodes. 64 roundings per step.

 About: damped cloths, and damped particles, with the springs among them and to static
 things; no rods. Numbers: none. */
extern const Law kMinimumEnergy;

}  // namespace touchstone
