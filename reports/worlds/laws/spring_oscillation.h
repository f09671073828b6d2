#pragma once

#include "reports/worlds/law_support/law.h"

namespace touchstone {

/** A mass on one spring to a fixed point oscillates along it: ẍ = −ω² x − c ẋ with ω² =
 k/m and c = b/m plus the damping of a particle. x is measured from the rest length L +
 a/ω² under the acceleration a of gravity and force along the spring (truth/oscillator.h).
 [m], [m/s]

 Semi-implicit Euler and its adjoint keep the phase to ω² h²/24 and are off by up to ½ ω h
 of the amplitude. Both, and a variant with implicit damping, are stepped next to the
 truth. The tolerance is 1.5 times the largest error so far, and 64 roundings per step.
 Implicit and explicit Euler, which lose and gain energy, are recognised by their own
 discrete forms.

 About: one body, held at its centre, or one particle, that only moves along the spring
 and never reaches the spring's other end. Numbers: expected_period,
 expected_angular_frequency (damped), expected_damping_ratio, expected_sag a/ω². */
extern const Law kSpringOscillation;

}  // namespace touchstone
