#pragma once

#include "engine/manifold.h"
#include "engine/shape.h"

namespace cookbook {

/** Fills `manifold` with the contacts of two boxes that are apart by no more than
 `margin` [m], as CollideWithin() says, each midway. Returns false where two edges meet,
 apart from all faces: the manifold then has its normal and separation, and no contacts.
 */
bool CollideNearFaces(double margin, const Box& A, const Pose& X_WA, const Box& B,
                      const Pose& X_WB, const Eigen::Vector3d& n_guess_W,
                      Manifold& manifold);

}  // namespace cookbook
