#pragma once

#include "reports/worlds/law_support/law.h"

namespace touchstone {

/** The angular momentum Σ (x − c) × m v + R I Rᵀ ω of things that only act on each other,
 about their common centre of mass c, never changes: uniform gravity has no torque about
 c. [N m s]

 Impulses along the line of their points, and at one common point, keep it whatever the
 step. What a scheme of first order may lose, × 1.5, along the motion itself: the
 gyroscopic term's h ∫ max(|ω̇ × L − ½ ω × (ω × L)|, ½ |ω × (ω × L)|) dt; a rod's
 ½ h ∫ m v³/L dt; and V h a contact impulse, where an engine applies it to each body at
 that body's own surface, which may lie V h inside the other.

 About: bodies, particles and cloths that nothing else holds. Numbers: x, y, z, a
 direction along which it is kept where the rest is not; expected_angular_momentum:
 |L(0)|. */
extern const Law kConservesAngularMomentum;

}  // namespace touchstone
