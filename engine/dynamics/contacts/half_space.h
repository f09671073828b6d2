#pragma once

#include "engine/collision/manifold.h"
#include "engine/dynamics/body/body.h"

namespace cookbook {

/** Collides a sphere with a half-space A, like Collide() for a box A. The normal is the
 +z axis of A. The error of the separation is at most 4 u (|p_AB| + r). */
void Collide(const HalfSpace& A, const Pose& X_WA, const Sphere& B, const Pose& X_WB,
             Manifold& manifold);

/** Collides a box with a half-space A. Each vertex of the lower face of B that is below
 the surface, or less than `margin` [m] above it, is a contact point. The vertices of the
 upper face look away from A: they are none, also in a box that has sunk whole or is
 thinner than the margin. A vertex on the surface to within kOverlapRounding times the
 size of the pair counts as below. */
void Collide(const HalfSpace& A, const Pose& X_WA, const Box& B, const Pose& X_WB,
             double margin, Manifold& manifold);

}  // namespace cookbook
