#include "engine/dynamics/contact_solver.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/LU>

namespace cookbook {
namespace {

/** A contact that approaches slower than this share of what gravity adds in a step is one
 that was there all along. */
constexpr double kSteady = 1.0 / 16;

void Apply(const Eigen::Vector3d& J, const Eigen::Vector3d& r,
           const InverseInertia& inertia, Velocity& velocity) {
  velocity.v += inertia.mass * J;
  velocity.w += inertia.tensor_W * r.cross(J);
}

/** Response of the relative velocity along `d` to a unit impulse along `c`. */
double Response(const Eigen::Vector3d& d, const Eigen::Vector3d& c,
                const Eigen::Vector3d& r_A, const InverseInertia& A,
                const Eigen::Vector3d& r_B, const InverseInertia& B) {
  return (A.mass + B.mass) * d.dot(c) + r_A.cross(d).dot(A.tensor_W * r_A.cross(c)) +
         r_B.cross(d).dot(B.tensor_W * r_B.cross(c));
}

}  // namespace

void ContactSolver::Begin(std::span<ContactPair> pairs, const SolverBodies& world,
                          const Settings& settings, double h) {
  rows_.clear();
  row_count_ = 0;
  scale_ = 0;
  inertias_ = world.inertias;
  accumulated_ = settings.accumulated_impulses;
  const double gravity_speed = h * settings.gravity_W.norm();
  const double slack = SlackOf(settings, h);

  for (std::size_t p = 0; p < pairs.size(); ++p) {
    const ContactPair& pair = pairs[p];
    if (pair.manifold.count == 0) continue;
    const auto a = static_cast<std::size_t>(pair.A);
    const auto b = static_cast<std::size_t>(pair.B);
    const RigidBody& A = world.bodies[a];
    const RigidBody& B = world.bodies[b];
    const InverseInertia& M_A = world.inertias[a];
    const InverseInertia& M_B = world.inertias[b];
    Rows& rows = rows_.emplace_back();
    rows.pair = p;
    rows.A = pair.A;
    rows.B = pair.B;
    rows.n = pair.manifold.n_AB_W;
    rows.t1 = rows.n.unitOrthogonal();
    rows.t2 = rows.n.cross(rows.t1);
    rows.friction = std::sqrt(A.friction * B.friction);
    rows.count = pair.manifold.count;
    row_count_ += rows.count;
    const double restitution = std::min(A.restitution, B.restitution);
    for (int i = 0; i < rows.count; ++i) {
      const ContactPoint& contact = pair.manifold.contacts[static_cast<std::size_t>(i)];
      Row& row = rows.rows[static_cast<std::size_t>(i)];
      row.r_A = contact.p_WC - A.state.p_WB;
      row.r_B = contact.p_WC - B.state.p_WB;
      const Eigen::Vector3d u_before = B.state.v_WB + B.state.w_WB.cross(row.r_B) -
                                       A.state.v_WB - A.state.w_WB.cross(row.r_A);
      const Eigen::Vector3d u_free =
          world.velocities[b].At(row.r_B) - world.velocities[a].At(row.r_A);
      const double approach = u_before.dot(rows.n);
      const double pull = u_free.dot(rows.n) - approach;
      scale_ = std::max({scale_, u_before.norm(), u_free.norm()});

      row.target = 0;
      if (approach < -settings.resting_speed * (gravity_speed + std::abs(pull))) {
        row.target = std::max(0.0, -restitution * approach + pull);
      }
      row.bounces = row.target > 0;
      row.steady = std::abs(approach) <= kSteady * (gravity_speed + std::abs(pull));
      if (contact.separation > 0) {
        // Not there yet: what will bounce goes on, what will rest arrives with the step.
        row.target = row.bounces ? -std::numeric_limits<double>::infinity()
                                 : -contact.separation / h;
        row.bounces = false;
      }
      row.mass_scale = 1;
      row.impulse_scale = 0;
      const double excess = -contact.separation - slack;
      if (!row.bounces && excess > 0) {
        if (settings.stabilisation == Stabilisation::kBaumgarte) {
          row.target = settings.projection_share * excess / h;
        } else if (settings.stabilisation == Stabilisation::kSoft) {
          // A damped spring stepped implicitly (Catto 2011): ω = 2π f, damping ratio ζ.
          const double omega =
              2 * std::numbers::pi * std::min(settings.soft_frequency, 0.125 / h);
          const double a1 = 2 * settings.soft_damping_ratio + h * omega;
          const double a2 = h * omega * a1;
          const double a3 = 1 / (1 + a2);
          row.target = omega / a1 * excess;
          row.mass_scale = a2 * a3;
          row.impulse_scale = a3;
        }
      }

      const auto respond = [&](const Eigen::Vector3d& d, const Eigen::Vector3d& c) {
        return Response(d, c, row.r_A, M_A, row.r_B, M_B);
      };
      row.effective_mass = 1 / respond(rows.n, rows.n);
      const double k11 = respond(rows.t1, rows.t1);
      const double k12 = respond(rows.t1, rows.t2);
      const double k22 = respond(rows.t2, rows.t2);
      row.K_t << k11, k12, k12, k22;
      row.inverse_K_t = row.K_t.inverse();
      row.slip_step = 2 / (k11 + k22 + std::hypot(k11 - k22, 2 * k12));

      row.impulse = 0;
      row.friction_impulse.setZero();
      if (!settings.warm_starting) continue;
      const Eigen::Vector3d& J = pair.J_W[static_cast<std::size_t>(i)];
      row.impulse = std::max(0.0, J.dot(rows.n));
      row.friction_impulse = {J.dot(rows.t1), J.dot(rows.t2)};
    }
  }
  // All rows have seen the velocities without impulses: now apply those to start from.
  for (const Rows& rows : rows_) {
    const auto a = static_cast<std::size_t>(rows.A);
    const auto b = static_cast<std::size_t>(rows.B);
    for (int i = 0; i < rows.count; ++i) {
      const Row& row = rows.rows[static_cast<std::size_t>(i)];
      const Eigen::Vector3d J = row.impulse * rows.n + row.friction_impulse[0] * rows.t1 +
                                row.friction_impulse[1] * rows.t2;
      Apply(-J, row.r_A, inertias_[a], world.velocities[a]);
      Apply(J, row.r_B, inertias_[b], world.velocities[b]);
    }
  }
}

double ContactSolver::Solve(const Rows& rows, Row& row, Velocity& A, Velocity& B) const {
  const InverseInertia& M_A = inertias_[static_cast<std::size_t>(rows.A)];
  const InverseInertia& M_B = inertias_[static_cast<std::size_t>(rows.B)];

  const Eigen::Vector3d u = B.At(row.r_B) - A.At(row.r_A);
  const double start = accumulated_ ? row.impulse : 0;
  const double wanted =
      start + row.mass_scale * row.effective_mass * (row.target - u.dot(rows.n)) -
      row.impulse_scale * row.impulse;
  const double impulse = std::max(0.0, wanted);
  const double change = impulse - start;
  row.impulse += change;
  Apply(-change * rows.n, row.r_A, M_A, A);
  Apply(change * rows.n, row.r_B, M_B, B);

  const Eigen::Vector3d u_after = B.At(row.r_B) - A.At(row.r_A);
  const Eigen::Vector2d slip(u_after.dot(rows.t1), u_after.dot(rows.t2));
  const double bound =
      rows.friction * (accumulated_ ? row.impulse : std::max(0.0, change));
  const Eigen::Vector2d held =
      accumulated_ ? row.friction_impulse : Eigen::Vector2d(0, 0);
  // Inside the cone the impulse that stops the slip. Else a step against the slip,
  // brought back to the cone: where that stands still, the impulse is against the slip.
  Eigen::Vector2d friction = held - row.inverse_K_t * slip;
  if (friction.squaredNorm() > bound * bound) {
    friction = held - row.slip_step * slip;
    const double length = friction.norm();
    if (length > bound) friction *= bound / length;
  }
  const Eigen::Vector2d friction_change = friction - held;
  row.friction_impulse += friction_change;
  const Eigen::Vector3d J_t = friction_change[0] * rows.t1 + friction_change[1] * rows.t2;
  Apply(-J_t, row.r_A, M_A, A);
  Apply(J_t, row.r_B, M_B, B);

  return std::max(std::abs(change) / row.effective_mass,
                  friction_change.norm() / row.slip_step);
}

double ContactSolver::Sweep(std::span<Velocity> velocities) {
  double greatest = 0;
  for (Rows& rows : rows_) {
    Velocity& A = velocities[static_cast<std::size_t>(rows.A)];
    Velocity& B = velocities[static_cast<std::size_t>(rows.B)];
    for (int i = 0; i < rows.count; ++i) {
      greatest =
          std::max(greatest, Solve(rows, rows.rows[static_cast<std::size_t>(i)], A, B));
    }
  }
  return greatest;
}

void ContactSolver::End(std::span<ContactPair> pairs, std::span<Touch> touches) const {
  for (const Rows& rows : rows_) {
    ContactPair& pair = pairs[rows.pair];
    for (int i = 0; i < rows.count; ++i) {
      const Row& row = rows.rows[static_cast<std::size_t>(i)];
      pair.J_W[static_cast<std::size_t>(i)] = row.impulse * rows.n +
                                              row.friction_impulse[0] * rows.t1 +
                                              row.friction_impulse[1] * rows.t2;
      if (row.impulse == 0) continue;
      for (const int body : {rows.A, rows.B}) {
        Touch& touch = touches[static_cast<std::size_t>(body)];
        touch.bounced = touch.bounced || row.bounces;
        touch.rested = touch.rested || !row.bounces;
        touch.steady = touch.steady && row.steady;
      }
    }
  }
}

}  // namespace cookbook
