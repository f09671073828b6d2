#pragma once

#include "reports/worlds/law_support/law.h"

namespace touchstone {

/** What damping brings to rest rests where its energy is least. [m], [J]

 At the last sample the minimum of −Σ m g·x + Σ ½ k (|p_AB| − L)² nearest to the motion's
 own end is found by an independent minimiser (truth/net.h): how far the points are from
 it, and how much energy, kinetic and potential, is left above it. A stationary shape
 carries its weight, so that needs no claim of its own.

 That minimum counts where none is lower downhill from the start; else the one that an
 independent integration comes to (truth/net_motion.h), and none where that is not sure.

 What may be left: the amplitude, of place, speed and energy, and the energy at the start,
 times e^{−γ t} and e^{−2 γ t}, γ the slowest decay of small motion by the particles' and
 nodes' damping; × 1.5, and 64 roundings a step.

 About: damped cloths, and damped particles, with the springs among them and to what never
 moves; no rods. Numbers: none. */
extern const Law kMinimumEnergy;

}  // namespace touchstone
