#include "engine/dynamics/world/linkage_impact.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "engine/dynamics/solver/restitution_limit.h"

namespace cookbook {
namespace {

/** Error of the work of an impulse, as a fraction of its greatest term: rounding. */
constexpr double kRounding = 1e-13;

}  // namespace

void LinkageImpact::CollectContacts(const Island& island, const StepContext& step) {
  contacts_.clear();
  for (std::size_t p = 0; p < island.pairs.size(); ++p) {
    const ContactPair& pair = island.pairs[p];
    const RigidBody& A = island.bodies[static_cast<std::size_t>(pair.A)];
    const RigidBody& B = island.bodies[static_cast<std::size_t>(pair.B)];
    for (std::size_t k = 0; k < pair.manifold.points().size(); ++k) {
      Contact& contact = contacts_.emplace_back();
      contact.pair = p;
      contact.point = k;
      contact.A = pair.A;
      contact.B = pair.B;
      contact.axes_W.col(0) = pair.manifold.n_AB_W;
      contact.axes_W.col(1) = pair.manifold.n_AB_W.unitOrthogonal();
      contact.axes_W.col(2) = contact.axes_W.col(0).cross(contact.axes_W.col(1));
      contact.r_A = pair.manifold.contacts[k].p_WC - A.state.p_WB;
      contact.r_B = pair.manifold.contacts[k].p_WC - B.state.p_WB;
      contact.u_before = RelativeVelocity(contact, before_);
      contact.restitution = std::min(A.restitution, B.restitution);
      contact.friction = std::sqrt(A.friction * B.friction);
      contact.threshold = step.settings.restitution_threshold_factor * step.h *
                          LoadAccelerationOn(pair, A, B);
    }
  }
  std::vector<Velocity> unit(before_.size());
  for (Contact& contact : contacts_) {
    for (int axis = 0; axis < 3; ++axis) {
      std::fill(unit.begin(), unit.end(), Velocity{});
      Apply(contact, Eigen::Vector3d::Unit(axis), unit);
      contact.response.col(axis) = RelativeVelocity(contact, unit);
    }
  }
}

Eigen::Vector3d LinkageImpact::RelativeVelocity(
    const Contact& contact, std::span<const Velocity> velocities) const {
  const Velocity& A = velocities[static_cast<std::size_t>(contact.A)];
  const Velocity& B = velocities[static_cast<std::size_t>(contact.B)];
  return contact.axes_W.transpose() * (B.At(contact.r_B) - A.At(contact.r_A));
}

void LinkageImpact::Apply(const Contact& contact, const Eigen::Vector3d& impulse,
                          std::span<Velocity> velocities) {
  const Eigen::Vector3d J_W = contact.axes_W * impulse;
  const auto apply = [&](int body, const Eigen::Vector3d& J, const Eigen::Vector3d& r) {
    const InverseInertia& inertia = inertias_[static_cast<std::size_t>(body)];
    Velocity& velocity = velocities[static_cast<std::size_t>(body)];
    velocity.v += inertia.mass * J;
    velocity.w += inertia.Times(r.cross(J));
  };
  apply(contact.A, -J_W, contact.r_A);
  apply(contact.B, J_W, contact.r_B);
  rods_.Project(velocities);
}

Eigen::Vector3d LinkageImpact::ChangeOf(const Contact& contact, double target,
                                        const Eigen::Vector3d& u) {
  const Eigen::Matrix3d& response = contact.response;
  if (!(response(0, 0) > 0)) return Eigen::Vector3d::Zero();
  const double normal =
      std::max(0.0, contact.impulse[0] + (target - u[0]) / response(0, 0));
  Eigen::Vector3d change(normal - contact.impulse[0], 0, 0);
  // Slip after the normal impulse. Inside the cone friction stops it; else it is a step
  // against it, projected onto the cone.
  const Eigen::Vector2d slip = (u + change[0] * response.col(0)).tail<2>();
  const Eigen::Matrix2d K = response.bottomRightCorner<2, 2>();
  const double bound = contact.friction * normal;
  const Eigen::Vector2d old = contact.impulse.tail<2>();
  const double determinant = K.determinant();
  Eigen::Vector2d friction = old;
  if (determinant > 0) friction = old - K.inverse() * slip;
  if (!(determinant > 0) || friction.norm() > bound) {
    const double difference = K(0, 0) - K(1, 1);
    const double greatest =
        (K.trace() + std::sqrt(difference * difference + 4 * K(0, 1) * K(1, 0))) / 2;
    if (greatest > 0) friction = old - slip / greatest;
    if (friction.norm() > bound) friction *= bound / friction.norm();
  }
  change.tail<2>() = friction - old;
  return change;
}

LinkageImpact::Solution LinkageImpact::SolveContacts(double restitution_factor,
                                                     const StepContext& step) {
  const Settings& settings = step.settings;
  Solution solution{{}, before_};
  double max_speed = 0;
  for (Contact& contact : contacts_) {
    contact.impulse.setZero();
    max_speed = std::max(max_speed, contact.u_before.norm());
  }
  const int count = static_cast<int>(contacts_.size());
  const int iterations =
      std::max(settings.impulse_iterations, settings.iteration_budget / count);
  for (int k = 0; k < iterations; ++k) {
    double greatest = 0;
    for (Contact& contact : contacts_) {
      const double e = restitution_factor * contact.restitution;
      const double before = contact.u_before[0];
      // The targets of ContactSolver, without loads.
      const bool bounces = before < -contact.threshold || e * before > contact.threshold;
      const double target = bounces ? -e * before : std::min(0.0, -e * before);
      const Eigen::Vector3d change =
          ChangeOf(contact, target, RelativeVelocity(contact, solution.velocities));
      contact.impulse += change;
      Apply(contact, change, solution.velocities);
      greatest = std::max(greatest, (contact.response * change).norm());
    }
    if (greatest <= settings.residual * max_speed) break;
  }
  // The sum of the impulses has less rounding error than that of their changes.
  solution.velocities = before_;
  for (const Contact& contact : contacts_) {
    solution.impulses.push_back(contact.impulse);
    Apply(contact, contact.impulse, solution.velocities);
  }
  return solution;
}

double LinkageImpact::WorkOf(const Solution& solution) const {
  double work = 0;
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    const Eigen::Vector3d after = RelativeVelocity(contacts_[k], solution.velocities);
    work += solution.impulses[k].dot(contacts_[k].u_before + after) / 2;
  }
  return work;
}

double LinkageImpact::RoundingOf(const Solution& solution) const {
  double size = 0;
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    const Eigen::Vector3d after = RelativeVelocity(contacts_[k], solution.velocities);
    size += solution.impulses[k].norm() * (contacts_[k].u_before.norm() + after.norm());
  }
  return kRounding * size;
}

LinkageImpact::Solution LinkageImpact::Mean(double s, const Solution& a,
                                            const Solution& b) {
  Solution mean = a;
  for (std::size_t k = 0; k < a.impulses.size(); ++k)
    mean.impulses[k] = (1 - s) * a.impulses[k] + s * b.impulses[k];
  for (std::size_t i = 0; i < a.velocities.size(); ++i) {
    mean.velocities[i].v = (1 - s) * a.velocities[i].v + s * b.velocities[i].v;
    mean.velocities[i].w = (1 - s) * a.velocities[i].w + s * b.velocities[i].w;
  }
  return mean;
}

void LinkageImpact::Solve(const Island& island, const StepContext& step,
                          std::span<Velocity> velocities,
                          std::vector<ContactPair>& impact_contacts) {
  inertias_ = island.inertias;
  rods_.Begin(island.joints, island.bodies, island.inertias);
  rods_.Project(velocities);
  before_.assign(velocities.begin(), velocities.end());
  CollectContacts(island, step);
  if (contacts_.empty()) return;
  Solution solution = SolveContacts(1, step);
  const double gain = WorkOf(solution);
  if (gain > RoundingOf(solution)) {
    const Solution inelastic = SolveContacts(0, step);
    double curvature = 0;
    for (std::size_t k = 0; k < contacts_.size(); ++k) {
      const Eigen::Vector3d change =
          RelativeVelocity(contacts_[k], inelastic.velocities) -
          RelativeVelocity(contacts_[k], solution.velocities);
      curvature += (inelastic.impulses[k] - solution.impulses[k]).dot(change) / 2;
    }
    const double s = FractionWithoutGain(gain, WorkOf(inelastic), curvature);
    solution = Mean(s, solution, inelastic);
  }
  const double rest = WorkOf(solution);
  if (rest > RoundingOf(solution)) {
    // The energy of k J is k (J·u₀) + k² (rest − J·u₀).
    double approach = 0;
    for (std::size_t k = 0; k < contacts_.size(); ++k)
      approach += solution.impulses[k].dot(contacts_[k].u_before);
    const Solution none{
        std::vector<Eigen::Vector3d>(contacts_.size(), Eigen::Vector3d::Zero()), before_};
    const double k = approach < 0 ? -approach / (rest - approach) : 0;
    solution = Mean(1 - k, solution, none);
  }
  std::copy(solution.velocities.begin(), solution.velocities.end(), velocities.begin());
  std::vector<ContactPair> pairs(island.pairs.begin(), island.pairs.end());
  for (ContactPair& pair : pairs) pair.J_W.fill(Eigen::Vector3d::Zero());
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    const Contact& contact = contacts_[k];
    pairs[contact.pair].J_W[contact.point] = contact.axes_W * solution.impulses[k];
  }
  for (const ContactPair& pair : pairs) {
    const auto acts = [](const Eigen::Vector3d& J) { return !J.isZero(0); };
    const auto end = pair.J_W.begin() + pair.manifold.points().size();
    if (std::any_of(pair.J_W.begin(), end, acts)) impact_contacts.push_back(pair);
  }
}

}  // namespace cookbook
