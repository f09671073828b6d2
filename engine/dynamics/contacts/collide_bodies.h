#pragma once

#include <span>

#include "engine/collision/manifold.h"
#include "engine/dynamics/body/rigid_body.h"
#include "engine/dynamics/contacts/collide_boxes_simd.h"

namespace cookbook {

/** Whether both are boxes: all contacts of theirs are of one face, or of two edges. */
bool AreBoxes(const RigidBody& A, const RigidBody& B);

/** Fills `manifold` with how the shapes of two bodies touch, and also the contacts that
 are apart by no more than `margin` [m], whose separation is positive: a box that rests on
 four corners keeps all four though rounding lifts one. `touching` is as Collide() says;
 `count` may be positive where it is false.

 A contact lies on the surface of the body that friction can turn about it: of the moving
 one against a static one, of the sphere against a box, else midway. So the lever arm of a
 ball is its radius, however deep it is caught.

 Boxes of which nearly parallel faces meet, within the margin, get the patch of those
 faces where Collide() may give the one contact of two edges: what is least deep by a hair
 is not what holds a stack. `n_guess_W` is the normal of the pair in the step before, or
 zero; it decides ties.
 @pre Not two half-spaces, and no points. */
void CollideSpeculative(double margin, const RigidBody& A, const RigidBody& B,
                        const Eigen::Vector3d& n_guess_W, Manifold& manifold);

/** The same of several pairs: boxes are looked at together, kNeighbours at once. What is
 found of a pair does not depend on the others. */
void CollideSpeculative(std::span<const Neighbours> pairs);

}  // namespace cookbook
