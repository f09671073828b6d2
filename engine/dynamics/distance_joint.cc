#include "engine/dynamics/distance_joint.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cookbook {
namespace {

/** A rod that is off its length by more than this share is not off by rounding: its
 length is left alone by the velocities, and JointSolver::Project() brings it back. */
constexpr double kOffLength = 1e-6;

double EffectiveMass(const Eigen::Vector3d& n, const Eigen::Vector3d& r_A,
                     const InverseInertia& A, const Eigen::Vector3d& r_B,
                     const InverseInertia& B) {
  const Eigen::Vector3d a = r_A.cross(n);
  const Eigen::Vector3d b = r_B.cross(n);
  const double k = A.mass + B.mass + a.dot(A.tensor_W * a) + b.dot(B.tensor_W * b);
  return k > 0 ? 1 / k : 0;
}

void Push(const Eigen::Vector3d& J, const Eigen::Vector3d& r,
          const InverseInertia& inertia, Velocity& velocity) {
  velocity.v += inertia.mass * J;
  velocity.w += inertia.tensor_W * r.cross(J);
}

/** Returns d / |d|; any direction where the anchors coincide. */
Eigen::Vector3d Direction(const Eigen::Vector3d& d) {
  const double length = d.norm();
  if (length < std::numeric_limits<double>::min()) return Eigen::Vector3d::UnitY();
  return d / length;
}

}  // namespace

AnchorPlace PlaceOf(const Anchor& anchor, std::span<const RigidBody> bodies) {
  if (anchor.body < 0) return {anchor.point, Eigen::Vector3d::Zero()};
  const RigidBody& body = bodies[static_cast<std::size_t>(anchor.body)];
  const Eigen::Vector3d r_W = body.R_WB * anchor.point;
  return {body.state.p_WB + r_W, r_W};
}

void JointSolver::Begin(std::span<const DistanceJoint> joints,
                        std::span<const RigidBody> bodies,
                        std::span<const InverseInertia> inertias) {
  inertias_ = inertias;
  impulses_.resize(joints.size(), 0);
  rows_.resize(joints.size());
  for (std::size_t k = 0; k < joints.size(); ++k) {
    const DistanceJoint& joint = joints[k];
    Row& row = rows_[k];
    row.A = joint.A.body;
    row.B = joint.B.body;
    const AnchorPlace a = PlaceOf(joint.A, bodies);
    const AnchorPlace b = PlaceOf(joint.B, bodies);
    row.d_start = b.p_W - a.p_W;
    row.r_A_start = a.r_W;
    row.r_B_start = b.r_W;
    const double length = row.d_start.norm();
    row.length = std::abs(length - joint.length) <= kOffLength * joint.length
                     ? joint.length
                     : length;
    row.target = 0;
    Aim(row.d_start, a.r_W, b.r_W, row);
  }
}

void JointSolver::Aim(const Eigen::Vector3d& d_mean, const Eigen::Vector3d& r_A,
                      const Eigen::Vector3d& r_B, Row& row) const {
  row.n = Direction(d_mean);
  row.r_A = r_A;
  row.r_B = r_B;
  row.effective_mass = EffectiveMass(row.n, r_A, InertiaOf(row.A), r_B, InertiaOf(row.B));
}

const InverseInertia& JointSolver::InertiaOf(int body) const {
  static const InverseInertia kWorld{Eigen::Matrix3d::Zero(), 0};
  return body < 0 ? kWorld : inertias_[static_cast<std::size_t>(body)];
}

void JointSolver::Apply(const Row& row, double impulse,
                        std::span<Velocity> velocities) const {
  const Eigen::Vector3d J = impulse * row.n;
  if (row.A >= 0) {
    Push(-J, row.r_A, InertiaOf(row.A), velocities[static_cast<std::size_t>(row.A)]);
  }
  if (row.B >= 0) {
    Push(J, row.r_B, InertiaOf(row.B), velocities[static_cast<std::size_t>(row.B)]);
  }
}

double JointSolver::Stretching(const Row& row,
                               std::span<const Velocity> velocities) const {
  Eigen::Vector3d u = Eigen::Vector3d::Zero();
  if (row.B >= 0) u += velocities[static_cast<std::size_t>(row.B)].At(row.r_B);
  if (row.A >= 0) u -= velocities[static_cast<std::size_t>(row.A)].At(row.r_A);
  return row.n.dot(u);
}

double JointSolver::FastestStretching(std::span<const Velocity> velocities) const {
  double fastest = 0;
  for (const Row& row : rows_) {
    fastest = std::max(fastest, std::abs(Stretching(row, velocities)));
  }
  return fastest;
}

void JointSolver::WarmStart(std::span<Velocity> velocities) {
  for (std::size_t k = 0; k < rows_.size(); ++k) {
    Apply(rows_[k], impulses_[k], velocities);
  }
}

double JointSolver::Sweep(std::span<Velocity> velocities) {
  double greatest = 0;
  for (std::size_t k = 0; k < rows_.size(); ++k) {
    const Row& row = rows_[k];
    const double change = row.target - Stretching(row, velocities);
    impulses_[k] += row.effective_mass * change;
    Apply(row, row.effective_mass * change, velocities);
    if (row.effective_mass > 0) greatest = std::max(greatest, std::abs(change));
  }
  return greatest;
}

double JointSolver::Correct(std::span<const DistanceJoint> joints,
                            std::span<const RigidBody> after,
                            std::span<const double> share, std::span<Velocity> velocities,
                            double h) {
  double worst = 0;
  for (std::size_t k = 0; k < rows_.size(); ++k) {
    Row& row = rows_[k];
    if (row.effective_mass == 0) continue;
    const AnchorPlace a = PlaceOf(joints[k].A, after);
    const AnchorPlace b = PlaceOf(joints[k].B, after);
    const Eigen::Vector3d d = b.p_W - a.p_W;
    worst = std::max(worst, std::abs(d.norm() - row.length) / row.length);
    // The impulse turns with its row: take it back along the old, put it on along the
    // new.
    Apply(row, -impulses_[k], velocities);
    const Eigen::Vector3d d_mean = 0.5 * (row.d_start + d);
    Aim(d_mean, 0.5 * (row.r_A_start + a.r_W), 0.5 * (row.r_B_start + b.r_W), row);
    Apply(row, impulses_[k], velocities);
    // |d|² − |d_start|² = 2 d̄·(d − d_start): what is missing of it, as a velocity.
    const double missing =
        (row.length * row.length - d.squaredNorm()) / (2 * d_mean.norm());
    double moves = 0.5;
    for (const int body : {row.A, row.B}) {
      if (body >= 0) moves = std::max(moves, share[static_cast<std::size_t>(body)]);
    }
    row.target = Stretching(row, velocities) + missing / (moves * h);
  }
  return worst;
}

bool JointSolver::Project(std::span<const DistanceJoint> joints, double share,
                          std::span<const RigidBody> bodies, std::span<Velocity> moves) {
  bool moved = false;
  for (std::size_t k = 0; k < rows_.size(); ++k) {
    Row& row = rows_[k];
    const AnchorPlace a = PlaceOf(joints[k].A, bodies);
    const AnchorPlace b = PlaceOf(joints[k].B, bodies);
    const Eigen::Vector3d d = b.p_W - a.p_W;
    const double off = joints[k].length - d.norm();
    if (std::abs(off) <= kOffLength * joints[k].length) continue;
    Aim(d, a.r_W, b.r_W, row);
    Apply(row, row.effective_mass * (share * off - Stretching(row, moves)), moves);
    moved = true;
  }
  return moved;
}

}  // namespace cookbook
