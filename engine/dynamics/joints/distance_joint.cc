#include "engine/dynamics/joints/distance_joint.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cookbook {
namespace {

/** A rod that is off its length by more than this share is not off by rounding: its
 length is left alone by the velocities, and JointSolver::Project() brings it back. */
constexpr double kOffLength = 1e-6;

/** Returns d / |d|; any direction where the anchors coincide. */
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
  rows_.resize(joints.size());
  for (std::size_t k = 0; k < joints.size(); ++k) {
    const DistanceJoint& joint = joints[k];
    Row& row = rows_[k];
    row.line.A = joint.A.body;
    row.line.B = joint.B.body;
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
  row.line.n = Direction(d_mean);
  row.line.r_A = r_A;
  row.line.r_B = r_B;
  const double response = row.line.Response(inertias_);
  row.effective_mass = response > 0 ? 1 / response : 0;
}

double JointSolver::FastestStretching(std::span<const Velocity> velocities) const {
  double fastest = 0;
  for (const Row& row : rows_) {
    fastest = std::max(fastest, std::abs(row.line.Parting(velocities)));
  }
  return fastest;
}

void JointSolver::WarmStart(std::span<Velocity> velocities, double h) {
  const double scale = h_ == 0 ? 0 : h / h_;
  h_ = h;
  for (std::size_t k = 0; k < rows_.size(); ++k) {
    impulses_[k] *= scale;
    rows_[k].line.Apply(impulses_[k], inertias_, velocities);
  }
}

double JointSolver::Iterate(std::span<Velocity> velocities) {
  double greatest = 0;
  for (std::size_t k = 0; k < rows_.size(); ++k) {
    const Row& row = rows_[k];
    if (row.effective_mass == 0) continue;
    const double change = row.target - row.line.Parting(velocities);
    impulses_[k] += row.effective_mass * change;
    row.line.Apply(row.effective_mass * change, inertias_, velocities);
    greatest = std::max(greatest, std::abs(change));
  }
  return greatest;
}

double JointSolver::GreatestLoad() const {
  double greatest = 0;
  for (std::size_t k = 0; k < rows_.size(); ++k) {
    if (rows_[k].effective_mass == 0) continue;
    greatest = std::max(greatest, std::abs(impulses_[k]) / rows_[k].effective_mass);
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
    row.line.Apply(-impulses_[k], inertias_, velocities);
    const Eigen::Vector3d d_mean = 0.5 * (row.d_start + d);
    Aim(d_mean, 0.5 * (row.r_A_start + a.r_W), 0.5 * (row.r_B_start + b.r_W), row);
    row.line.Apply(impulses_[k], inertias_, velocities);
    // |d|² − |d_start|² = 2 d̄·(d − d_start): what is missing of it, as a velocity.
    const double missing =
        (row.length * row.length - d.squaredNorm()) / (2 * d_mean.norm());
    double moves = 0.5;
    for (const int body : {row.line.A, row.line.B}) {
      if (body >= 0) moves = std::max(moves, share[static_cast<std::size_t>(body)]);
    }
    row.target = row.line.Parting(velocities) + missing / (moves * h);
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
    const double gain = share * off - row.line.Parting(moves);
    row.line.Apply(row.effective_mass * gain, inertias_, moves);
    moved = true;
  }
  return moved;
}

}  // namespace cookbook
