#pragma once

#include <vector>

#include <Eigen/Core>

#include "engine/collision/shape.h"
#include "engine/printed/errata.h"

namespace cookbook::printed {

/** A box and its pose in the world. */
struct PlacedBox {
  const Box& box;
  const Pose& X_WB;

  Eigen::Vector3d axis(int k) const { return X_WB.R_WB.col(k); }
  /** Returns half the length of the box's projection onto the unit vector `n_W`. [m] */
  double Reach(const Eigen::Vector3d& n_W) const {
    return (X_WB.R_WB.transpose() * n_W).cwiseAbs().dot(box.half_extents);
  }
};

/** The axis of least depth found by the search. */
struct LeastDepth {
  Eigen::Vector3d n_AB_W;
  double depth;  ///< [m]
};

/** Returns the contacts of boxes that overlap by `least`, on the plane midway through the
 overlap. World frame. [m] */
std::vector<Eigen::Vector3d> Contacts(const PlacedBox& A, const PlacedBox& B,
                                      const LeastDepth& least, const Errata& errata);

}  // namespace cookbook::printed
