#include "engine/dynamics/impacts/impact_solver.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>
#include <limits>

#include "engine/threads/prefetch.h"

namespace cookbook {
namespace {

/** Maximum number of impacts of a body in free flight in a step. After the last one the
 body waits where it is for the next step, unless that impact is slight. Constrained
 bodies have no limit.

 A ball of mass m between two blocks of mass M has π / arccos(M / (M + m)) impacts in all:
 222 at a mass ratio of 10⁴ (Galperin, Regular and Chaotic Dynamics 8, 2003). */
constexpr int kMaxImpacts = 256;

/** Change of velocity by a slight impact, as a fraction of the speed. */
constexpr double kSlightFraction = 1e-6;

/** Maximum number of bodies of an island that takes part in an impact. The impact costs
 as much as a step of the island. */
constexpr int kMaxIslandSize = 32;

/** Normal velocity after an inelastic impact, as a fraction of the greatest approach
 speed: rounding and the residual of the solver. */
constexpr double kRestingFraction = 1e-9;

/** Factor on the impact threshold for contacts within the speculative margin. */
constexpr double kImpactSpeedFactor = 1.01;

/** Minimum numbers of bodies, contact pairs, near pairs and candidates for a parallel
 loop. Fewer take some microseconds, and threads do not pay. */
constexpr std::size_t kMinParallelBodies = 128;
constexpr std::size_t kMinParallelPairs = 128;
constexpr std::size_t kMinParallelNearPairs = 1024;
constexpr std::size_t kMinParallelCandidates = 32;

/** Number of pairs by which prefetching is ahead. */
constexpr std::size_t kPrefetchDistance = 3;

constexpr double kNever = std::numeric_limits<double>::infinity();

std::size_t Index(int body) {
  return static_cast<std::size_t>(body);
}

/** Returns true if some contact of a pair is surely resting as defined by PhaseAt().
 Computed without a branch per contact, which would be unpredictable. The normal velocity
 at p, u = n · (v_B + ω_B × (p − x_B) − v_A − ω_A × (p − x_A)), is linear in p. Its
 rounding error is far below kRelativeSpeedTolerance of the speeds. */
bool IsSurelyResting(const Manifold& manifold, const RigidBody& A, const RigidBody& B,
                     double load_acceleration, const ImpactRules& rules) {
  // Relative to a dynamic body: the centre of a large static body may be far away.
  const Eigen::Vector3d& n = manifold.n_AB_W;
  const Eigen::Vector3d& o_W = A.is_static() ? B.state.p_WB : A.state.p_WB;
  const Eigen::Vector3d u = B.state.v_WB - A.state.v_WB +
                            B.state.w_WB.cross(o_W - B.state.p_WB) -
                            A.state.w_WB.cross(o_W - A.state.p_WB);
  const Eigen::Vector3d slope = n.cross(B.state.w_WB - A.state.w_WB);
  double least_velocity = std::numeric_limits<double>::infinity();
  for (const ContactPoint& contact : manifold.points()) {
    least_velocity = std::min(least_velocity, slope.dot(contact.p_WC - o_W));
  }
  least_velocity += n.dot(u);
  const auto speed = [](const RigidBody& body) {
    return body.state.v_WB.lpNorm<1>() + 2 * body.radius * body.state.w_WB.lpNorm<1>();
  };
  return least_velocity < -2 * kRelativeSpeedTolerance * (speed(A) + speed(B)) &&
         least_velocity >
             -0.999 * rules.restitution_threshold_factor * rules.h * load_acceleration;
}

/** Returns whether an impact hardly changes the velocity of a body: it is what the solver
 has left of an earlier one. */
bool IsSlight(const RigidBody& before, const Velocity& after) {
  const auto speed = [&](const Eigen::Vector3d& v, const Eigen::Vector3d& w) {
    return v.norm() + before.radius * w.norm();
  };
  const BodyState& state = before.state;
  return speed(after.v - state.v_WB, after.w - state.w_WB) <=
         kSlightFraction * speed(state.v_WB, state.w_WB);
}

}  // namespace

ImpactSolver::ImpactSolver() {
  // Enough for most steps, which then allocate nothing.
  constexpr std::size_t kMany = 64;
  impact_contacts_.reserve(kMany);
  supports_.reserve(kMany);
  neighbours_.reserve(kMany);
}

void ImpactSolver::Clear() {
  std::fill(impact_count_.begin(), impact_count_.end(), 0);
  impact_contacts_.clear();
  deep_pairs_.clear();
  supports_.clear();
  queue_.Clear();
}

void ImpactSolver::Begin(const StepStart& start, ContactCache& cache,
                         const StepContext& step) {
  rules_ = {step.h, step.settings.restitution_threshold_factor, step.settings.gyroscopic};
  const std::size_t count = start.bodies.size();
  in_free_flight_.resize(count);
  static_.resize(count);
  asleep_.resize(count);
  linked_.resize(count);
  impact_count_.resize(count);
  flights_.resize(count);
  has_flight_.resize(count);
  max_travel_.resize(count);
  accelerations_.resize(count);
  Clear();
  impact_.BeginStep(count, step.settings);
  if (!FindFreeBodies(start, cache, step.pool)) return;
  FindIslands();
  FindCandidates(start, cache, step.pool);
}

void ImpactSolver::KeepDeepPairsThatHit() {
  if (deep_pairs_.empty()) return;
  std::vector<std::pair<int, int>> hit;
  for (const ContactPair& pair : impact_contacts_)
    hit.push_back(std::minmax(pair.A, pair.B));
  std::ranges::sort(hit);
  std::erase_if(deep_pairs_, [&](const std::pair<int, int>& pair) {
    return !std::ranges::binary_search(
        hit, std::pair<int, int>(std::minmax(pair.first, pair.second)));
  });
}

ContactPhase ImpactSolver::PhaseOf(const ContactPair& pair,
                                   std::span<const RigidBody> bodies,
                                   const ImpactRules& rules) const {
  const RigidBody& A = bodies[Index(pair.A)];
  const RigidBody& B = bodies[Index(pair.B)];
  const Eigen::Vector3d a_AB_W =
      accelerations_[Index(pair.B)] - accelerations_[Index(pair.A)];
  const double load_acceleration = LoadAccelerationOn(pair, A, B);
  if (IsSurelyResting(pair.manifold, A, B, load_acceleration, rules))
    return ContactPhase::kResting;
  const Eigen::Vector3d& n_W = pair.manifold.n_AB_W;
  const double approach_speed = n_W.dot(A.state.v_WB - B.state.v_WB) +
                                RotationalSpeed(A, n_W) + RotationalSpeed(B, n_W);
  const bool may_tunnel = MayTunnel(A, B, rules.h * approach_speed);
  ContactPhase all = ContactPhase::kImpacting;
  for (const ContactPoint& contact : pair.manifold.points()) {
    const ContactPhase one = PhaseAt(contact.p_WC, pair.manifold.n_AB_W, A, B, a_AB_W,
                                     load_acceleration, rules);
    if (one == ContactPhase::kImpacting) continue;
    // A penetrating contact needs position correction unless it is an impact, or the
    // bodies separate there and may tunnel by another point.
    const bool penetrates =
        contact.separation < -SpeculativeMarginBetween(A, B) - ContactTolerance(A, B);
    if (one == ContactPhase::kResting || (penetrates && !may_tunnel))
      return ContactPhase::kResting;
    all = ContactPhase::kSeparating;
  }
  return all;
}

void ImpactSolver::ClassifyContacts(const ContactCache& cache,
                                    std::span<const RigidBody> bodies, ThreadPool& pool) {
  const std::span<const ContactPair> pairs = cache.pairs();
  const std::span<const PairSummary> summaries = cache.summaries();
  // Use a higher threshold, so that every contact released here is an impact in Solve().
  // A body released without an impact there would sink in.
  ImpactRules strict_rules = rules_;
  strict_rules.restitution_threshold_factor *= kImpactSpeedFactor;
  touching_pairs_.resize(summaries.size());
  // One resting contact constrains both bodies, so that later contacts between
  // constrained bodies need no classification. Which ones are skipped depends on the
  // threads, the result does not.
  const auto may_be_free = [&](int body) {
    return std::atomic_ref(in_free_flight_[Index(body)])
               .load(std::memory_order_relaxed) != 0;
  };
  const auto constrain = [&](int body) {
    std::atomic_ref(in_free_flight_[Index(body)]).store(0, std::memory_order_relaxed);
  };
  pool.ParallelFor(
      summaries.size(), kMinParallelPairs, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
          if (k + kPrefetchDistance < end) {
            for (const int next : {summaries[k + kPrefetchDistance].A,
                                   summaries[k + kPrefetchDistance].B}) {
              if (!may_be_free(next)) continue;
              Prefetch(&bodies[Index(next)].state, offsetof(RigidBody, R_WB));
              Prefetch(&accelerations_[Index(next)], sizeof(Eigen::Vector3d));
            }
          }
          const PairSummary& pair = summaries[k];
          ContactPhase phase = ContactPhase::kSeparating;
          if (may_be_free(pair.A) || may_be_free(pair.B)) {
            phase = PhaseOf(pairs[k], bodies, strict_rules);
          }
          touching_pairs_[k] = {pair.A, pair.B, phase};
          if (phase != ContactPhase::kResting) continue;
          constrain(pair.A);
          constrain(pair.B);
        }
      });
}

bool ImpactSolver::FindFreeBodies(const StepStart& start, ContactCache& cache,
                                  ThreadPool& pool) {
  pool.ParallelFor(
      start.bodies.size(), kMinParallelBodies, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          const RigidBody& body = start.bodies[i];
          static_[i] = body.is_static() ? 1 : 0;
          asleep_[i] = start.asleep[i] ? 1 : 0;
          linked_[i] = start.linked[i] ? 1 : 0;
          in_free_flight_[i] =
              !body.is_static() && !body.is_point && !start.linked[i] ? 1 : 0;
          accelerations_[i].setZero();
          if (!static_[i])
            accelerations_[i] = (start.free[i].v - start.before[i].v) / rules_.h;
          max_travel_[i] = MaxTravel(body, start.free[i].v, rules_.h);
        }
      });
  ClassifyContacts(cache, start.bodies, pool);
  const auto any_is_free = [&] {
    return std::find(in_free_flight_.begin(), in_free_flight_.end(), 1) !=
           in_free_flight_.end();
  };
  if (!any_is_free()) return false;
  // A body that touches a constrained body is constrained, except if it hits it.
  islands_.Reset(in_free_flight_.size());
  impacting_pairs_.clear();
  for (const TouchingPair& pair : touching_pairs_) {
    if (IsStatic(pair.A) || IsStatic(pair.B)) continue;
    if (pair.phase == ContactPhase::kImpacting &&
        (IsInFreeFlight(pair.A) || IsInFreeFlight(pair.B))) {
      impacting_pairs_.emplace_back(pair.A, pair.B);
    } else {
      islands_.Unite(pair.A, pair.B);
    }
  }
  if (!impacting_pairs_.empty()) ConstrainBodiesHittingLargeIslands();
  island_root_ = islands_.Roots();
  is_constrained_island_.assign(in_free_flight_.size(), 0);
  for (std::size_t i = 0; i < island_root_.size(); ++i) {
    if (!in_free_flight_[i] && !static_[i])
      is_constrained_island_[Index(island_root_[i])] = 1;
  }
  for (std::size_t i = 0; i < island_root_.size(); ++i) {
    if (is_constrained_island_[Index(island_root_[i])]) in_free_flight_[i] = 0;
  }
  for (std::size_t k = 0; k < touching_pairs_.size(); ++k) {
    if (!IsInFreeFlight(touching_pairs_[k].A) && !IsInFreeFlight(touching_pairs_[k].B))
      continue;
    const auto& [A, B, phase] = touching_pairs_[k];
    const double slop = SlopBetween(start.bodies[Index(A)], start.bodies[Index(B)]);
    if (std::ranges::any_of(cache.pairs()[k].manifold.points(), [&](const auto& contact) {
          return contact.separation < -slop;
        }))
      deep_pairs_.emplace_back(A, B);
    cache.ClearContacts(k);
  }
  return any_is_free();
}

void ImpactSolver::ConstrainBodiesHittingLargeIslands() {
  impact_islands_ = islands_;
  for (const auto& [A, B] : impacting_pairs_) impact_islands_.Unite(A, B);
  island_root_ = impact_islands_.Roots();
  CountIslandBodies();
  for (const auto& [A, B] : impacting_pairs_) {
    if (island_size_[Index(island_root_[Index(A)])] > kMaxIslandSize)
      islands_.Unite(A, B);
  }
}

void ImpactSolver::BeginFlight(int body, const StepStart& start) {
  // Filled in place: a RigidBody is large.
  FreeFlight& flight = flights_[Index(body)];
  flight.start = start.bodies[Index(body)];
  flight.from = 0;
  flight.load_acceleration_W = accelerations_[Index(body)];
  flight.a_W.setZero();
  flight.torque_W.setZero();
  flight.until = kNever;
  if (!IsInFreeFlight(body)) return;
  flight.a_W = accelerations_[Index(body)];
  flight.torque_W = flight.start.Torque_W();
}

void ImpactSolver::FindCandidates(const StepStart& start, const ContactCache& cache,
                                  ThreadPool& pool) {
  near_pairs_.Clear(pool.chunk_count());
  const auto is_eligible = [&](int A, int B) {
    return (IsInFreeFlight(A) || IsInFreeFlight(B)) &&
           IslandSizeOf(A) <= kMaxIslandSize && IslandSizeOf(B) <= kMaxIslandSize;
  };
  pool.ParallelForIndexed(cache.near_count(), kMinParallelNearPairs,
                          [&](std::size_t chunk, std::size_t begin, std::size_t end) {
                            cache.ForEachGap(
                                begin, end, is_eligible, [&](int A, int B, double gap) {
                                  if (gap > max_travel_[Index(A)] + max_travel_[Index(B)])
                                    return;
                                  near_pairs_[chunk].push_back({A, B, gap});
                                });
                          });
  std::fill(has_flight_.begin(), has_flight_.end(), 0);
  flights_to_begin_.clear();
  queue_.Begin(start.bodies.size());
  near_pairs_.ForEach([&](const NearPair& pair) {
    for (const int body : {pair.A, pair.B}) {
      if (!std::exchange(has_flight_[Index(body)], 1)) flights_to_begin_.push_back(body);
    }
    queue_.Append(pair.A, pair.B, pair.gap);
  });
  pool.ParallelFor(flights_to_begin_.size(), kMinParallelCandidates,
                   [&](std::size_t begin, std::size_t end) {
                     for (std::size_t k = begin; k < end; ++k)
                       BeginFlight(flights_to_begin_[k], start);
                   });
}

void ImpactSolver::FindIslands() {
  // Impacts between two constrained bodies are resting contacts after all.
  for (const auto& [A, B] : impacting_pairs_) {
    if (IsConstrained(A) && IsConstrained(B)) islands_.Unite(A, B);
  }
  island_root_ = islands_.Roots();
  CountIslandBodies();
}

void ImpactSolver::BuildContactLists(std::span<const PairSummary> summaries) {
  // Backwards, so that each list has its contact pairs in their order.
  first_contact_of_island_.assign(in_free_flight_.size(), -1);
  next_contact_.resize(summaries.size());
  for (int k = static_cast<int>(summaries.size()) - 1; k >= 0; --k) {
    const PairSummary& pair = summaries[Index(k)];
    if (pair.count == 0) continue;
    const int dynamic = IsStatic(pair.A) ? pair.B : pair.A;
    next_contact_[Index(k)] =
        std::exchange(first_contact_of_island_[Index(island_root_[Index(dynamic)])], k);
  }
}

void ImpactSolver::CountIslandBodies() {
  island_size_.assign(in_free_flight_.size(), 0);
  for (std::size_t i = 0; i < in_free_flight_.size(); ++i) {
    int& size = island_size_[Index(island_root_[i])];
    // Bodies with joints or springs take part in no impact.
    size += linked_[i] ? kMaxIslandSize + 1 : 1;
  }
}

void ImpactSolver::Solve(std::span<RigidBody> bodies, std::span<const Velocity> mean,
                         ContactCache& cache, const StepContext& step) {
  if (queue_.size() == 0) {
    deep_pairs_.clear();
    return;
  }
  const StepEnd end{bodies, mean, cache.pairs(), cache.summaries()};
  has_contact_lists_ = false;
  for (const int body : flights_to_begin_) {
    if (IsConstrained(body)) BeginFlightFromEnd(body, end);
  }
  ScheduleAll(step.pool);
  for (int first = queue_.PopEarliest(); first >= 0; first = queue_.PopEarliest()) {
    const double t = queue_[first].time_of_impact;
    ResolveImpact(queue_[first], end, step);
    for (const int body : impact_.members()) {
      if (!IsStatic(body)) AddNewCandidates(body, t, end, cache);
    }
    impact_.Clear();
  }
  ApplySupportImpulses();
  for (std::size_t i = 0; i < impact_count_.size(); ++i) {
    if (impact_count_[i] == 0) continue;
    const BodyState end_state = flights_[i].At(rules_.h, rules_.gyroscopic).state;
    const BodyState before = bodies[i].state;
    bodies[i].state = end_state;
    bodies[i].R_WB = end_state.q_WB.toRotationMatrix();
    cache.AddTravel(i, Travel(before, bodies[i]));
  }
  KeepDeepPairsThatHit();
}

bool ImpactSolver::MayCollide(const ImpactCandidate& candidate) const {
  // The gap is that at the start of the step, and a constrained body is followed
  // backwards from the end.
  if (IsConstrained(candidate.A) || IsConstrained(candidate.B)) return true;
  const FreeFlight& A = flights_[Index(candidate.A)];
  const FreeFlight& B = flights_[Index(candidate.B)];
  const double h = rules_.h;
  const double max_distance = h * (B.start.state.v_WB - A.start.state.v_WB).norm() +
                              0.5 * h * h * (B.a_W - A.a_W).norm() +
                              h * (RotationalSpeed(A.start) + RotationalSpeed(B.start));
  return candidate.gap <= max_distance;
}

bool ImpactSolver::IsEligible(const ImpactCandidate& candidate) const {
  int island_size = 0;
  for (const int body : {candidate.A, candidate.B}) {
    if (IsInFreeFlight(body) && impact_count_[Index(body)] >= kMaxImpacts) return false;
    island_size = std::max(island_size, IslandSizeOf(body));
  }
  return island_size <= kMaxIslandSize;
}

double ImpactSolver::NextTimeOfImpact(double from,
                                      const ImpactCandidate& candidate) const {
  if (!IsEligible(candidate)) return kNever;
  const FreeFlight& A = flights_[Index(candidate.A)];
  const FreeFlight& B = flights_[Index(candidate.B)];
  return TimeOfImpact(A, B, from, rules_).value_or(kNever);
}

void ImpactSolver::Schedule(double from, int index) {
  queue_.Schedule(index, NextTimeOfImpact(from, queue_[index]));
}

void ImpactSolver::ScheduleAll(ThreadPool& pool) {
  first_impacts_.resize(Index(queue_.size()));
  pool.ParallelFor(first_impacts_.size(), kMinParallelCandidates,
                   [&](std::size_t begin, std::size_t end) {
                     for (std::size_t k = begin; k < end; ++k) {
                       const ImpactCandidate& candidate = queue_[static_cast<int>(k)];
                       first_impacts_[k] = MayCollide(candidate)
                                               ? NextTimeOfImpact(0, candidate)
                                               : kNever;
                     }
                   });
  for (int index = 0; index < queue_.size(); ++index) {
    queue_.Schedule(index, first_impacts_[Index(index)]);
  }
}

void ImpactSolver::AddBody(int body, double t) {
  if (!impact_.Contains(body))
    impact_.AddBody(body, flights_[Index(body)].At(t, rules_.gyroscopic));
}

void ImpactSolver::BeginFlightFromEnd(int body, const StepEnd& end) {
  has_flight_[Index(body)] = 1;
  FreeFlight& flight = flights_[Index(body)];
  flight = {end.bodies[Index(body)], rules_.h};
  flight.load_acceleration_W = accelerations_[Index(body)];
  if (IsStatic(body)) return;
  if (IsConstrained(body) && BearsLoad(body, end)) {
    // x(0) = x(h) − h mean, at a constant acceleration.
    flight.a_W = 2 / rules_.h * (flight.start.state.v_WB - end.mean[Index(body)].v);
    return;
  }
  flight.a_W = accelerations_[Index(body)];
  flight.torque_W = flight.start.Torque_W();
}

void ImpactSolver::AddNewCandidates(int body, double t, const StepEnd& end,
                                    ContactCache& cache) {
  const FreeFlight& flight = flights_[Index(body)];
  const double remaining = rules_.h - t;
  const double distance = MaxTravel(
      flight.start, flight.start.state.v_WB + remaining * flight.a_W, remaining);
  double& max_travel = max_travel_[Index(body)];
  if (distance <= max_travel * remaining / rules_.h) return;
  max_travel = distance * rules_.h / remaining;
  neighbours_.clear();
  cache.FindCandidates(body, flight.start, distance + flight.start.speculative_margin,
                       neighbours_);
  for (const int other : neighbours_) {
    if (IslandSizeOf(body) > kMaxIslandSize || IslandSizeOf(other) > kMaxIslandSize)
      continue;
    if (!IsInFreeFlight(body) && !IsInFreeFlight(other)) continue;
    // A sleeping body is static in this step and wakes in the next one.
    if (asleep_[Index(other)]) continue;
    bool is_known = false;
    queue_.ForEachOf(body, [&](int index) {
      is_known = is_known || queue_[index].A == other || queue_[index].B == other;
    });
    if (is_known) continue;
    if (!has_flight_[Index(other)]) BeginFlightFromEnd(other, end);
    queue_.Append(std::min(body, other), std::max(body, other), 0);
    Schedule(t, queue_.size() - 1);
  }
}

template <class Visit>
void ImpactSolver::ForEachContactOfIsland(int body, const StepEnd& end,
                                          const Visit& visit) {
  if (!std::exchange(has_contact_lists_, true)) BuildContactLists(end.summaries);
  for (int k = first_contact_of_island_[Index(island_root_[Index(body)])]; k >= 0;
       k = next_contact_[Index(k)])
    visit(end.pairs[Index(k)]);
}

bool ImpactSolver::BearsLoad(int body, const StepEnd& end) {
  bool bears_load = false;
  ForEachContactOfIsland(body, end, [&](const ContactPair& pair) {
    for (std::size_t k = 0; k < pair.manifold.points().size(); ++k)
      bears_load = bears_load || !pair.J_W[k].isZero(0);
  });
  return bears_load;
}

void ImpactSolver::AddIsland(int body, double t, const StepEnd& end) {
  const auto join = [&](int member) {
    if (!impact_.Contains(member) && impact_count_[Index(member)] == 0)
      BeginFlightFromEnd(member, end);
    AddBody(member, t);
  };
  join(body);
  ForEachContactOfIsland(body, end, [&](const ContactPair& pair) {
    join(pair.A);
    join(pair.B);
    impact_.AddContacts(pair);
  });
}

void ImpactSolver::GatherContacts(double t, const StepEnd& end) {
  const auto join = [&](int body) {
    if (IsConstrained(body) && !impact_.Contains(body)) AddIsland(body, t, end);
    AddBody(body, t);
  };
  // Tests candidates in their order. A body that joins after the turn of one of its
  // candidates brings that one into the next pass.
  pending_.clear();
  deferred_.clear();
  std::size_t visited = 0;
  const auto add_candidates = [&](int after) {
    for (; visited < impact_.members().size(); ++visited) {
      const int body = impact_.members()[visited];
      if (IsStatic(body)) continue;
      queue_.ForEachOf(body, [&](int index) {
        std::vector<int>& queue = index > after ? pending_ : deferred_;
        queue.push_back(index);
        std::push_heap(queue.begin(), queue.end(), std::greater<>());
      });
    }
  };
  for (add_candidates(-1); !pending_.empty();
       pending_.empty() ? pending_.swap(deferred_) : void()) {
    std::pop_heap(pending_.begin(), pending_.end(), std::greater<>());
    const int index = pending_.back();
    pending_.pop_back();
    ImpactCandidate& candidate = queue_[index];
    if (std::exchange(candidate.is_tested, true) || !IsEligible(candidate)) continue;
    const auto shape_of = [&](int body) {
      return impact_.Contains(body) ? impact_.BodyBefore(body)
                                    : flights_[Index(body)].ShapeAt(t, rules_.gyroscopic);
    };
    ContactPair pair;
    pair.manifold = CollideAtImpact(shape_of(candidate.A), shape_of(candidate.B));
    if (pair.manifold.count == 0) continue;
    pair.A = candidate.A;
    pair.B = candidate.B;
    join(pair.A);
    join(pair.B);
    impact_.AddContacts(pair);
    add_candidates(index);
  }
}

void ImpactSolver::ResolveImpact(const ImpactCandidate& first, const StepEnd& end,
                                 const StepContext& step) {
  const double t = first.time_of_impact;
  // The body in free flight brings the other one with it.
  AddBody(IsInFreeFlight(first.A) ? first.A : first.B, t);
  GatherContacts(t, end);
  const std::size_t first_contact = impact_contacts_.size();
  impact_.Solve(step, impact_contacts_);
  ResumeFlights(t);
  AddSupports(first_contact, t);
  for (const int body : impact_.members()) {
    if (IsStatic(body)) continue;
    queue_.ForEachOf(body, [&](int index) {
      if (std::exchange(queue_[index].is_tested, false)) Schedule(t, index);
    });
  }
}

void ImpactSolver::ResumeFlights(double t) {
  for (std::size_t k = 0; k < impact_.members().size(); ++k) {
    const int body = impact_.members()[k];
    if (IsStatic(body)) continue;
    FreeFlight& flight = flights_[Index(body)];
    flight.start = impact_.BodyBefore(body);
    flight.start.state.v_WB = impact_.VelocityAfter(k).v;
    flight.start.state.w_WB = impact_.VelocityAfter(k).w;
    flight.from = t;
    // A support ends with the next impact.
    if (IsInFreeFlight(body)) flight.a_W = accelerations_[Index(body)];
    for (Support& support : supports_) {
      if (support.body == body) support.until = std::min(support.until, t);
    }
    if (++impact_count_[Index(body)] < kMaxImpacts || !IsInFreeFlight(body)) continue;
    if (!IsSlight(impact_.BodyBefore(body), impact_.VelocityAfter(k))) flight.until = t;
  }
}

void ImpactSolver::AddSupports(std::size_t first, double t) {
  for (std::size_t k = first; k < impact_contacts_.size(); ++k) {
    const ContactPair& pair = impact_contacts_[k];
    const bool A_rests = IsInFreeFlight(pair.A) && IsStatic(pair.B);
    if (!A_rests && !(IsInFreeFlight(pair.B) && IsStatic(pair.A))) continue;
    const int body = A_rests ? pair.A : pair.B;
    const Eigen::Vector3d n_W = (A_rests ? -1 : 1) * pair.manifold.n_AB_W;
    FreeFlight& flight = flights_[Index(body)];
    const BodyState& state = flight.start.state;
    // A body that still moves or rocks on its contacts does not rest: a support would do
    // work on it.
    const double tolerance = kRestingFraction * impact_.max_approach_speed();
    if (std::abs(n_W.dot(state.v_WB)) > tolerance) continue;
    const auto points = pair.manifold.points();
    const bool rests =
        std::all_of(points.begin(), points.end(), [&](const ContactPoint& contact) {
          const Eigen::Vector3d r = contact.p_WC - state.p_WB;
          return std::abs(n_W.dot(state.w_WB.cross(r))) <= tolerance;
        });
    const double acceleration = n_W.dot(flight.a_W);
    if (!rests || acceleration >= 0) continue;
    flight.a_W -= acceleration * n_W;
    const double force = -acceleration / flight.start.inverse_mass;
    supports_.push_back({body, k, force * pair.manifold.n_AB_W, t, rules_.h});
  }
}

void ImpactSolver::ApplySupportImpulses() {
  for (const Support& support : supports_) {
    ContactPair& pair = impact_contacts_[support.pair];
    const Eigen::Vector3d J_W = (support.until - support.from) * support.force_B_W;
    const std::size_t count = pair.manifold.points().size();
    for (std::size_t i = 0; i < count; ++i) {
      pair.J_W[i] += J_W / static_cast<double>(count);
    }
  }
}

}  // namespace cookbook
