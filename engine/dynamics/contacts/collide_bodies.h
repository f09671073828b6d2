#pragma once

#include <span>

#include "engine/collision/manifold.h"
#include "engine/dynamics/body/rigid_body.h"
#include "engine/dynamics/contacts/collide_boxes_simd.h"

namespace cookbook {

/** Whether both bodies are boxes. Their contact is on one face or between two edges. */
bool AreBoxes(const RigidBody& A, const RigidBody& B);

/** Collides the shapes of two bodies, including speculative contacts: contact points with
 a separation up to `margin` [m]. A box that rests on four corners keeps all four even if
 rounding lifts one. `touching` is the same as that of Collide(); `count` may be positive
 if it is false.

 A contact point lies on the surface of the dynamic body if the other is static, on the
 surface of the sphere if the other is a box, else midway. So the lever arm of friction on
 a sphere is its radius, at any depth.

 For boxes with nearly parallel faces, the manifold is the patch of these faces, even if
 Collide() returns the one contact of two edges: unless the boxes are much deeper along
 the faces, see kFaceDepth. One contact point cannot support a stack.
 `n_guess_W` is the normal of the pair in the previous step, or zero; it decides ties.
 @pre Not two half-spaces, and no points. */
void CollideSpeculative(double margin, const RigidBody& A, const RigidBody& B,
                        const Eigen::Vector3d& n_guess_W, Manifold& manifold);

/** The same for several pairs. Boxes are collided in batches of kPairsPerBatch. The
 result for a pair does not depend on the other pairs. */
void CollideSpeculative(std::span<const CollisionPair> pairs);

}  // namespace cookbook
