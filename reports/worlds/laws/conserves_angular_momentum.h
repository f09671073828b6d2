#pragma once

#include "reports/worlds/law_support/law.h"

namespace touchstone {

/** The angular momentum Σ (x − c) × m v + R I Rᵀ ω of an isolated system, about its
 centre of mass c, never changes: uniform gravity has no torque about c. [N m s]

 Impulses along the line of their points, and impulses at one common point, conserve it
 for any step. The tolerance is what a first-order scheme may lose along the
 motion, at speeds that the truth allows (law_support/allowed_motion.h), × 1.5. The
 gyroscopic term loses h ∫ max(|ω̇ × L − ½ ω × (ω × L)|, ½ |ω × (ω × L)|) dt. A rod loses ½
 h ∫ m v³/L dt. A contact impulse loses V h times its size if an engine applies it to each
 body at that body's own surface, which may lie V h inside the other body. Bodies at rest
 are granted the angular momentum of NoiseOfPositions().

 About: bodies, particles and cloths that nothing else holds. Numbers: x, y, z, a
 direction along which it is conserved if the rest is not; expected_angular_momentum:
 |L(0)|. */
extern const Law kConservesAngularMomentum;

}  // namespace touchstone
