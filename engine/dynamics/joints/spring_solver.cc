#include "engine/dynamics/joints/spring_solver.h"

#include <algorithm>
#include <cmath>

namespace cookbook {
namespace {

/** Relative rounding error of a length, a few units of rounding. [-] */
constexpr double kLengthRounding = 1e-15;

/** Returns (d₀ + d₁)/(ℓ₀ + ℓ₁); zero if the anchors coincide before and after, for there
 is no direction. */
Eigen::Vector3d MeanDirection(const Eigen::Vector3d& d_sum, double length_sum) {
  if (length_sum == 0) return Eigen::Vector3d::Zero();
  return d_sum / length_sum;
}

}  // namespace

Eigen::Vector3d ForceOnA(const Spring& spring, std::span<const RigidBody> bodies) {
  const Eigen::Vector3d d =
      LocateAnchor(spring.B, bodies).p_W - LocateAnchor(spring.A, bodies).p_W;
  const double length = d.norm();
  return spring.stiffness * (length - spring.rest_length) * MeanDirection(d, length);
}

void SpringSolver::Linearize(const Spring& spring, double length, double fraction,
                             double h, Constraint& constraint) {
  const double stretch = 0.5 * (constraint.length_start + length) - spring.rest_length;
  constraint.target_impulse = -h * spring.stiffness * stretch -
                              spring.damping * (length - constraint.length_start);
  // A change of the relative velocity by δ changes ℓ₁ by fraction h δ.
  constraint.impulse_per_speed =
      fraction * h * (0.5 * h * spring.stiffness + spring.damping);
}

void SpringSolver::Begin(std::span<const Spring> springs,
                         std::span<const RigidBody> bodies,
                         std::span<const InverseInertia> inertias,
                         std::span<const Velocity> before, double h) {
  inertias_ = inertias;
  constraints_.resize(springs.size());
  for (std::size_t k = 0; k < springs.size(); ++k) {
    Constraint& constraint = constraints_[k];
    const AnchorPoint a = LocateAnchor(springs[k].A, bodies);
    const AnchorPoint b = LocateAnchor(springs[k].B, bodies);
    constraint.d_start = b.p_W - a.p_W;
    constraint.r_A_start = a.r_W;
    constraint.r_B_start = b.r_W;
    constraint.length_start = constraint.d_start.norm();
    constraint.axis = {springs[k].A.body, springs[k].B.body,
                       MeanDirection(constraint.d_start, constraint.length_start), a.r_W,
                       b.r_W};
    constraint.inverse_effective_mass = constraint.axis.InverseEffectiveMass(inertias);
    constraint.expected_speed = constraint.axis.RelativeVelocity(before);
    constraint.impulse = 0;
    Linearize(springs[k], constraint.length_start + h * constraint.expected_speed, 0.5, h,
              constraint);
  }
}

double SpringSolver::Iterate(std::span<Velocity> velocities) {
  double greatest = 0;
  for (Constraint& constraint : constraints_) {
    if (constraint.inverse_effective_mass == 0) continue;
    const double speed = constraint.axis.RelativeVelocity(velocities);
    const double error =
        constraint.target_impulse -
        constraint.impulse_per_speed * (speed - constraint.expected_speed) -
        constraint.impulse;
    const double change =
        error / (1 + constraint.impulse_per_speed * constraint.inverse_effective_mass);
    constraint.impulse += change;
    constraint.axis.ApplyImpulse(change, inertias_, velocities);
    greatest = std::max(greatest, std::abs(change) * constraint.inverse_effective_mass);
  }
  return greatest;
}

double SpringSolver::MaxVelocityChange() const {
  double greatest = 0;
  for (const Constraint& constraint : constraints_) {
    greatest = std::max(greatest, std::abs(constraint.target_impulse) *
                                      constraint.inverse_effective_mass);
  }
  return greatest;
}

bool SpringSolver::Relinearize(std::span<const Spring> springs,
                               std::span<const RigidBody> after,
                               std::span<const double> moved_fraction,
                               std::span<Velocity> velocities, double h, double solved) {
  bool is_right = true;
  for (std::size_t k = 0; k < constraints_.size(); ++k) {
    Constraint& constraint = constraints_[k];
    const AnchorPoint a = LocateAnchor(springs[k].A, after);
    const AnchorPoint b = LocateAnchor(springs[k].B, after);
    const Eigen::Vector3d d = b.p_W - a.p_W;
    const double length = d.norm();
    const double length_sum = constraint.length_start + length;
    double fraction = 0.5;
    for (const int body : {constraint.axis.A, constraint.axis.B}) {
      if (body >= 0)
        fraction = std::max(fraction, moved_fraction[static_cast<std::size_t>(body)]);
    }
    Linearize(springs[k], length, fraction, h, constraint);
    // The rounding of a length changes the impulse by ½ h k + b per metre.
    const double rounding = kLengthRounding * length_sum;
    const double rounded = std::abs(constraint.impulse_per_speed / (fraction * h)) *
                           constraint.inverse_effective_mass * rounding;
    const double error = std::abs(constraint.target_impulse - constraint.impulse) *
                         constraint.inverse_effective_mass;
    is_right = is_right && (length_sum == 0 || (error * std::abs(h) <= rounding &&
                                                error <= solved + rounded));
    constraint.axis.ApplyImpulse(-constraint.impulse, inertias_, velocities);
    constraint.axis.n = MeanDirection(constraint.d_start + d, length_sum);
    constraint.axis.r_A = 0.5 * (constraint.r_A_start + a.r_W);
    constraint.axis.r_B = 0.5 * (constraint.r_B_start + b.r_W);
    constraint.inverse_effective_mass = constraint.axis.InverseEffectiveMass(inertias_);
    constraint.axis.ApplyImpulse(constraint.impulse, inertias_, velocities);
    constraint.expected_speed = constraint.axis.RelativeVelocity(velocities);
  }
  return is_right;
}

}  // namespace cookbook
