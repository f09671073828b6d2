#pragma once

#include "engine/collision/manifold.h"
#include "engine/collision/shape.h"

namespace cookbook {

/** Sets `manifold` to how two spheres touch, or how far apart they are. Concentric
 spheres: n = +y. Error of the separation: at most 8 u (|p_AB| + r_A + r_B), u = 2⁻⁵³. */
void Collide(const Sphere& A, const Pose& X_WA, const Sphere& B, const Pose& X_WB,
             Manifold& manifold);

/** As of two spheres, of a box and a sphere. A centre inside the box: the depth is the
 radius plus the distance to the nearest face. Error of the separation: at most
 16 u (|p_AB| + |half extents| + r). Every processor gives the same bits. */
void Collide(const Box& A, const Pose& X_WA, const Sphere& B, const Pose& X_WB,
             Manifold& manifold);

/** As box against sphere, with the roles exchanged. */
void Collide(const Sphere& A, const Pose& X_WA, const Box& B, const Pose& X_WB,
             Manifold& manifold);

/** Sets `manifold` to how two boxes touch: the axis of least overlap out of 15, and

 - face on face: the incident face clipped to the reference face, up to 8 contacts;
 - edge on face 2, vertex on face 1, edge on edge 1.

 The points of the incident face that lie above the reference face are dropped, those
 below are kept with their own, lesser depth: a box that lands a little tilted keeps the
 corners that a solver will need in the next step, and an edge or a vertex well below its
 neighbours stands alone. "Above" leaves kFlush S for rounding, so that a box resting
 at exactly zero separation keeps all its corners.

 Where several axes are equally good to within rounding, a face is preferred to an edge
 pair and A's face to B's, so that a resting box does not flicker between them.

 Error: the separation is the gap along n_AB_W to within kOverlapRounding S, and no
 direction separates with a translation shorter by more than kDepthRounding S
 (engine/collision/rounding.h); touching is never reported of boxes further apart than
 that, nor missed of boxes deeper. */
void Collide(const Box& A, const Pose& X_WA, const Box& B, const Pose& X_WB,
             Manifold& manifold);

/** Returns how two shapes touch, as one of the above sets it. */
template <class ShapeA, class ShapeB>
Manifold Collide(const ShapeA& A, const Pose& X_WA, const ShapeB& B, const Pose& X_WB) {
  Manifold manifold;
  Collide(A, X_WA, B, X_WB, manifold);
  return manifold;
}

}  // namespace cookbook
