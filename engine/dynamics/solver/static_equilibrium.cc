#include "engine/dynamics/solver/static_equilibrium.h"

#include <algorithm>
#include <tuple>

#include "engine/dynamics/body/rotation.h"

namespace cookbook {
namespace {

/** A contact counts as closed if its gap closes in a step with less than this fraction of
 the speed that the loads add. Such gaps come from rounding far from the origin, or are
 some nanometres. Later iterations close them. */
constexpr double kBearingFraction = 1e-3;

/** A gap below this fraction stays open: 3 nm under gravity at 1/60 s. */
constexpr double kClosedFraction = 1e-6;

/** Iterations leave a body that cannot rest in motion, and one that can hardly faster
 than its load accelerates it in this number of steps. Others are not tried, to save time.
 */
constexpr double kMaxStepsOfLoad = 4;

std::size_t At(int index) {
  return static_cast<std::size_t>(index);
}

Eigen::Vector3d VectorAt(const VectorLanes<double>& lanes, std::size_t lane) {
  return {lanes[0][lane], lanes[1][lane], lanes[2][lane]};
}

/** Whether a contact of a pair at rest may bear load: it exists and is closed. */
bool BearsLoad(const ConstraintView<double>& constraints,
               const ConstraintBatch<double>& batch, std::size_t contact,
               std::size_t lane) {
  return constraints.cold[contact].used[lane] != 0 &&
         constraints.contacts[contact].target[lane] >=
             -kBearingFraction * batch.load_speed[lane];
}

}  // namespace

bool StaticEquilibrium::Solve(const ConstraintView<double>& constraints,
                              std::span<const int> islands, double solved,
                              const SolverBodies& bodies,
                              std::span<Velocity> velocities) {
  CollectPairs(constraints, islands);
  impulses_.clear();
  indices_.assign(islands.size(), -1);
  std::size_t resting = 0;
  for (std::size_t begin = 0, end = 0; begin < pairs_.size(); begin = end) {
    while (end < pairs_.size() && pairs_[end].island == pairs_[begin].island) ++end;
    const std::span<Pair> island = std::span(pairs_).subspan(begin, end - begin);
    if (!MayRest(constraints, island, solved, bodies, velocities) ||
        !SolveIsland(constraints, island, bodies)) {
      continue;
    }
    for (const Pair& pair : island) pairs_[resting++] = pair;
  }
  pairs_.resize(resting);
  Apply(constraints, velocities);
  std::erase_if(pairs_, [](const Pair& pair) { return !pair.is_closed; });
  for (const Pair& pair : pairs_)
    constraints.batches[pair.batch].max_change[pair.lane] = 0;
  return !pairs_.empty();
}

void StaticEquilibrium::Apply(const ConstraintView<double>& constraints,
                              std::span<Velocity> velocities) const {
  for (const Pair& pair : pairs_) {
    const std::size_t lane = pair.lane;
    const ConstraintBatch<double>& batch = constraints.batches[pair.batch];
    for (std::size_t k = 0; k < At(batch.count); ++k) {
      const Eigen::Vector3d& impulse = impulses_[pair.first_impulse + k];
      ContactConstraintLanes<double>& contact = constraints.contacts[At(batch.first) + k];
      contact.impulse[lane] = impulse[0];
      contact.friction_impulse1[lane] = impulse[1];
      contact.friction_impulse2[lane] = impulse[2];
    }
    if (batch.inverse_mass_A[lane] != 0) velocities[At(batch.A[lane])] = {};
    if (batch.inverse_mass_B[lane] != 0) velocities[At(batch.B[lane])] = {};
  }
}

void StaticEquilibrium::CollectPairs(const ConstraintView<double>& constraints,
                                     std::span<const int> islands) {
  pairs_.clear();
  for (std::size_t index = 0; index < constraints.batches.size(); ++index) {
    const ConstraintBatch<double>& batch = constraints.batches[index];
    for (std::size_t lane = 0; lane < kLanes<double>; ++lane) {
      if (batch.pair[lane] < 0) continue;
      const int moving = batch.inverse_mass_A[lane] != 0 ? batch.A[lane] : batch.B[lane];
      pairs_.push_back({islands[At(moving)], index, lane, 0, true});
    }
  }
  std::sort(pairs_.begin(), pairs_.end(), [](const Pair& a, const Pair& b) {
    return std::tie(a.island, a.batch, a.lane) < std::tie(b.island, b.batch, b.lane);
  });
}

bool StaticEquilibrium::MayRest(const ConstraintView<double>& constraints,
                                std::span<const Pair> island, double solved,
                                const SolverBodies& bodies,
                                std::span<const Velocity> velocities) {
  double max_change = 0;
  double load_speed = 0;
  double max_speed = 0;
  for (const Pair& pair : island) {
    const ConstraintBatch<double>& batch = constraints.batches[pair.batch];
    max_change = std::max(max_change, batch.max_change[pair.lane]);
    load_speed = std::max(load_speed, batch.load_speed[pair.lane]);
    for (const int body : {batch.A[pair.lane], batch.B[pair.lane]}) {
      const RigidBody& rigid = bodies.rigid_bodies[At(body)];
      if (rigid.is_static()) continue;
      const Velocity& velocity = velocities[At(body)];
      max_speed =
          std::max(max_speed, velocity.v.norm() + rigid.radius * velocity.w.norm());
    }
  }
  return max_change > solved && max_speed <= kMaxStepsOfLoad * load_speed;
}

int StaticEquilibrium::IndexOf(int body, const SolverBodies& bodies) {
  int& index = indices_[At(body)];
  if (index >= 0) return index;
  const RigidBody& moving = bodies.rigid_bodies[At(body)];
  const Velocity& velocity = bodies.velocities[At(body)];
  ElasticFoundation::Vector required;
  required << velocity.v / -moving.inverse_mass,
      -WorldInertiaTimes(moving.R_WB, moving.moments, velocity.w);
  index = foundation_.AddBody(required);
  return index;
}

bool StaticEquilibrium::SolveIsland(const ConstraintView<double>& constraints,
                                    std::span<Pair> island, const SolverBodies& bodies) {
  foundation_.Clear();
  for (const Pair& pair : island) {
    const ConstraintBatch<double>& batch = constraints.batches[pair.batch];
    indices_[At(batch.A[pair.lane])] = indices_[At(batch.B[pair.lane])] = -1;
  }
  bool is_closed = true;
  for (const Pair& pair : island) {
    const std::size_t lane = pair.lane;
    const ConstraintBatch<double>& batch = constraints.batches[pair.batch];
    const int A = batch.A[lane];
    const int B = batch.B[lane];
    const bool moves_A = batch.inverse_mass_A[lane] != 0;
    const bool moves_B = batch.inverse_mass_B[lane] != 0;
    Eigen::Matrix3d axes_W;
    axes_W << VectorAt(batch.n, lane), VectorAt(batch.t1, lane), VectorAt(batch.t2, lane);
    foundation_.AddPair(
        moves_A ? IndexOf(A, bodies) : -1, moves_B ? IndexOf(B, bodies) : -1,
        bodies.rigid_bodies[At(B)].state.p_WB - bodies.rigid_bodies[At(A)].state.p_WB,
        axes_W, batch.friction[lane]);
    for (std::size_t k = 0; k < At(batch.count); ++k) {
      const std::size_t index = At(batch.first) + k;
      if (!BearsLoad(constraints, batch, index, lane)) continue;
      const ContactConstraintLanes<double>& contact = constraints.contacts[index];
      if (contact.target[lane] > 0) return false;  // It has to separate.
      is_closed =
          is_closed && contact.target[lane] >= -kClosedFraction * batch.load_speed[lane];
      foundation_.AddContact(VectorAt(moves_B ? contact.r_B : contact.r_A, lane));
    }
  }
  if (!foundation_.Solve()) return false;
  std::size_t next = 0;
  for (Pair& pair : island) {
    pair.is_closed = is_closed;
    pair.first_impulse = impulses_.size();
    const ConstraintBatch<double>& batch = constraints.batches[pair.batch];
    for (std::size_t k = 0; k < At(batch.count); ++k) {
      const bool bears = BearsLoad(constraints, batch, At(batch.first) + k, pair.lane);
      impulses_.push_back(bears ? foundation_.impulse(next++) : Eigen::Vector3d::Zero());
    }
  }
  return true;
}

}  // namespace cookbook
