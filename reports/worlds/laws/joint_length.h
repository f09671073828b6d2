#pragma once

#include "reports/worlds/law_support/law.h"

namespace touchstone {

/** A rod keeps its length: | |p_AB| − L |. [m]

 A step along the tangent leaves a rod longer by ½ v² h²/L, v being the velocity of its
 ends across it: an engine that corrects only velocities is off by ½ h ∫ v²/L dt, × 1.5.
 1e-5 of what the rod's ends move for the solver, what the world starts with, and 64
 roundings a step. An engine whose joints give is wrong.

 About: bodies and particles; the rods at them. Numbers: none. */
extern const Law kJointLength;

}  // namespace touchstone
