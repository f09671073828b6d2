#include "scenarios/pose.h"

namespace touchstone {

Pose Pose::FromQuaternion(const Eigen::Vector3d& p_WB, const Eigen::Quaterniond& q_WB) {
  return {p_WB, q_WB.toRotationMatrix(), q_WB};
}

Pose Pose::FromMatrix(const Eigen::Vector3d& p_WB, const Eigen::Matrix3d& R_WB) {
  return {p_WB, R_WB, std::nullopt};
}

double OrthonormalityDefect(const Eigen::Matrix3d& R) {
  return (R.transpose() * R - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
}

}  // namespace touchstone
