#pragma once

#include <Eigen/Core>

namespace cookbook {

/** A point on a body, or in the world, to which a joint or a spring is attached. */
struct Anchor {
  int body = -1;  ///< Index of the body; −1: fixed to the world.
  /** In the frame of the body, or in the world frame for body −1. [m] */
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
};

}  // namespace cookbook
