#include "engine/dynamics/joints/direct_joint_solver.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/SparseCore>
#include <Eigen/SparseLU>

#include "engine/dynamics/body/rotation.h"

namespace cookbook {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr int kMaxIterations = 30;
/** The least fraction of a step of Newton's method that is tried. */
constexpr double kLeastFraction = 1.0 / 16;
/** Error of a length, relative to itself and the places of the anchors: each coordinate
 of the difference of two anchors has about four roundings, of 1e-16. */
constexpr double kLengthTolerance = 1e-15;
/** Error of a velocity relative to the greatest velocity or change: a few roundings. */
constexpr double kVelocityTolerance = 1e-14;
/** Compliance of a rod relative to its response. Without it the equations of redundant
 rods would be singular. It delays convergence by this factor, and does not change the
 solution. */
constexpr double kCompliance = 1e-13;
/** Errors in multiples of the tolerances that are taken for roundings once iterations do
 not reduce them. */
constexpr double kStagnation = 100;

/** Returns the matrix of the cross product, [u]× x = u × x. */
Matrix3d Cross(const Vector3d& u) {
  Matrix3d m;
  m << 0, -u[2], u[1], u[2], 0, -u[0], -u[1], u[0], 0;
  return m;
}

}  // namespace
void DirectJointSolver::CollectLinks(const System& system,
                                     std::span<const double> joint_impulses) {
  links_.clear();
  const auto collect = [&](const Anchor& A, const Anchor& B, std::size_t index,
                           bool is_spring, double impulse) {
    Link link;
    link.A = A.body;
    link.B = B.body;
    link.index = index;
    link.is_spring = is_spring;
    const AnchorPoint a = LocateAnchor(A, system.bodies);
    const AnchorPoint b = LocateAnchor(B, system.bodies);
    link.d_start = b.p_W - a.p_W;
    link.r_A_start = a.r_W;
    link.r_B_start = b.r_W;
    link.length_start = link.d_start.norm();
    const double length = std::max(link.length_start, std::numeric_limits<double>::min());
    const AxialConstraint axis{link.A, link.B, link.d_start / length, a.r_W, b.r_W};
    link.inverse_effective_mass = axis.InverseEffectiveMass(system.inertias);
    if (link.inverse_effective_mass == 0) return;
    link.mu = impulse / length;
    links_.push_back(link);
  };
  for (std::size_t k = 0; k < system.joints.size(); ++k) {
    const DistanceJoint& joint = system.joints[k];
    collect(joint.A, joint.B, k, false, joint_impulses[k]);
  }
  for (std::size_t k = 0; k < system.springs.size(); ++k) {
    const Spring& spring = system.springs[k];
    collect(spring.A, spring.B, k, true, 0);
  }
}

void DirectJointSolver::CollectBodies(const System& system) {
  linked_bodies_.clear();
  linked_body_of_.assign(system.bodies.size(), -1);
  unknowns_ = 0;
  for (const Link& link : links_) {
    for (const int body : {link.A, link.B}) {
      if (body < 0) continue;
      const RigidBody& rigid = system.bodies[static_cast<std::size_t>(body)];
      int& place = linked_body_of_[static_cast<std::size_t>(body)];
      if (rigid.is_static() || place >= 0) continue;
      place = static_cast<int>(linked_bodies_.size());
      LinkedBody linked;
      linked.body = body;
      linked.first = unknowns_;
      linked.rotates = !rigid.is_point;
      linked.mass = 1 / system.inertias[static_cast<std::size_t>(body)].mass;
      linked.inertia = rigid.R_WB * rigid.moments.asDiagonal() * rigid.R_WB.transpose();
      linked_bodies_.push_back(linked);
      unknowns_ += linked.rotates ? 6 : 3;
    }
  }
}

double DirectJointSolver::UpdateResiduals(const System& system,
                                          const Solution& solution) {
  for (LinkedBody& linked : linked_bodies_) {
    const auto i = static_cast<std::size_t>(linked.body);
    const RigidBody& start = system.bodies[i];
    if (linked.rotates && system.turns_with_lever_arms && !start.is_isotropic) {
      const BodyState& end = solution.after[i].state;
      linked.turn = LeverArmResponse({start.state.q_WB, start.state.w_WB},
                                     {end.q_WB, end.w_WB}, start.moments, system.h) *
                    linked.inertia;
    } else if (linked.rotates) {
      // The Cayley map of h ω̄, in the world frame.
      const Vector3d x = 0.5 * system.h * (start.state.w_WB + solution.velocities[i].w);
      linked.turn = 0.5 * system.h / (1 + 0.25 * x.squaredNorm()) *
                    (Matrix3d::Identity() + 0.5 * Cross(x));
    }
    const Velocity& now = solution.velocities[i];
    const Velocity& given = system.given[i];
    linked.dp = linked.mass * (now.v - given.v);
    linked.dL = linked.inertia * (now.w - given.w);
    linked.p_scale = linked.mass * (now.v.norm() + given.v.norm());
    linked.L_scale = (linked.inertia * now.w).norm() + (linked.inertia * given.w).norm();
  }
  double energy = 0;
  worst_error_ = 0;
  for (Link& link : links_) {
    const Anchor& A =
        link.is_spring ? system.springs[link.index].A : system.joints[link.index].A;
    const Anchor& B =
        link.is_spring ? system.springs[link.index].B : system.joints[link.index].B;
    const AnchorPoint a = LocateAnchor(A, solution.after);
    const AnchorPoint b = LocateAnchor(B, solution.after);
    link.d = b.p_W - a.p_W;
    link.r_A = a.r_W;
    link.r_B = b.r_W;
    link.d_mean = 0.5 * (link.d_start + link.d);
    const Vector3d& d_mean = link.d_mean;
    const double length = link.d.norm();
    const double size = a.p_W.norm() + b.p_W.norm() + length + link.length_start;
    double error = 0;  // [m]
    if (link.is_spring) {
      const Spring& spring = system.springs[link.index];
      const double sum = link.length_start + length;
      const double slope = -(0.5 * system.h * spring.stiffness + spring.damping);
      const double impulse =
          -system.h * spring.stiffness * (0.5 * sum - spring.rest_length) -
          spring.damping * (length - link.length_start);
      // μ = 2 s, s = impulse / sum.
      const double mu = sum == 0 ? 0 : 2 * impulse / sum;
      const double mu_slope = sum == 0 ? 0 : (2 * slope - mu) / sum;
      link.residual = mu - link.mu;
      link.compliance = 1;
      link.slope =
          length == 0 ? Vector3d::Zero().eval() : Vector3d(-mu_slope / length * link.d);
      error = link.residual * d_mean.norm();
      energy += 0.5 * link.inverse_effective_mass * error * error;
      worst_error_ = std::max(
          worst_error_, std::abs(error) / (kLengthTolerance * size * std::abs(slope) +
                                           kVelocityTolerance * std::abs(impulse) +
                                           std::numeric_limits<double>::min()));
    } else {
      // |d₁|² − |d₀|², without the rounding of squares.
      link.residual = -d_mean.dot(link.d - link.d_start);
      link.compliance = kCompliance * system.h * link.length_start * link.length_start *
                        link.inverse_effective_mass;
      link.slope = link.d;
      error = link.residual / link.length_start;
      const double speed = error / system.h;
      energy += 0.5 / link.inverse_effective_mass * speed * speed;
      worst_error_ = std::max(worst_error_, std::abs(error) / (kLengthTolerance * size));
    }
    const auto act = [&](int body, double mu, const Vector3d& r_mean) {
      LinkedBody* linked = Find(body);
      if (linked == nullptr) return;
      linked->dp -= mu * d_mean;
      linked->p_scale += std::abs(mu) * size;
      if (!linked->rotates) return;
      linked->dL -= mu * r_mean.cross(d_mean);
      linked->L_scale += std::abs(mu) * r_mean.norm() * size;
    };
    act(link.A, -link.mu, 0.5 * (link.r_A_start + link.r_A));
    act(link.B, link.mu, 0.5 * (link.r_B_start + link.r_B));
  }
  for (const LinkedBody& linked : linked_bodies_) {
    energy += 0.5 * linked.dp.squaredNorm() / linked.mass;
    worst_error_ =
        std::max(worst_error_, linked.dp.norm() / (kVelocityTolerance * linked.p_scale +
                                                   std::numeric_limits<double>::min()));
    if (!linked.rotates) continue;
    const InverseInertia& inverse =
        system.inertias[static_cast<std::size_t>(linked.body)];
    energy += 0.5 * linked.dL.dot(inverse.Times(linked.dL));
    worst_error_ =
        std::max(worst_error_, linked.dL.norm() / (kVelocityTolerance * linked.L_scale +
                                                   std::numeric_limits<double>::min()));
  }
  if (!std::isfinite(energy)) worst_error_ = std::numeric_limits<double>::infinity();
  return energy;
}

DirectJointSolver::LinkedBody* DirectJointSolver::Find(int body) {
  if (body < 0) return nullptr;
  const int place = linked_body_of_[static_cast<std::size_t>(body)];
  return place < 0 ? nullptr : &linked_bodies_[static_cast<std::size_t>(place)];
}

bool DirectJointSolver::FindChange(const System& system, Eigen::VectorXd& change) {
  const int size = unknowns_ + static_cast<int>(links_.size());
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd right = Eigen::VectorXd::Zero(size);
  const auto add = [&](int row, int column, const auto& block) {
    for (int i = 0; i < block.rows(); ++i) {
      for (int j = 0; j < block.cols(); ++j)
        entries.emplace_back(row + i, column + j, block(i, j));
    }
  };
  for (const LinkedBody& linked : linked_bodies_) {
    add(linked.first, linked.first, Matrix3d(linked.mass * Matrix3d::Identity()));
    right.segment<3>(linked.first) = -linked.dp;
    if (!linked.rotates) continue;
    add(linked.first + 3, linked.first + 3, linked.inertia);
    right.segment<3>(linked.first + 3) = -linked.dL;
  }
  for (std::size_t k = 0; k < links_.size(); ++k) {
    const Link& link = links_[k];
    const int row = unknowns_ + static_cast<int>(k);
    const Vector3d& d_mean = link.d_mean;
    struct End {
      LinkedBody* linked;
      double sign;
      Vector3d r_mean;
      double moved;  // The change of the centre by one of its velocity. [s]
      Matrix3d arm;  // The change of the lever arm by one of ω. [m s]
    };
    const auto end_at = [&](int body, double sign, const Vector3d& r_start,
                            const Vector3d& r) {
      const double fraction =
          body < 0 ? 0 : system.moved_fraction[static_cast<std::size_t>(body)];
      LinkedBody* linked = Find(body);
      const Vector3d r_mean = 0.5 * (r_start + r);
      const Matrix3d arm = linked == nullptr || !linked->rotates
                               ? Matrix3d::Zero().eval()
                               : Matrix3d(-Cross(r) * linked->turn);
      return End{linked, sign, r_mean, fraction * system.h, arm};
    };
    const std::array<End, 2> ends = {end_at(link.A, -1, link.r_A_start, link.r_A),
                                     end_at(link.B, 1, link.r_B_start, link.r_B)};
    entries.emplace_back(row, row, link.compliance);
    right[row] = link.residual;
    for (const End& on : ends) {
      if (on.linked == nullptr) continue;
      const int first = on.linked->first;
      // The impulse itself.
      add(first, row, Vector3d(-on.sign * d_mean));
      // The equation of the link, slope·δd.
      add(row, first, Eigen::RowVector3d(on.sign * on.moved * link.slope.transpose()));
      if (on.linked->rotates) {
        add(first + 3, row, Vector3d(-on.sign * on.r_mean.cross(d_mean)));
        add(row, first + 3,
            Eigen::RowVector3d(on.sign * link.slope.transpose() * on.arm));
        // The lever arm turns: −δr̄ × μ d̄ = ½ μ d̄ × δr.
        add(first + 3, first + 3,
            Matrix3d(on.sign * 0.5 * link.mu * Cross(d_mean) * on.arm));
      }
      // The direction turns: δd̄ = ½ δd, by the motion of both ends.
      for (const End& of : ends) {
        if (of.linked == nullptr) continue;
        const double factor = -on.sign * 0.5 * link.mu * of.sign;
        const int column = of.linked->first;
        add(first, column, Matrix3d(factor * of.moved * Matrix3d::Identity()));
        if (of.linked->rotates) add(first, column + 3, Matrix3d(factor * of.arm));
        if (!on.linked->rotates) continue;
        add(first + 3, column, Matrix3d(factor * of.moved * Cross(on.r_mean)));
        if (of.linked->rotates)
          add(first + 3, column + 3, Matrix3d(factor * Cross(on.r_mean) * of.arm));
      }
    }
  }
  Eigen::SparseMatrix<double> matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  Eigen::SparseLU<Eigen::SparseMatrix<double>> lu(matrix);
  if (lu.info() != Eigen::Success) return false;
  change = lu.solve(right);
  return change.allFinite();
}

void DirectJointSolver::Add(const Eigen::VectorXd& change, double fraction,
                            const Solution& solution) {
  for (const LinkedBody& linked : linked_bodies_) {
    Velocity& velocity = solution.velocities[static_cast<std::size_t>(linked.body)];
    velocity.v += fraction * change.segment<3>(linked.first);
    if (linked.rotates) velocity.w += fraction * change.segment<3>(linked.first + 3);
  }
  for (std::size_t k = 0; k < links_.size(); ++k)
    links_[k].mu += fraction * change[unknowns_ + static_cast<int>(k)];
}

void DirectJointSolver::ApplyImpulses(const System& system,
                                      const Solution& solution) const {
  for (const LinkedBody& linked : linked_bodies_) {
    const auto i = static_cast<std::size_t>(linked.body);
    solution.velocities[i] = system.given[i];
  }
  for (const Link& link : links_) {
    const AxialConstraint axis{link.A, link.B, link.d_mean,
                               0.5 * (link.r_A_start + link.r_A),
                               0.5 * (link.r_B_start + link.r_B)};
    axis.ApplyImpulse(link.mu, system.inertias, solution.velocities);
    if (!link.is_spring) solution.joint_impulses[link.index] = link.mu * axis.n.norm();
  }
}

bool DirectJointSolver::Solve(const System& system, const Solution& solution,
                              const std::function<void()>& integrate) {
  CollectLinks(system, solution.joint_impulses);
  CollectBodies(system);
  Eigen::VectorXd change;
  integrate();
  double energy = UpdateResiduals(system, solution);
  bool stagnates = false;
  for (int k = 0; k < kMaxIterations; ++k) {
    if (worst_error_ <= 1 || (stagnates && worst_error_ <= kStagnation)) {
      ApplyImpulses(system, solution);
      integrate();
      return true;
    }
    if (stagnates || !FindChange(system, change)) return false;
    const double before = energy;
    double applied = 0;
    for (double fraction = 1;; fraction *= 0.5) {
      Add(change, fraction - applied, solution);
      applied = fraction;
      integrate();
      energy = UpdateResiduals(system, solution);
      if (energy < before || fraction <= kLeastFraction) break;
    }
    stagnates = !(energy < before);
  }
  return false;
}

}  // namespace cookbook
