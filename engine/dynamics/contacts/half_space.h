#pragma once

#include "engine/collision/manifold.h"
#include "engine/dynamics/body/body.h"

namespace cookbook {

/** As Collide() of a box, with an unbounded floor for A: the normal is the floor's +z.
 Separation to within 4 u (|p_AB| + r). */
void Collide(const HalfSpace& A, const Pose& X_WA, const Sphere& B, const Pose& X_WB,
             Manifold& manifold);

/** The vertices of B below the floor, or less than `margin` [m] above it, each a contact
 of its own separation. A vertex at zero to within kOverlapRounding times the size of the
 pair counts as below. */
void Collide(const HalfSpace& A, const Pose& X_WA, const Box& B, const Pose& X_WB,
             double margin, Manifold& manifold);

}  // namespace cookbook
