#pragma once

#include "reports/worlds/law_support/law.h"

namespace touchstone {

/** Every contact pushes, and its friction stays in Coulomb's cone: J_n >= 0, |J_t| <= μ
 J_n, μ = √(μ_A μ_B). [N s]

 The value is the larger of |J_t| − μ J_n and −J_n. The tolerance is 1e-5 of the contact
 impulse and of the pair's gravity impulse in a step, for the solver, and 64 roundings. An
 engine whose friction has two directions may leave the circle and stay within the box of
 its axes, each |J_i| at most μ J_n; that is recognised. A diamond lies within the circle.

 Judges only engines that report contact impulses. About: bodies and all their contacts.
 Numbers: none. */
extern const Law kCoulombCone;

}  // namespace touchstone
