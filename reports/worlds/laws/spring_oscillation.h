#pragma once

#include "reports/worlds/law_support/law.h"

namespace touchstone {

/** A mass on one spring to something fixed oscillates along it: ẍ = −ω² x − c ẋ, ω² =
 k/m, c = b/m plus the damping of a particle, x measured from L + a/ω², where gravity and
 force a along the spring leave it at rest (truth/oscillator.h). [m], [m/s]

 Semi-implicit Euler and its adjoint keep phase to ω² h²/24 and are off by up to ½ ω h of
 the amplitude; both, and with the damping implicit, are stepped beside the truth: 1.5
 times the largest error so far, and 64 roundings a step. Implicit and explicit Euler,
 which lose and gain energy, are recognised by their own discrete forms.

 About: one body, held at its centre, or one particle, that only swings along the spring
 and never reaches the spring's other end. Numbers: expected_period,
 expected_angular_frequency (damped), expected_damping_ratio, expected_sag a/ω². */
extern const Law kSpringOscillation;

}  // namespace touchstone
