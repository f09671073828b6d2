#pragma once

#include "engine/collision/manifold.h"
#include "engine/collision/shape.h"

namespace cookbook {

/** Finds the contact manifold of two spheres. Concentric spheres: n = +y. Error of the
 separation: at most 8 u (|p_AB| + r_A + r_B), u = 2⁻⁵³. */
void Collide(const Sphere& A, const Pose& X_WA, const Sphere& B, const Pose& X_WB,
             Manifold& manifold);

/** Finds the contact manifold of a box and a sphere. If the sphere's centre is inside the
 box, the depth is the radius plus the distance to the nearest face. Error of the
 separation: at most 16 u (|p_AB| + |half extents| + r). Every processor returns the same
 bits. */
void Collide(const Box& A, const Pose& X_WA, const Sphere& B, const Pose& X_WB,
             Manifold& manifold);

/** Finds the contact manifold of a sphere and a box: the above with swapped roles. */
void Collide(const Sphere& A, const Pose& X_WA, const Box& B, const Pose& X_WB,
             Manifold& manifold);

/** Finds the contact manifold of two boxes along the axis of least overlap out of 15:

 - face on face: the incident face clipped to the reference face, up to 8 contacts;
 - edge on face: 2 contacts; vertex on face: 1; edge on edge: 1.

 Points of the incident face above the reference face are dropped. Points below it are
 kept, each with its own, lesser depth. A box that lands slightly tilted thus keeps the
 corners that a solver needs in the next step, while an edge or a vertex that lies well
 below its neighbours is the only contact. "Above" means by more than kFlush S, so that a
 box resting at exactly zero separation keeps all its corners.

 If several axes are equally good to within rounding, a face is preferred to an edge pair
 and A's face to B's, so that the manifold of a resting box does not flicker.

 Error: the separation is the gap along n_AB_W to within kOverlapRounding S, and no
 direction separates the boxes with a translation shorter by more than kDepthRounding S
 (engine/collision/rounding.h). Boxes further apart than that are never reported as
 touching, and boxes deeper than that are never missed. */
void Collide(const Box& A, const Pose& X_WA, const Box& B, const Pose& X_WB,
             Manifold& manifold);

/** Returns the contact manifold that the overload above finds. */
template <class ShapeA, class ShapeB>
Manifold Collide(const ShapeA& A, const Pose& X_WA, const ShapeB& B, const Pose& X_WB) {
  Manifold manifold;
  Collide(A, X_WA, B, X_WB, manifold);
  return manifold;
}

}  // namespace cookbook
