#pragma once

#include "reports/worlds/law_support/law.h"

namespace touchstone {

/** A body without torque rotates by Euler's equations, I ω̇ = (I ω) × ω, solved by
 Jacobi's elliptic functions (truth/torque_free_rotation.h). [rad], [rad/s]

 The error of a first-order scheme is computed, not estimated, since a spin near the
 middle axis amplifies any error. The body is stepped by each of the schemes that engines
 use (truth/gyroscopic_schemes.h), and the tolerance is the largest error of any of them
 so far, × 1.5. Rounding is amplified in the same way. Its tolerance is the change of the
 exact rotation if the initial spin changes by 64 roundings per step along each axis.

 About: bodies that no spring, joint, contact or push rotates; any inertia. Measures:
 orientation, spin. Numbers: expected_rotational_energy, expected_angular_momentum,
 expected_period (of ω in the body frame). */
extern const Law kTorqueFree;

}  // namespace touchstone
