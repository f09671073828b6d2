#include "engine/dynamics/joints/joint_solver.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cookbook {
namespace {

/** Error of a length that JointSolver::CorrectPositions() leaves, relative to the length
 and the places of the anchors: a few roundings. */
constexpr double kLengthTolerance = 1e-15;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/** Returns d / |d|; any direction if the anchors coincide. */
Eigen::Vector3d Direction(const Eigen::Vector3d& d) {
  const double length = d.norm();
  if (length < std::numeric_limits<double>::min()) return Eigen::Vector3d::UnitY();
  return d / length;
}

}  // namespace

void JointSolver::Begin(std::span<const DistanceJoint> joints,
                        std::span<const RigidBody> bodies,
                        std::span<const InverseInertia> inertias) {
  inertias_ = inertias;
  impulses_.resize(joints.size(), 0);
  constraints_.resize(joints.size());
  for (std::size_t k = 0; k < joints.size(); ++k) {
    const DistanceJoint& joint = joints[k];
    Constraint& constraint = constraints_[k];
    constraint.axis.A = joint.A.body;
    constraint.axis.B = joint.B.body;
    const AnchorPoint a = LocateAnchor(joint.A, bodies);
    const AnchorPoint b = LocateAnchor(joint.B, bodies);
    constraint.d_start = b.p_W - a.p_W;
    constraint.r_A_start = a.r_W;
    constraint.r_B_start = b.r_W;
    // The velocities keep the length at the start of the step, because those that restore
    // another length would add kinetic energy. Only JointSolver::CorrectPositions(),
    // which changes no velocity, restores the joint's length.
    constraint.length = constraint.d_start.norm();
    constraint.target = 0;
    SetDirection(constraint.d_start, a.r_W, b.r_W, constraint);
  }
}

void JointSolver::SetDirection(const Eigen::Vector3d& d_mean, const Eigen::Vector3d& r_A,
                               const Eigen::Vector3d& r_B, Constraint& constraint) const {
  constraint.axis.n = Direction(d_mean);
  constraint.axis.r_A = r_A;
  constraint.axis.r_B = r_B;
  const double response = constraint.axis.InverseEffectiveMass(inertias_);
  constraint.effective_mass = response > 0 ? 1 / response : 0;
}

double JointSolver::MaxStretchSpeed(std::span<const Velocity> velocities) const {
  double fastest = 0;
  for (const Constraint& constraint : constraints_) {
    fastest = std::max(fastest, std::abs(constraint.axis.RelativeVelocity(velocities)));
  }
  return fastest;
}

void JointSolver::WarmStart(std::span<Velocity> velocities, double h) {
  const double scale = h_ == 0 ? 0 : h / h_;
  h_ = h;
  for (std::size_t k = 0; k < constraints_.size(); ++k) {
    impulses_[k] *= scale;
    constraints_[k].axis.ApplyImpulse(impulses_[k], inertias_, velocities);
  }
}

double JointSolver::Iterate(std::span<Velocity> velocities) {
  double greatest = 0;
  for (std::size_t k = 0; k < constraints_.size(); ++k) {
    const Constraint& constraint = constraints_[k];
    if (constraint.effective_mass == 0) continue;
    // The relative velocity that is missing, and its impulse.
    const double change =
        constraint.target - constraint.axis.RelativeVelocity(velocities);
    impulses_[k] += constraint.effective_mass * change;
    constraint.axis.ApplyImpulse(constraint.effective_mass * change, inertias_,
                                 velocities);
    greatest = std::max(greatest, std::abs(change));
  }
  return greatest;
}

double JointSolver::MaxVelocityChange() const {
  double greatest = 0;
  for (std::size_t k = 0; k < constraints_.size(); ++k) {
    if (constraints_[k].effective_mass == 0) continue;
    greatest =
        std::max(greatest, std::abs(impulses_[k]) / constraints_[k].effective_mass);
  }
  return greatest;
}

double JointSolver::MaxError(std::span<const DistanceJoint> joints,
                             std::span<const RigidBody> after) const {
  double greatest = 0;
  for (std::size_t k = 0; k < constraints_.size(); ++k) {
    const Constraint& constraint = constraints_[k];
    if (constraint.effective_mass == 0) continue;
    const AnchorPoint a = LocateAnchor(joints[k].A, after);
    const AnchorPoint b = LocateAnchor(joints[k].B, after);
    const Eigen::Vector3d d = b.p_W - a.p_W;
    const double stretch = d.norm() - constraint.length;
    const double worked = constraint.axis.n.dot(d - constraint.d_start);
    const double size = a.p_W.norm() + b.p_W.norm() + constraint.length;
    const double error = std::max(std::abs(stretch), std::abs(worked)) / size;
    if (std::isnan(error)) return kInfinity;
    greatest = std::max(greatest, error);
  }
  return greatest;
}

double JointSolver::Relinearize(std::span<const DistanceJoint> joints,
                                std::span<const RigidBody> after,
                                std::span<const double> moved_fraction,
                                std::span<Velocity> velocities, double h) {
  double worst = 0;
  for (std::size_t k = 0; k < constraints_.size(); ++k) {
    Constraint& constraint = constraints_[k];
    if (constraint.effective_mass == 0) continue;
    const AnchorPoint a = LocateAnchor(joints[k].A, after);
    const AnchorPoint b = LocateAnchor(joints[k].B, after);
    const Eigen::Vector3d d = b.p_W - a.p_W;
    worst = std::max(worst, std::abs(d.norm() - constraint.length) / constraint.length);
    // Take the accumulated impulse back along the old axis, apply it along the new one.
    constraint.axis.ApplyImpulse(-impulses_[k], inertias_, velocities);
    const Eigen::Vector3d d_mean = 0.5 * (constraint.d_start + d);
    SetDirection(d_mean, 0.5 * (constraint.r_A_start + a.r_W),
                 0.5 * (constraint.r_B_start + b.r_W), constraint);
    constraint.axis.ApplyImpulse(impulses_[k], inertias_, velocities);
    // |d|² − |d_start|² = 2 d̄·(d − d_start): the error along d̄.
    const double error =
        (constraint.length * constraint.length - d.squaredNorm()) / (2 * d_mean.norm());
    double fraction = 0.5;
    for (const int body : {constraint.axis.A, constraint.axis.B}) {
      if (body >= 0) {
        fraction = std::max(fraction, moved_fraction[static_cast<std::size_t>(body)]);
      }
    }
    constraint.target =
        constraint.axis.RelativeVelocity(velocities) + error / (fraction * h);
  }
  return worst;
}

bool JointSolver::CorrectPositions(std::span<const DistanceJoint> joints, double fraction,
                                   std::span<const RigidBody> bodies,
                                   std::span<Velocity> corrections) {
  bool moved = false;
  for (std::size_t k = 0; k < constraints_.size(); ++k) {
    Constraint& constraint = constraints_[k];
    const AnchorPoint a = LocateAnchor(joints[k].A, bodies);
    const AnchorPoint b = LocateAnchor(joints[k].B, bodies);
    const Eigen::Vector3d d = b.p_W - a.p_W;
    const double error = joints[k].length - d.norm();
    const double size = a.p_W.norm() + b.p_W.norm() + joints[k].length;
    if (std::abs(error) <= kLengthTolerance * size) continue;
    SetDirection(d, a.r_W, b.r_W, constraint);
    const double change =
        fraction * error - constraint.axis.RelativeVelocity(corrections);
    constraint.axis.ApplyImpulse(constraint.effective_mass * change, inertias_,
                                 corrections);
    moved = true;
  }
  return moved;
}

}  // namespace cookbook
