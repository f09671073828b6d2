#pragma once

#include "reports/worlds/law_support/law.h"

namespace touchstone {

/** Every contact pushes, and its friction stays in Coulomb's cone: J_n >= 0, |J_t| <= μ
 J_n, μ = √(μ_A μ_B). [N s]

 The value is the larger of |J_t| − μ J_n and −J_n. What a solver may leave is 1e-5 of the
 impulse, and as much of what gravity gives the pair in a step, beside 64 roundings. An
 engine whose friction has two directions may leave the circle and stay within the box
 |J_i|
 <= μ J_n of its axes; that is recognised. A diamond lies within the circle.

 Speaks only of engines that give their impulses. About: bodies; contacts of theirs with
 anything. Numbers: none. */
extern const Law kCoulombCone;

}  // namespace touchstone
