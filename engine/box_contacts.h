#pragma once

#include "engine/manifold.h"
#include "engine/separating_axis.h"

namespace cookbook {

/** Fills the contacts of two boxes that touch along a face normal of A (or of B, where
 `reference_is_B`): the face most opposed to it, clipped to the reference face.
 Engine-internal: call Collide(). */
void FillFaceContacts(const BoxPair& pair, const AxisGap& axis, const Pose& X_WA,
                      const Pose& X_WB, Manifold& manifold);

/** Fills the one contact of two boxes that touch edge on edge: midway between the nearest
 points of the two supporting edges. `n_AB_A` is the normal in A's frame. Engine-internal.
 */
void FillEdgeContact(const BoxPair& pair, const AxisGap& axis,
                     const Eigen::Vector3d& n_AB_A, const Pose& X_WA, Manifold& manifold);

}  // namespace cookbook
