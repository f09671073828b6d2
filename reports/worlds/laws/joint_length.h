#pragma once

#include "reports/worlds/law_support/law.h"

namespace touchstone {

/** A rod keeps its length: | |p_AB| − L | = 0. [m]

 A step along the tangent lengthens a rod by ½ v² h²/L, where v is the relative velocity
 of its ends across it. An anchor at the distance r from the centre of a body that turns
 at ω adds ½ ω² r h². So an engine that corrects only velocities is off by ½ h ∫ (v²/L +
 Σ ω² r) dt, × 1.5. Added are 1e-5 of the relative motion of the ends for the solver, the
 error of the world at the start, and 64 roundings per step. No speed is larger than the
 truth allows (law_support/allowed_motion.h). An engine whose joints are elastic fails.

 About: bodies and particles, with all rods attached to them. Numbers: none. */
extern const Law kJointLength;

}  // namespace touchstone
