#pragma once

#include <optional>

#include <Eigen/Geometry>

namespace touchstone {

/** Where a body is: maps body coordinates to world coordinates, x_W = R_WB x_B + p_WB.

 A pose is given by a unit quaternion, or by a full rotation matrix where bits matter
 (some faults of engines vanish when the pose goes through a quaternion). Whichever was
 given is kept, so that a file is written back bit for bit. `R_WB` is what every engine
 receives and what the referee judges by: the question is the affine image under these
 very doubles. */
struct Pose {
  Eigen::Vector3d p_WB = Eigen::Vector3d::Zero();  ///< [m]
  /** Orthonormal to rounding, determinant +1. */
  Eigen::Matrix3d R_WB = Eigen::Matrix3d::Identity();
  /** The quaternion `R_WB` was computed from; empty where the matrix itself was given. */
  std::optional<Eigen::Quaterniond> q_WB;

  /** Returns the pose at `p_WB` turned by the unit quaternion `q_WB`. */
  static Pose FromQuaternion(const Eigen::Vector3d& p_WB, const Eigen::Quaterniond& q_WB);

  /** Returns the pose at `p_WB` with exactly the matrix `R_WB`. */
  static Pose FromMatrix(const Eigen::Vector3d& p_WB, const Eigen::Matrix3d& R_WB);

  /** Returns the world coordinates of the body point `p_B`. [m] */
  Eigen::Vector3d operator*(const Eigen::Vector3d& p_B) const {
    return R_WB * p_B + p_WB;
  }
};

/** Returns the largest entry of |RᵀR − 1|: how far the matrix is from a rotation, which
 is the part of a disagreement that no engine can be blamed for. */
double OrthonormalityDefect(const Eigen::Matrix3d& R);

}  // namespace touchstone
