#pragma once

#include "reports/worlds/law_support/law.h"

namespace touchstone {

/** A body without torque turns as Euler's equations say, I ω̇ = (I ω) × ω, by Jacobi's
 elliptic functions (truth/torque_free_rotation.h). [rad], [rad/s]

 What a scheme of first order is off by is computed, not estimated, since a spin near the
 middle axis magnifies any error: the body is stepped by each of the schemes that engines
 use (truth/gyroscopic_schemes.h), and the largest error of any of them so far, × 1.5, is
 allowed. Rounding is magnified in the same way: the exact rotation with its spin changed
 by 64 roundings a step along each axis is how far rounding may lead.

 About: bodies that no spring, joint, contact or push turns; any inertia. Measures:
 orientation, spin. Numbers: expected_rotational_energy, expected_angular_momentum,
 expected_period (of ω in the body). */
extern const Law kTorqueFree;

}  // namespace touchstone
