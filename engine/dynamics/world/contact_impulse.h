#pragma once

#include <Eigen/Core>

namespace cookbook {

/** The impulse of a contact in a step. */
struct ContactImpulse {
  int A;
  int B;
  Eigen::Vector3d p_WC;    ///< Contact point. [m]
  Eigen::Vector3d n_AB_W;  ///< Unit, out of A into B.
  Eigen::Vector3d J_B_W;   ///< Impulse on B; the opposite acts on A. [N s]
  /** Separation at the start of the step or at the time of impact; < 0 penetrating. [m]
   */
  double separation;
};

}  // namespace cookbook
