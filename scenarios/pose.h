#pragma once

#include <optional>

#include <Eigen/Geometry>

#include "scenarios/eigen_alignment.h"

namespace touchstone {

/** The pose of a body: maps body coordinates to world coordinates, x_W = R_WB x_B + p_WB.

 A pose is given by a unit quaternion, or by a full rotation matrix where every bit
 matters (some engine faults vanish when the pose is converted to a quaternion). The given
 form is kept, so that a file is written back bit for bit. Every engine receives `R_WB`,
 and the referee judges by it: the question is the affine image under exactly these
 doubles. */
struct Pose {
  Eigen::Vector3d p_WB = Eigen::Vector3d::Zero();  ///< [m]
  /** Orthonormal up to rounding, determinant +1. */
  Eigen::Matrix3d R_WB = Eigen::Matrix3d::Identity();
  /** The quaternion from which `R_WB` was computed; empty if the matrix was given. */
  std::optional<Eigen::Quaterniond> q_WB;

  /** Returns the pose at `p_WB` with the orientation of the unit quaternion `q_WB`. */
  static Pose FromQuaternion(const Eigen::Vector3d& p_WB, const Eigen::Quaterniond& q_WB);

  /** Returns the pose at `p_WB` with exactly the matrix `R_WB`. */
  static Pose FromMatrix(const Eigen::Vector3d& p_WB, const Eigen::Matrix3d& R_WB);

  /** Returns the world coordinates of the body point `p_B`. [m] */
  Eigen::Vector3d operator*(const Eigen::Vector3d& p_B) const {
    return R_WB * p_B + p_WB;
  }
};

/** Returns the largest entry of |RᵀR − 1|: the deviation of the matrix from a rotation.
 No engine can be blamed for the disagreement that it causes. */
double OrthonormalityDefect(const Eigen::Matrix3d& R);

}  // namespace touchstone
