#pragma once

#include "scenarios/contact_query.h"

namespace touchstone {

/** Returns a frame away from the origin in which no coordinate is exact in binary. */
inline Pose AwkwardPose() {
  return Pose::FromQuaternion({0.31, -0.72, 0.53},
                              Eigen::Quaterniond(0.61, -0.35, 0.52, 0.48).normalized());
}

/** Returns the rotation by `angle` [rad] about `axis`, of any length. */
inline Eigen::Quaterniond Turn(double angle, const Eigen::Vector3d& axis) {
  return Eigen::Quaterniond(Eigen::AngleAxisd(angle, axis.normalized()));
}

/** Returns a body of `shape` at `p` [m], turned by `q`, in the awkward frame. */
inline Body Place(const Shape& shape, const Eigen::Vector3d& p,
                  const Eigen::Quaterniond& q = Eigen::Quaterniond::Identity()) {
  const Pose X_WF = AwkwardPose();
  return {shape, Pose::FromQuaternion(X_WF * p, (*X_WF.q_WB * q).normalized())};
}

}  // namespace touchstone
