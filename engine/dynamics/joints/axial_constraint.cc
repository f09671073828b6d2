#include "engine/dynamics/joints/axial_constraint.h"

namespace cookbook {
namespace {

double InverseEffectiveMassOf(int body, const Eigen::Vector3d& n,
                              const Eigen::Vector3d& r,
                              std::span<const InverseInertia> inertias) {
  if (body < 0) return 0;
  const InverseInertia& inertia = inertias[static_cast<std::size_t>(body)];
  const Eigen::Vector3d c = r.cross(n);
  return inertia.mass * n.squaredNorm() + c.dot(inertia.Times(c));
}

}  // namespace

AnchorPoint LocateAnchor(const Anchor& anchor, std::span<const RigidBody> bodies) {
  if (anchor.body < 0) return {anchor.point, Eigen::Vector3d::Zero()};
  const RigidBody& body = bodies[static_cast<std::size_t>(anchor.body)];
  const Eigen::Vector3d r_W = body.R_WB * anchor.point;
  return {body.state.p_WB + r_W, r_W};
}

double AxialConstraint::InverseEffectiveMass(
    std::span<const InverseInertia> inertias) const {
  return InverseEffectiveMassOf(A, n, r_A, inertias) +
         InverseEffectiveMassOf(B, n, r_B, inertias);
}

}  // namespace cookbook
