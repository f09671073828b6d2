#include "engine/dynamics/solver/static_equilibrium.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <Eigen/Dense>

#include "engine/dynamics/body/rotation.h"

namespace cookbook {
namespace {

/** Some roundings, as a fraction of the load. */
constexpr double kRounding = 1e-15;

/** A contact counts as closed if its gap closes in a step with less than this fraction of
 the speed that the loads add. Such gaps come from rounding far from the origin, or are
 some nanometres. Later iterations close them. */
constexpr double kBearingFraction = 1e-3;

std::size_t At(int body) {
  return static_cast<std::size_t>(body);
}

/** A pair as seen from one of its bodies. */
struct Side {
  bool is_B;
  int body;
  int other;
  bool other_moves;
};

Side SideOf(const ConstraintBatch<double>& batch, std::size_t lane, int body) {
  const bool is_B = batch.B[lane] == body;
  return {is_B, body, is_B ? batch.A[lane] : batch.B[lane],
          (is_B ? batch.inverse_mass_A : batch.inverse_mass_B)[lane] != 0};
}

Eigen::Vector3d VectorAt(const VectorLanes<double>& lanes, std::size_t lane) {
  return {lanes[0][lane], lanes[1][lane], lanes[2][lane]};
}

/** The contacts of a pair in the frame of n, t1 and t2, relative to the centroid of the
 contacts that can bear load. */
struct ContactPatch {
  Eigen::Matrix3d axes_W;      ///< Columns n, t1, t2.
  Eigen::Vector3d centroid_W;  ///< From the centre of the supported body. [m]
  double friction = 0;
  std::size_t count = 0;  ///< Number of contacts, also of those that bear no load.
  std::array<bool, 8> bears_load{};
  std::array<Eigen::Vector3d, 8> r;  ///< Positions; valid where `bears_load`. [m]
};

/** Returns the contact patch of a pair, or nothing if a contact has to separate, or if
 fewer than three contacts can bear load. `is_B`: whether B is the supported body. */
std::optional<ContactPatch> FindPatch(const ConstraintView<double>& constraints,
                                      const ConstraintBatch<double>& batch,
                                      std::size_t lane, bool is_B) {
  ContactPatch patch;
  patch.axes_W << VectorAt(batch.n, lane), VectorAt(batch.t1, lane),
      VectorAt(batch.t2, lane);
  patch.friction = batch.friction[lane];
  patch.count = static_cast<std::size_t>(batch.count);
  patch.centroid_W.setZero();
  int bearing = 0;
  for (std::size_t k = 0; k < patch.count; ++k) {
    const std::size_t index = static_cast<std::size_t>(batch.first) + k;
    const ContactConstraintLanes<double>& contact = constraints.contacts[index];
    if (constraints.cold[index].used[lane] == 0) continue;
    if (contact.target[lane] > 0) return std::nullopt;
    // An open contact bears no load at rest.
    if (contact.target[lane] < -kBearingFraction * batch.load_speed[lane]) continue;
    patch.bears_load[k] = true;
    patch.r[k] = VectorAt(is_B ? contact.r_B : contact.r_A, lane);
    patch.centroid_W += patch.r[k];
    ++bearing;
  }
  if (bearing < 3) return std::nullopt;
  patch.centroid_W /= bearing;
  for (std::size_t k = 0; k < patch.count; ++k) {
    if (!patch.bears_load[k]) continue;
    patch.r[k] = patch.axes_W.transpose() * (patch.r[k] - patch.centroid_W);
  }
  return patch;
}

/** Distributes an impulse and its moment about the centroid, along n, t1 and t2, over the
 contacts of a patch, as a rigid body on a uniform elastic foundation does. */
class ElasticFoundation {
 public:
  explicit ElasticFoundation(const ContactPatch& patch) : patch_(patch) {
    for (std::size_t k = 0; k < patch.count; ++k) {
      if (!patch.bears_load[k]) continue;
      count_ += 1;
      const Eigen::Vector2d arm = patch.r[k].tail<2>();
      second_moment_ += arm * arm.transpose();
    }
  }

  /** Whether the contacts are not on one line, to some roundings. */
  bool IsWide() const {
    return second_moment_.determinant() >
           1e-12 * second_moment_.trace() * second_moment_.trace();
  }

  /** Root mean square distance of the contacts from the centroid. [m] */
  double width() const { return std::sqrt(second_moment_.trace() / count_); }

  /** Adds to `impulses` a distribution with the sum `linear` [N s] and the moment
   `angular` [N m s]. It is exact if the contacts are in one plane. */
  void AddTo(const Eigen::Vector3d& linear, const Eigen::Vector3d& angular,
             std::array<Eigen::Vector3d, 8>& impulses) const {
    // The moment of the normal impulses a + b·r is (Σ r rᵀ) b, rotated by 90° about n.
    const Eigen::Vector2d slope =
        second_moment_.inverse() * Eigen::Vector2d(-angular[2], angular[1]);
    double load = 0;
    Eigen::Vector2d centre(0, 0);
    ForEach([&](std::size_t k, const Eigen::Vector2d& arm) {
      impulses[k][0] += linear[0] / count_ + slope.dot(arm);
      load += impulses[k][0];
      centre += impulses[k][0] * arm;
    });
    if (!(load > 0)) return;
    centre /= load;
    // Take the moment about the centre of the load, which decouples it from the sum.
    const double turn = angular[0] - (centre[0] * linear[2] - centre[1] * linear[1]);
    double polar = 0;
    ForEach([&](std::size_t k, const Eigen::Vector2d& arm) {
      polar += impulses[k][0] * (arm - centre).squaredNorm();
    });
    const double spin = polar > 0 ? turn / polar : 0;
    ForEach([&](std::size_t k, const Eigen::Vector2d& arm) {
      const Eigen::Vector2d out = arm - centre;
      impulses[k][1] += impulses[k][0] * (linear[1] / load - spin * out[1]);
      impulses[k][2] += impulses[k][0] * (linear[2] / load + spin * out[0]);
    });
  }

  /** Subtracts the sum and the moment of `impulses`. */
  void Subtract(const std::array<Eigen::Vector3d, 8>& impulses, Eigen::Vector3d& linear,
                Eigen::Vector3d& angular) const {
    ForEach([&](std::size_t k, const Eigen::Vector2d&) {
      linear -= impulses[k];
      angular -= patch_.r[k].cross(impulses[k]);
    });
  }

  /** Clamps impulses that violate λ >= 0 or the friction cone. Returns false if a
   violation is more than rounding. Without this, whether a contact at its bound holds
   would depend on the orientation of the world. */
  bool Clamp(std::array<Eigen::Vector3d, 8>& impulses) const {
    double load = 0;
    ForEach([&](std::size_t k, const Eigen::Vector2d&) { load += impulses[k][0]; });
    const double rounding = kRounding * load;
    bool holds = true;
    ForEach([&](std::size_t k, const Eigen::Vector2d&) {
      holds = holds && impulses[k][0] >= -rounding;
      impulses[k][0] = std::max(0.0, impulses[k][0]);
      const double bound = patch_.friction * impulses[k][0];
      const double held = impulses[k].tail<2>().norm();
      holds = holds && held <= bound + rounding;
      if (held > bound) impulses[k].tail<2>() *= bound / held;
    });
    return holds;
  }

 private:
  template <class Visit>
  void ForEach(const Visit& visit) const {
    for (std::size_t k = 0; k < patch_.count; ++k) {
      if (patch_.bears_load[k]) visit(k, Eigen::Vector2d(patch_.r[k].tail<2>()));
    }
  }

  const ContactPatch& patch_;
  double count_ = 0;
  Eigen::Matrix2d second_moment_ = Eigen::Matrix2d::Zero();
};

/** Finds impulses of the contacts of `patch` with the sum `linear` along n, t1 and t2,
 and the moment `angular` about the centroid. Returns false if a contact would have to
 pull or to exceed its friction, or if the contacts are on one line. */
bool DistributeImpulse(const ContactPatch& patch, const Eigen::Vector3d& linear,
                       const Eigen::Vector3d& angular,
                       std::array<Eigen::Vector3d, 8>& impulses) {
  // A round reduces the residual by about the ratio of the patch's height to its width.
  constexpr int kRounds = 4;
  const ElasticFoundation foundation(patch);
  if (!foundation.IsWide()) return false;
  impulses.fill(Eigen::Vector3d::Zero());
  Eigen::Vector3d linear_residual = linear;
  Eigen::Vector3d angular_residual = angular;
  for (int round = 0; round < kRounds; ++round) {
    foundation.AddTo(linear_residual, angular_residual, impulses);
    linear_residual = linear;
    angular_residual = angular;
    foundation.Subtract(impulses, linear_residual, angular_residual);
  }
  if (!foundation.Clamp(impulses)) return false;
  linear_residual = linear;
  angular_residual = angular;
  foundation.Subtract(impulses, linear_residual, angular_residual);
  // Clamp() may have moved each of eight impulses by that many roundings.
  const double tolerance = 16 * kRounding * linear.norm();
  return linear_residual.norm() <= tolerance &&
         angular_residual.norm() <= foundation.width() * tolerance;
}

}  // namespace

void StaticEquilibrium::Solve(const ConstraintView<double>& constraints,
                              std::span<const int> islands, double solved,
                              const SolverBodies& bodies,
                              std::span<Velocity> velocities) {
  if (!FindTrees(constraints, islands, solved)) return;
  RemoveLeaves(constraints, islands, bodies);
  for (const SupportingPair& support : supports_) {
    if (!islands_[At(support.island)].may_rest) continue;
    const auto& [batch_index, lane] = support.position;
    const ConstraintBatch<double>& batch = constraints.batches[batch_index];
    for (std::size_t k = 0; k < static_cast<std::size_t>(batch.count); ++k) {
      const std::size_t index = static_cast<std::size_t>(batch.first) + k;
      ContactConstraintLanes<double>& contact = constraints.contacts[index];
      contact.impulse[lane] = support.impulses[k][0];
      contact.friction_impulse1[lane] = support.impulses[k][1];
      contact.friction_impulse2[lane] = support.impulses[k][2];
    }
    if (batch.inverse_mass_A[lane] != 0) velocities[At(batch.A[lane])] = {};
    if (batch.inverse_mass_B[lane] != 0) velocities[At(batch.B[lane])] = {};
  }
}

bool StaticEquilibrium::FindTrees(const ConstraintView<double>& constraints,
                                  std::span<const int> islands, double solved) {
  edges_.clear();
  islands_.assign(islands.size(), {});
  nodes_.assign(islands.size(), {});
  for (std::size_t index = 0; index < constraints.batches.size(); ++index) {
    const ConstraintBatch<double>& batch = constraints.batches[index];
    for (std::size_t lane = 0; lane < kLanes<double>; ++lane) {
      if (batch.pair[lane] < 0) continue;
      const auto join = [&](int body, double inverse_mass) {
        if (inverse_mass == 0) return;
        Node& node = nodes_[At(body)];
        if (node.degree++ == 0) ++islands_[At(islands[At(body)])].bodies;
        node.edges_xor ^= edges_.size();
      };
      join(batch.A[lane], batch.inverse_mass_A[lane]);
      join(batch.B[lane], batch.inverse_mass_B[lane]);
      const int moving = batch.inverse_mass_A[lane] != 0 ? batch.A[lane] : batch.B[lane];
      Island& island = islands_[At(islands[At(moving)])];
      ++island.pairs;
      island.max_change = std::max(island.max_change, batch.max_change[lane]);
      edges_.push_back({index, lane});
    }
  }
  // A tree has one pair less than bodies. One more pair connects it to a static body.
  bool any = false;
  for (Island& island : islands_) {
    island.may_rest =
        island.pairs > 0 && island.pairs == island.bodies && island.max_change > solved;
    any = any || island.may_rest;
  }
  return any;
}

void StaticEquilibrium::RemoveLeaves(const ConstraintView<double>& constraints,
                                     std::span<const int> islands,
                                     const SolverBodies& bodies) {
  required_.resize(islands.size());
  supports_.clear();
  leaves_.clear();
  const auto island_of = [&](int body) -> Island& {
    return islands_[At(islands[At(body)])];
  };
  for (std::size_t i = 0; i < islands.size(); ++i) {
    const int body = static_cast<int>(i);
    if (nodes_[i].degree == 0 || !island_of(body).may_rest) continue;
    const RigidBody& moving = bodies.rigid_bodies[i];
    const Velocity& velocity = bodies.velocities[i];
    required_[i] = {velocity.v / -moving.inverse_mass,
                    -WorldInertiaTimes(moving.R_WB, moving.moments, velocity.w)};
    if (nodes_[i].degree == 1) leaves_.push_back(body);
  }
  while (!leaves_.empty()) {
    const int body = leaves_.back();
    leaves_.pop_back();
    const std::size_t edge = nodes_[At(body)].edges_xor;
    nodes_[At(body)].degree = 0;
    const PairPosition position = edges_[edge];
    const ConstraintBatch<double>& batch = constraints.batches[position.batch];
    const Side side = SideOf(batch, position.lane, body);
    Island& island = island_of(body);
    --island.bodies;
    if (side.other_moves) {
      // The body below has to support this one, too.
      const SpatialImpulse& required = required_[At(body)];
      SpatialImpulse& required_below = required_[At(side.other)];
      const Eigen::Vector3d arm = bodies.rigid_bodies[At(body)].state.p_WB -
                                  bodies.rigid_bodies[At(side.other)].state.p_WB;
      required_below.linear += required.linear;
      required_below.angular += required.angular + arm.cross(required.linear);
      Node& node = nodes_[At(side.other)];
      node.edges_xor ^= edge;
      if (--node.degree == 1) leaves_.push_back(side.other);
    }
    if (!island.may_rest) continue;
    const std::optional<ContactPatch> patch =
        FindPatch(constraints, batch, position.lane, side.is_B);
    if (!patch) {
      island.may_rest = false;
      continue;
    }
    // The required impulse as one on B.
    const double sign = side.is_B ? 1 : -1;
    const SpatialImpulse total{sign * required_[At(body)].linear,
                               sign * required_[At(body)].angular};
    SupportingPair& support = supports_.emplace_back();
    support.position = position;
    support.island = islands[At(body)];
    island.may_rest =
        DistributeImpulse(*patch, patch->axes_W.transpose() * total.linear,
                          patch->axes_W.transpose() *
                              (total.angular - patch->centroid_W.cross(total.linear)),
                          support.impulses);
  }
  // Bodies of a cycle are still there.
  for (Island& island : islands_) island.may_rest = island.may_rest && island.bodies == 0;
}

}  // namespace cookbook
