#pragma once

#include "engine/manifold.h"
#include "engine/shape.h"

namespace cookbook {

/** One face of a box: the one that its axis leaves on the given side. */
struct FaceOfBox {
  int axis = 0;
  double side = 1;  ///< −1 or +1.
};

/** Returns the face of a box, turned as R_WB, whose normal is nearest to `n_W`. */
FaceOfBox FaceTowards(const Eigen::Vector3d& n_W, const Eigen::Matrix3d& R_WB);

/** Fills `manifold` with the contacts of the face `face` of `reference` and the face of
 `incident` most opposed to it: the corners of the one clipped to the other that are below
 the reference face or above it by at most `margin` [m], each with its own separation, on
 the surface of `incident`. The features number the corners; `reference_is_B` makes them
 differ from those found the other way round. Leaves n_AB_W and `touching` alone. */
void FillFacePatch(double margin, const FaceOfBox& face, const Box& reference,
                   const Pose& X_WR, const Box& incident, const Pose& X_WI,
                   bool reference_is_B, Manifold& manifold);

}  // namespace cookbook
