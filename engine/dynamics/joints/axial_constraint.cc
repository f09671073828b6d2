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

void ApplyToBody(int body, const Eigen::Vector3d& J, const Eigen::Vector3d& r,
                 std::span<const InverseInertia> inertias,
                 std::span<Velocity> velocities) {
  if (body < 0) return;
  const InverseInertia& inertia = inertias[static_cast<std::size_t>(body)];
  Velocity& velocity = velocities[static_cast<std::size_t>(body)];
  velocity.v += inertia.mass * J;
  velocity.w += inertia.Times(r.cross(J));
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

double AxialConstraint::RelativeVelocity(std::span<const Velocity> velocities) const {
  Eigen::Vector3d u = Eigen::Vector3d::Zero();
  if (B >= 0) u += velocities[static_cast<std::size_t>(B)].At(r_B);
  if (A >= 0) u -= velocities[static_cast<std::size_t>(A)].At(r_A);
  return n.dot(u);
}

void AxialConstraint::ApplyImpulse(double impulse,
                                   std::span<const InverseInertia> inertias,
                                   std::span<Velocity> velocities) const {
  const Eigen::Vector3d J = impulse * n;
  ApplyToBody(A, -J, r_A, inertias, velocities);
  ApplyToBody(B, J, r_B, inertias, velocities);
}

}  // namespace cookbook
