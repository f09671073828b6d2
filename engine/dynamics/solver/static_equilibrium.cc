#include "engine/dynamics/solver/static_equilibrium.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <Eigen/Dense>

#include "engine/dynamics/body/rotation.h"

namespace cookbook {
namespace {

/** Some roundings, as a share of what is borne. */
constexpr double kNothing = 1e-15;

/** What is apart by so little that it arrives with less than this share of what gravity
 adds in a step bears as if it were there: by rounding, far from the origin, or by some
 nanometres. Sweeps let it come. */
constexpr double kArrives = 1e-3;

std::size_t At(int body) {
  return static_cast<std::size_t>(body);
}

/** One of the two bodies of a pair. */
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

/** The contacts of a pair, seen along n, t1 and t2 from the middle of those that can
 bear something. */
struct Patch {
  Eigen::Matrix3d axes_W;    ///< Columns n, t1, t2.
  Eigen::Vector3d middle_W;  ///< From the centre of the body that stands on it. [m]
  double friction = 0;
  std::size_t count = 0;  ///< Of all contacts.
  std::array<bool, 8> bears{};
  std::array<Eigen::Vector3d, 8> r;  ///< Of those that bear. [m]
};

/** Returns the patch, or nothing where some contact has to be left faster than at rest,
 or those that can bear do not hold a body upright. */
std::optional<Patch> PatchOf(const ConstraintView<double>& rows,
                             const ConstraintBatch<double>& batch, std::size_t lane,
                             bool is_B) {
  Patch patch;
  patch.axes_W << VectorAt(batch.n, lane), VectorAt(batch.t1, lane),
      VectorAt(batch.t2, lane);
  patch.friction = batch.friction[lane];
  patch.count = static_cast<std::size_t>(batch.count);
  patch.middle_W.setZero();
  int bearing = 0;
  for (std::size_t k = 0; k < patch.count; ++k) {
    const std::size_t row = static_cast<std::size_t>(batch.first) + k;
    const ContactLanes<double>& contact = rows.contacts[row];
    if (rows.notes[row].used[lane] == 0) continue;
    if (contact.target[lane] > 0) return std::nullopt;
    // What may come nearer bears nothing at rest.
    if (contact.target[lane] < -kArrives * batch.usual[lane]) continue;
    patch.bears[k] = true;
    patch.r[k] = VectorAt(is_B ? contact.r_B : contact.r_A, lane);
    patch.middle_W += patch.r[k];
    ++bearing;
  }
  if (bearing < 3) return std::nullopt;
  patch.middle_W /= bearing;
  for (std::size_t k = 0; k < patch.count; ++k) {
    if (!patch.bears[k]) continue;
    patch.r[k] = patch.axes_W.transpose() * (patch.r[k] - patch.middle_W);
  }
  return patch;
}

/** Spreads impulses and their moments about the middle, along n, t1 and t2, over the
 contacts of a patch, as a stiff even bed does. */
class Bed {
 public:
  explicit Bed(const Patch& patch) : patch_(patch) {
    for (std::size_t k = 0; k < patch.count; ++k) {
      if (!patch.bears[k]) continue;
      number_ += 1;
      const Eigen::Vector2d arm = patch.r[k].tail<2>();
      square_ += arm * arm.transpose();
    }
  }

  /** Whether the contacts are not in one line, to some roundings. */
  bool IsWide() const {
    return square_.determinant() > 1e-12 * square_.trace() * square_.trace();
  }

  /** About how far from the middle the contacts are. [m] */
  double width() const { return std::sqrt(square_.trace() / number_); }

  /** Adds to `impulses` what bears `force` [N s] and `moment` [N m s], but for what the
   contacts are out of one plane. */
  void Add(const Eigen::Vector3d& force, const Eigen::Vector3d& moment,
           std::array<Eigen::Vector3d, 8>& impulses) const {
    // n × of a slope: the moment of a + b·r along n is (Σ r rᵀ) b, turned by a quarter.
    const Eigen::Vector2d slope =
        square_.inverse() * Eigen::Vector2d(-moment[2], moment[1]);
    double load = 0;
    Eigen::Vector2d centre(0, 0);
    ForEach([&](std::size_t k, const Eigen::Vector2d& arm) {
      impulses[k][0] += force[0] / number_ + slope.dot(arm);
      load += impulses[k][0];
      centre += impulses[k][0] * arm;
    });
    if (!(load > 0)) return;
    centre /= load;
    // About the centre of the load, so that the load and the turn do not mix.
    const double turn = moment[0] - (centre[0] * force[2] - centre[1] * force[1]);
    double polar = 0;
    ForEach([&](std::size_t k, const Eigen::Vector2d& arm) {
      polar += impulses[k][0] * (arm - centre).squaredNorm();
    });
    const double spin = polar > 0 ? turn / polar : 0;
    ForEach([&](std::size_t k, const Eigen::Vector2d& arm) {
      const Eigen::Vector2d out = arm - centre;
      impulses[k][1] += impulses[k][0] * (force[1] / load - spin * out[1]);
      impulses[k][2] += impulses[k][0] * (force[2] / load + spin * out[0]);
    });
  }

  /** Returns what the impulses leave of a force and a moment. */
  void Subtract(const std::array<Eigen::Vector3d, 8>& impulses, Eigen::Vector3d& force,
                Eigen::Vector3d& moment) const {
    ForEach([&](std::size_t k, const Eigen::Vector2d&) {
      force -= impulses[k];
      moment -= patch_.r[k].cross(impulses[k]);
    });
  }

  /** Brings impulses to where each contact pushes, and holds no more than its friction,
 where only rounding keeps them from there: what is at its bound would be held or not as a
 world is turned. Returns false where more does. */
  bool Clamp(std::array<Eigen::Vector3d, 8>& impulses) const {
    double load = 0;
    ForEach([&](std::size_t k, const Eigen::Vector2d&) { load += impulses[k][0]; });
    const double rounding = kNothing * load;
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
      if (patch_.bears[k]) visit(k, Eigen::Vector2d(patch_.r[k].tail<2>()));
    }
  }

  const Patch& patch_;
  double number_ = 0;
  Eigen::Matrix2d square_ = Eigen::Matrix2d::Zero();
};

/** Fills the impulses of the contacts of `patch` that bear what a body needs in all:
 `force` along n, t1 and t2, and `moment` about the middle. Returns false where there are
 none. */
bool Bear(const Patch& patch, const Eigen::Vector3d& force, const Eigen::Vector3d& moment,
          std::array<Eigen::Vector3d, 8>& impulses) {
  // A round leaves of what the one before it left a share like the bed's height by its
  // width.
  constexpr int kRounds = 4;
  const Bed bed(patch);
  if (!bed.IsWide()) return false;
  impulses.fill(Eigen::Vector3d::Zero());
  Eigen::Vector3d force_left = force;
  Eigen::Vector3d moment_left = moment;
  for (int round = 0; round < kRounds; ++round) {
    bed.Add(force_left, moment_left, impulses);
    force_left = force;
    moment_left = moment;
    bed.Subtract(impulses, force_left, moment_left);
  }
  if (!bed.Clamp(impulses)) return false;
  force_left = force;
  moment_left = moment;
  bed.Subtract(impulses, force_left, moment_left);
  // Each of eight contacts may have been brought to its bound by as much.
  const double nothing = 16 * kNothing * force.norm();
  return force_left.norm() <= nothing && moment_left.norm() <= bed.width() * nothing;
}

}  // namespace

void StaticEquilibrium::Find(const ConstraintView<double>& rows,
                             std::span<const int> islands, double solved,
                             const SolverBodies& world) {
  if (!FindTrees(rows, islands, solved)) return;
  TakeApart(rows, islands, world);
  for (const Limb& limb : limbs_) {
    if (!islands_[At(limb.island)].may_rest) continue;
    const auto& [index, lane] = limb.place;
    const ConstraintBatch<double>& batch = rows.batches[index];
    for (std::size_t k = 0; k < static_cast<std::size_t>(batch.count); ++k) {
      const std::size_t row = static_cast<std::size_t>(batch.first) + k;
      ContactLanes<double>& contact = rows.contacts[row];
      contact.impulse[lane] = limb.impulses[k][0];
      contact.friction_impulse1[lane] = limb.impulses[k][1];
      contact.friction_impulse2[lane] = limb.impulses[k][2];
    }
    if (batch.inverse_mass_A[lane] != 0) world.velocities[At(batch.A[lane])] = {};
    if (batch.inverse_mass_B[lane] != 0) world.velocities[At(batch.B[lane])] = {};
  }
}

bool StaticEquilibrium::FindTrees(const ConstraintView<double>& rows,
                                  std::span<const int> islands, double solved) {
  places_.clear();
  islands_.assign(islands.size(), {});
  joints_.assign(islands.size(), {});
  for (std::size_t index = 0; index < rows.batches.size(); ++index) {
    const ConstraintBatch<double>& batch = rows.batches[index];
    for (std::size_t lane = 0; lane < kLanes<double>; ++lane) {
      if (batch.pair[lane] < 0) continue;
      const auto join = [&](int body, double inverse_mass) {
        if (inverse_mass == 0) return;
        Joint& joint = joints_[At(body)];
        if (joint.pairs++ == 0) ++islands_[At(islands[At(body)])].bodies;
        joint.last ^= places_.size();
      };
      join(batch.A[lane], batch.inverse_mass_A[lane]);
      join(batch.B[lane], batch.inverse_mass_B[lane]);
      const int moving = batch.inverse_mass_A[lane] != 0 ? batch.A[lane] : batch.B[lane];
      Island& island = islands_[At(islands[At(moving)])];
      ++island.pairs;
      island.change = std::max(island.change, batch.change[lane]);
      places_.push_back({index, lane});
    }
  }
  // A tree has one pair less than bodies; one more is with what is static.
  bool any = false;
  for (Island& island : islands_) {
    island.may_rest =
        island.pairs > 0 && island.pairs == island.bodies && island.change > solved;
    any = any || island.may_rest;
  }
  return any;
}

void StaticEquilibrium::TakeApart(const ConstraintView<double>& rows,
                                  std::span<const int> islands,
                                  const SolverBodies& world) {
  needs_.resize(islands.size());
  limbs_.clear();
  loose_.clear();
  const auto heap_of = [&](int body) -> Island& {
    return islands_[At(islands[At(body)])];
  };
  for (std::size_t i = 0; i < islands.size(); ++i) {
    const int body = static_cast<int>(i);
    if (joints_[i].pairs == 0 || !heap_of(body).may_rest) continue;
    const RigidBody& moving = world.bodies[i];
    const Velocity& velocity = world.velocities[i];
    needs_[i] = {velocity.v / -moving.inverse_mass,
                 -WorldInertiaTimes(moving.R_WB, moving.moments, velocity.w)};
    if (joints_[i].pairs == 1) loose_.push_back(body);
  }
  while (!loose_.empty()) {
    const int body = loose_.back();
    loose_.pop_back();
    const std::size_t last = joints_[At(body)].last;
    joints_[At(body)].pairs = 0;
    const Place place = places_[last];
    const ConstraintBatch<double>& batch = rows.batches[place.batch];
    const Side side = SideOf(batch, place.lane, body);
    Island& island = heap_of(body);
    --island.bodies;
    if (side.other_moves) {
      // The other needs what this one receives.
      const Wrench& need = needs_[At(body)];
      Wrench& others = needs_[At(side.other)];
      const Eigen::Vector3d arm =
          world.bodies[At(body)].state.p_WB - world.bodies[At(side.other)].state.p_WB;
      others.force += need.force;
      others.moment += need.moment + arm.cross(need.force);
      Joint& joint = joints_[At(side.other)];
      joint.last ^= last;
      if (--joint.pairs == 1) loose_.push_back(side.other);
    }
    if (!island.may_rest) continue;
    const std::optional<Patch> patch = PatchOf(rows, batch, place.lane, side.is_B);
    if (!patch) {
      island.may_rest = false;
      continue;
    }
    // What the contacts bear already, and what is still needed: of A the opposite.
    const double sign = side.is_B ? 1 : -1;
    Wrench all{sign * needs_[At(body)].force, sign * needs_[At(body)].moment};
    for (std::size_t k = 0; k < patch->count; ++k) {
      const std::size_t row = static_cast<std::size_t>(batch.first) + k;
      const ContactLanes<double>& contact = rows.contacts[row];
      const Eigen::Vector3d J_W =
          patch->axes_W * Eigen::Vector3d(contact.impulse[place.lane],
                                          contact.friction_impulse1[place.lane],
                                          contact.friction_impulse2[place.lane]);
      all.force += J_W;
      all.moment +=
          VectorAt(side.is_B ? contact.r_B : contact.r_A, place.lane).cross(J_W);
    }
    Limb& limb = limbs_.emplace_back();
    limb.place = place;
    limb.island = islands[At(body)];
    island.may_rest =
        Bear(*patch, patch->axes_W.transpose() * all.force,
             patch->axes_W.transpose() * (all.moment - patch->middle_W.cross(all.force)),
             limb.impulses);
  }
  // What goes round in a ring is left.
  for (Island& island : islands_) island.may_rest = island.may_rest && island.bodies == 0;
}

}  // namespace cookbook
