#include "engine/dynamics/impacts/impact_solver.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>
#include <limits>

#include "engine/threads/prefetch.h"

namespace cookbook {
namespace {

/** ImpactSolver of a body in a step after which it flies on through what it meets: the
 next step sends it back. */
constexpr int kMaxImpacts = 8;

/** Bodies of a island that takes part in a impact: that costs as much as a step of the
 * island.
 */
constexpr int kMaxIslandSize = 32;
/** The same in a large world, whose impacts are too many to be solved: a island that a
 impact leaves half solved sinks deeper than what strikes it is late. Not of what would be
 through the island by the next step. */
constexpr int kMaxIslandSizeOfMany = 4;

/** What a impact leaves of an approach, as a share of the speeds, where it sends nothing
 back: rounding, and what the solver leaves. */
constexpr double kStopped = 1e-9;

/** How much faster than a impact has to be what flies from within the margin. */
constexpr double kSurely = 1.01;

/** Bodies, pairs, near pairs and candidates below which it does not pay to share them
 out: some microseconds. */
constexpr std::size_t kFewBodies = 128;
constexpr std::size_t kFewPairs = 128;
constexpr std::size_t kFewNear = 1024;
constexpr std::size_t kFewMeetings = 32;

/** How many pairs ahead memory is told. */
constexpr std::size_t kAhead = 3;

constexpr double kNever = std::numeric_limits<double>::infinity();

std::size_t At(int body) {
  return static_cast<std::size_t>(body);
}

/** Returns true where some contact of a pair holds for sure, as PhaseAt() says, without
 a branch for each contact, which nothing foretells: how fast two bodies approach at p, u
 = n · (v_B + ω_B × (p − x_B) − v_A − ω_A × (p − x_A)), is linear in p. What that rounds
 is far below kTogether of the speeds. */
bool SurelyHolds(const Manifold& manifold, const RigidBody& A, const RigidBody& B,
                 double load, const ImpactRules& rules) {
  // About a body that moves: the centre of ground that is wide may be far.
  const Eigen::Vector3d& n = manifold.n_AB_W;
  const Eigen::Vector3d& o_W = A.is_static() ? B.state.p_WB : A.state.p_WB;
  const Eigen::Vector3d u = B.state.v_WB - A.state.v_WB +
                            B.state.w_WB.cross(o_W - B.state.p_WB) -
                            A.state.w_WB.cross(o_W - A.state.p_WB);
  const Eigen::Vector3d slope = n.cross(B.state.w_WB - A.state.w_WB);
  double fastest = std::numeric_limits<double>::infinity();
  for (const ContactPoint& contact : manifold.points()) {
    fastest = std::min(fastest, slope.dot(contact.p_WC - o_W));
  }
  fastest += n.dot(u);
  const auto speed = [](const RigidBody& body) {
    return body.state.v_WB.lpNorm<1>() + 2 * body.radius * body.state.w_WB.lpNorm<1>();
  };
  return fastest < -2 * kTogether * (speed(A) + speed(B)) &&
         fastest > -0.999 * rules.resting_speed * rules.h * load;
}

}  // namespace

ImpactSolver::ImpactSolver() {
  // Of most impacts of most steps: from then on they allocate nothing.
  constexpr std::size_t kMany = 64;
  struck_.reserve(kMany);
  supports_.reserve(kMany);
  met_.reserve(kMany);
}

void ImpactSolver::Clear() {
  std::fill(impacts_.begin(), impacts_.end(), 0);
  struck_.clear();
  supports_.clear();
  queue_.Clear();
}

void ImpactSolver::Begin(const Start& start, ContactCache& cache,
                         const Settings& settings, double h, ThreadPool& pool) {
  rules_ = {h, settings.resting_speed, settings.gyroscopic};
  const std::size_t count = start.bodies.size();
  in_free_flight_.resize(count);
  static_.resize(count);
  asleep_.resize(count);
  linked_.resize(count);
  impacts_.resize(count);
  flights_.resize(count);
  begun_.resize(count);
  reaches_.resize(count);
  gains_.resize(count);
  loads_.resize(count);
  Clear();
  impact_.BeginStep(count);
  if (!FindFreeBodies(start, cache, pool)) return;
  FindIslands();
  FindCandidates(start, cache, pool);
}

ContactPhase ImpactSolver::PhaseOf(const ContactPair& pair,
                                   std::span<const RigidBody> bodies,
                                   const ImpactRules& rules) const {
  const RigidBody& A = bodies[At(pair.A)];
  const RigidBody& B = bodies[At(pair.B)];
  const Eigen::Vector3d a_AB_W = loads_[At(pair.B)] - loads_[At(pair.A)];
  const double load = LoadOn(pair, A, B);
  if (SurelyHolds(pair.manifold, A, B, load, rules)) return ContactPhase::kResting;
  ContactPhase all = ContactPhase::kImpacting;
  for (const ContactPoint& contact : pair.manifold.points()) {
    const ContactPhase one =
        PhaseAt(contact.p_WC, pair.manifold.n_AB_W, A, B, a_AB_W, load, rules);
    if (one == ContactPhase::kImpacting) continue;
    // What overlaps has to be parted, unless it strikes.
    if (one == ContactPhase::kResting ||
        contact.separation < -SpeculativeMarginBetween(A, B) - TouchOf(A, B)) {
      return ContactPhase::kResting;
    }
    all = ContactPhase::kSeparating;
  }
  return all;
}

void ImpactSolver::FindTouching(const ContactCache& cache,
                                std::span<const RigidBody> bodies, ThreadPool& pool) {
  const std::span<const ContactPair> contacts = cache.contacts();
  const std::span<const ContactEdge> edges = cache.edges();
  // A little more than Follow() asks for: what flies and is no impact there would sink
  // in.
  ImpactRules surely = rules_;
  surely.resting_speed *= kSurely;
  touching_.resize(edges.size());
  // What one contact holds is held whatever the others do: of two that are, by whichever
  // contacts threads have looked at by now, nothing more is asked.
  const auto flies = [&](int body) {
    return std::atomic_ref(in_free_flight_[At(body)]).load(std::memory_order_relaxed) !=
           0;
  };
  const auto hold = [&](int body) {
    std::atomic_ref(in_free_flight_[At(body)]).store(0, std::memory_order_relaxed);
  };
  pool.ParallelFor(edges.size(), kFewPairs, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      if (k + kAhead < end) {
        for (const int next : {edges[k + kAhead].A, edges[k + kAhead].B}) {
          if (!flies(next)) continue;
          Prefetch(&bodies[At(next)].state, offsetof(RigidBody, R_WB));
          Prefetch(&loads_[At(next)], sizeof(Eigen::Vector3d));
        }
      }
      const ContactEdge& edge = edges[k];
      ContactPhase meeting = ContactPhase::kSeparating;
      if (flies(edge.A) || flies(edge.B)) {
        meeting = PhaseOf(contacts[k], bodies, surely);
      }
      touching_[k] = {edge.A, edge.B, meeting};
      if (meeting != ContactPhase::kResting) continue;
      hold(edge.A);
      hold(edge.B);
    }
  });
}

bool ImpactSolver::FindFreeBodies(const Start& start, ContactCache& cache,
                                  ThreadPool& pool) {
  pool.ParallelFor(
      start.bodies.size(), kFewBodies, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          const RigidBody& body = start.bodies[i];
          static_[i] = body.is_static() ? 1 : 0;
          asleep_[i] = start.asleep[i] ? 1 : 0;
          linked_[i] = start.linked[i] ? 1 : 0;
          in_free_flight_[i] =
              !body.is_static() && !body.is_point && !start.linked[i] ? 1 : 0;
          loads_[i].setZero();
          if (!static_[i]) loads_[i] = (start.free[i].v - start.before[i].v) / rules_.h;
          reaches_[i] = MaxTravel(body, start.free[i].v, rules_.h);
        }
      });
  FindTouching(cache, start.bodies, pool);
  const auto any_flies = [&] {
    return std::find(in_free_flight_.begin(), in_free_flight_.end(), 1) !=
           in_free_flight_.end();
  };
  if (!any_flies()) return false;
  // What touches a body that is held is held, and what touches that; not what strikes.
  islands_.Reset(in_free_flight_.size());
  strikers_.clear();
  for (const Touching& pair : touching_) {
    if (IsStatic(pair.A) || IsStatic(pair.B)) continue;
    if (pair.meeting == ContactPhase::kImpacting &&
        (IsInFreeFlight(pair.A) || IsInFreeFlight(pair.B))) {
      strikers_.emplace_back(pair.A, pair.B);
    } else {
      islands_.Unite(pair.A, pair.B);
    }
  }
  max_island_size_ = start.is_large ? kMaxIslandSizeOfMany : kMaxIslandSize;
  if (!strikers_.empty()) HoldStrikersOfLargeIslands();
  island_ = islands_.Roots();
  holds_.assign(in_free_flight_.size(), 0);
  for (std::size_t i = 0; i < island_.size(); ++i) {
    if (!in_free_flight_[i] && !static_[i]) holds_[At(island_[i])] = 1;
  }
  for (std::size_t i = 0; i < island_.size(); ++i) {
    if (holds_[At(island_[i])]) in_free_flight_[i] = 0;
  }
  for (std::size_t k = 0; k < touching_.size(); ++k) {
    if (!IsInFreeFlight(touching_[k].A) && !IsInFreeFlight(touching_[k].B)) continue;
    cache.Release(k);
  }
  return any_flies();
}

void ImpactSolver::HoldStrikersOfLargeIslands() {
  crowds_ = islands_;
  for (const auto& [A, B] : strikers_) crowds_.Unite(A, B);
  island_ = crowds_.Roots();
  MeasureIslands();
  for (const auto& [A, B] : strikers_) {
    if (island_size_[At(island_[At(A)])] > max_island_size_) islands_.Unite(A, B);
  }
}

void ImpactSolver::BeginFlight(int body, const Start& start) {
  // In its place: a whole body is not copied twice.
  FreeFlight& flight = flights_[At(body)];
  flight.start = start.bodies[At(body)];
  flight.from = 0;
  flight.load_W = loads_[At(body)];
  flight.a_W.setZero();
  flight.torque_W.setZero();
  if (!IsInFreeFlight(body)) return;
  flight.a_W = loads_[At(body)];
  flight.torque_W = flight.start.Torque_W();
}

void ImpactSolver::FindCandidates(const Start& start, const ContactCache& cache,
                                  ThreadPool& pool) {
  near_.Clear(pool.chunk_count());
  const auto is_asked = [&](int A, int B) {
    return (IsInFreeFlight(A) || IsInFreeFlight(B)) && IslandOf(A) <= kMaxIslandSize &&
           IslandOf(B) <= kMaxIslandSize;
  };
  pool.ParallelForIndexed(cache.near_count(), kFewNear,
                          [&](std::size_t chunk, std::size_t begin, std::size_t end) {
                            cache.ForEachGap(
                                begin, end, is_asked, [&](int A, int B, double gap) {
                                  if (gap > reaches_[At(A)] + reaches_[At(B)]) return;
                                  near_[chunk].push_back({A, B, gap});
                                });
                          });
  std::fill(begun_.begin(), begun_.end(), 0);
  beginning_.clear();
  queue_.Begin(start.bodies.size());
  near_.ForEach([&](const Near& pair) {
    for (const int body : {pair.A, pair.B}) {
      if (!std::exchange(begun_[At(body)], 1)) beginning_.push_back(body);
    }
    queue_.Append(pair.A, pair.B, pair.gap);
  });
  pool.ParallelFor(beginning_.size(), kFewMeetings,
                   [&](std::size_t begin, std::size_t end) {
                     for (std::size_t k = begin; k < end; ++k)
                       BeginFlight(beginning_[k], start);
                   });
}

void ImpactSolver::FindIslands() {
  // What strikes and is held after all presses too.
  for (const auto& [A, B] : strikers_) {
    if (IsHeld(A) && IsHeld(B)) islands_.Unite(A, B);
  }
  island_ = islands_.Roots();
  MeasureIslands();
}

void ImpactSolver::ListIslands(std::span<const ContactEdge> contacts) {
  // The last contact first, so that the list of a island has them in their order.
  first_of_island_.assign(in_free_flight_.size(), -1);
  next_of_island_.resize(contacts.size());
  for (int k = static_cast<int>(contacts.size()) - 1; k >= 0; --k) {
    const ContactEdge& edge = contacts[At(k)];
    if (edge.count == 0) continue;
    const int moving = IsStatic(edge.A) ? edge.B : edge.A;
    next_of_island_[At(k)] = std::exchange(first_of_island_[At(island_[At(moving)])], k);
  }
}

void ImpactSolver::MeasureIslands() {
  island_size_.assign(in_free_flight_.size(), 0);
  for (std::size_t i = 0; i < in_free_flight_.size(); ++i) {
    int& size = island_size_[At(island_[i])];
    // What rods and springs hold is not asked either.
    size += linked_[i] ? kMaxIslandSize + 1 : 1;
  }
}

void ImpactSolver::Follow(std::span<RigidBody> bodies, std::span<const Velocity> mean,
                          ContactCache& cache, const Settings& settings,
                          ThreadPool& pool) {
  if (queue_.size() == 0) return;
  const End end{bodies, mean, cache.contacts(), cache.edges()};
  islands_are_listed_ = false;
  for (int index = 0; index < queue_.size(); ++index) {
    for (const int body : {queue_[index].A, queue_[index].B}) {
      if (!IsHeld(body)) continue;
      FreeFlight& flight = flights_[At(body)];
      flight.start.state.v_WB = mean[At(body)].v;
      flight.start.state.w_WB = mean[At(body)].w;
    }
  }
  ScheduleAll(pool);
  for (int first = queue_.TakeNext(); first >= 0; first = queue_.TakeNext()) {
    const double t = queue_[first].next;
    Strike(queue_[first], end, settings, pool);
    for (const int body : impact_.members()) {
      if (!IsStatic(body)) Widen(body, t, end, cache);
    }
    impact_.Clear();
  }
  EndSupports();
  for (std::size_t i = 0; i < impacts_.size(); ++i) {
    if (impacts_[i] == 0) continue;
    const BodyState landed = flights_[i].At(rules_.h, rules_.gyroscopic).state;
    const BodyState before = bodies[i].state;
    bodies[i].state = landed;
    if (!in_free_flight_[i]) {
      bodies[i].state.v_WB = before.v_WB + gains_[i].v;
      bodies[i].state.w_WB = before.w_WB + gains_[i].w;
    }
    bodies[i].R_WB = landed.q_WB.toRotationMatrix();
    cache.AddTravel(i, Travel(before, bodies[i]));
  }
}

bool ImpactSolver::ComeNear(const ImpactCandidate& candidate) const {
  const FreeFlight& A = flights_[At(candidate.A)];
  const FreeFlight& B = flights_[At(candidate.B)];
  const double h = rules_.h;
  const double way = h * (B.start.state.v_WB - A.start.state.v_WB).norm() +
                     0.5 * h * h * (B.a_W - A.a_W).norm() +
                     h * (RotationalSpeed(A.start) + RotationalSpeed(B.start));
  return candidate.gap <= way;
}

bool ImpactSolver::IsAsked(const ImpactCandidate& candidate) const {
  int island = 0;
  for (const int body : {candidate.A, candidate.B}) {
    if (IsInFreeFlight(body) && impacts_[At(body)] >= kMaxImpacts) return false;
    island = std::max(island, IslandOf(body));
  }
  const Eigen::Vector3d v_AB_W = flights_[At(candidate.B)].start.state.v_WB -
                                 flights_[At(candidate.A)].start.state.v_WB;
  return island <= max_island_size_ ||
         (island <= kMaxIslandSize &&
          MayGoThrough(flights_[At(candidate.A)].start, flights_[At(candidate.B)].start,
                       rules_.h * v_AB_W.norm()));
}

double ImpactSolver::NextImpact(double from, const ImpactCandidate& candidate) const {
  if (!IsAsked(candidate)) return kNever;
  const FreeFlight& A = flights_[At(candidate.A)];
  const FreeFlight& B = flights_[At(candidate.B)];
  return TimeOfImpact(A, B, from, rules_).value_or(kNever);
}

void ImpactSolver::Schedule(double from, int index) {
  queue_.Schedule(index, NextImpact(from, queue_[index]));
}

void ImpactSolver::ScheduleAll(ThreadPool& pool) {
  first_impacts_.resize(At(queue_.size()));
  pool.ParallelFor(
      first_impacts_.size(), kFewMeetings, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
          const ImpactCandidate& candidate = queue_[static_cast<int>(k)];
          first_impacts_[k] = ComeNear(candidate) ? NextImpact(0, candidate) : kNever;
        }
      });
  for (int index = 0; index < queue_.size(); ++index) {
    queue_.Schedule(index, first_impacts_[At(index)]);
  }
}

void ImpactSolver::Join(int body, double t) {
  if (!impact_.IsIn(body)) impact_.Add(body, flights_[At(body)].At(t, rules_.gyroscopic));
}

void ImpactSolver::TraceBack(int body, const End& end) {
  begun_[At(body)] = 1;
  FreeFlight& flight = flights_[At(body)];
  flight = {end.bodies[At(body)], rules_.h};
  flight.load_W = loads_[At(body)];
  if (IsInFreeFlight(body)) {
    flight.a_W = loads_[At(body)];
    flight.torque_W = flight.start.Torque_W();
  } else if (!IsStatic(body)) {
    flight.start.state.v_WB = end.mean[At(body)].v;
    flight.start.state.w_WB = end.mean[At(body)].w;
  }
}

void ImpactSolver::Widen(int body, double t, const End& end, ContactCache& cache) {
  const FreeFlight& flight = flights_[At(body)];
  const double left = rules_.h - t;
  const double way =
      MaxTravel(flight.start, flight.start.state.v_WB + left * flight.a_W, left);
  double& reach = reaches_[At(body)];
  if (way <= reach * left / rules_.h) return;
  reach = way * rules_.h / left;
  met_.clear();
  cache.Widen(body, flight.start, way + flight.start.speculative_margin, met_);
  for (const int other : met_) {
    if (IslandOf(body) > kMaxIslandSize || IslandOf(other) > kMaxIslandSize) continue;
    if (!IsInFreeFlight(body) && !IsInFreeFlight(other)) continue;
    // It is static in this step, and wakes for the next.
    if (asleep_[At(other)]) continue;
    bool known = false;
    queue_.ForEachOf(body, [&](int index) {
      known = known || queue_[index].A == other || queue_[index].B == other;
    });
    if (known) continue;
    if (!begun_[At(other)]) TraceBack(other, end);
    queue_.Append(std::min(body, other), std::max(body, other), 0);
    Schedule(t, queue_.size() - 1);
  }
}

void ImpactSolver::JoinIsland(int body, double t, const End& end) {
  const auto join = [&](int member) {
    if (!impact_.IsIn(member) && impacts_[At(member)] == 0) TraceBack(member, end);
    Join(member, t);
  };
  join(body);
  if (!std::exchange(islands_are_listed_, true)) ListIslands(end.edges);
  for (int k = first_of_island_[At(island_[At(body)])]; k >= 0;
       k = next_of_island_[At(k)]) {
    const ContactPair& contact = end.contacts[At(k)];
    join(contact.A);
    join(contact.B);
    impact_.Add(contact);
  }
}

void ImpactSolver::Gather(double t, const End& end) {
  const auto join = [&](int body) {
    if (IsHeld(body) && !impact_.IsIn(body)) JoinIsland(body, t, end);
    Join(body, t);
  };
  // Candidates are looked at in their order; those that a body brings which joins after
  // their turn, in the next look.
  looks_.clear();
  later_.clear();
  std::size_t brought = 0;
  const auto bring = [&](int after) {
    for (; brought < impact_.members().size(); ++brought) {
      const int body = impact_.members()[brought];
      if (IsStatic(body)) continue;
      queue_.ForEachOf(body, [&](int index) {
        std::vector<int>& island = index > after ? looks_ : later_;
        island.push_back(index);
        std::push_heap(island.begin(), island.end(), std::greater<>());
      });
    }
  };
  for (bring(-1); !looks_.empty(); looks_.empty() ? looks_.swap(later_) : void()) {
    std::pop_heap(looks_.begin(), looks_.end(), std::greater<>());
    const int index = looks_.back();
    looks_.pop_back();
    ImpactCandidate& candidate = queue_[index];
    if (std::exchange(candidate.known, true) || !IsAsked(candidate)) continue;
    const auto room_of = [&](int body) {
      return impact_.IsIn(body) ? impact_.BodyOf(body)
                                : flights_[At(body)].ShapeAt(t, rules_.gyroscopic);
    };
    ContactPair pair;
    pair.manifold = CollideAtImpact(room_of(candidate.A), room_of(candidate.B));
    if (pair.manifold.count == 0) continue;
    pair.A = candidate.A;
    pair.B = candidate.B;
    join(pair.A);
    join(pair.B);
    impact_.Add(pair);
    bring(index);
  }
}

void ImpactSolver::Strike(const ImpactCandidate& first, const End& end,
                          const Settings& settings, ThreadPool& pool) {
  const double t = first.next;
  // The flying one brings the other.
  Join(IsInFreeFlight(first.A) ? first.A : first.B, t);
  Gather(t, end);
  const std::size_t first_struck = struck_.size();
  impact_.Exchange(settings, rules_.h, pool, struck_);
  LetFly(t);
  SupportSince(first_struck, t);
  for (const int body : impact_.members()) {
    if (IsStatic(body)) continue;
    queue_.ForEachOf(body, [&](int index) {
      if (std::exchange(queue_[index].known, false)) Schedule(t, index);
    });
  }
}

void ImpactSolver::LetFly(double t) {
  for (std::size_t k = 0; k < impact_.members().size(); ++k) {
    const int body = impact_.members()[k];
    if (IsStatic(body)) continue;
    FreeFlight& flight = flights_[At(body)];
    flight.start = impact_.BodyOf(body);
    flight.start.state.v_WB = impact_.After(k).v;
    flight.start.state.w_WB = impact_.After(k).w;
    flight.from = t;
    if (IsInFreeFlight(body)) flight.a_W = loads_[At(body)];
    for (Support& support : supports_) {
      if (support.body == body) support.until = std::min(support.until, t);
    }
    Velocity& gain = gains_[At(body)];
    if (impacts_[At(body)] == 0) gain = {};
    gain.v += impact_.Gain(k).v;
    gain.w += impact_.Gain(k).w;
    ++impacts_[At(body)];
  }
}

void ImpactSolver::SupportSince(std::size_t first, double t) {
  for (std::size_t k = first; k < struck_.size(); ++k) {
    const ContactPair& pair = struck_[k];
    const bool A_rests = IsInFreeFlight(pair.A) && IsStatic(pair.B);
    if (!A_rests && !(IsInFreeFlight(pair.B) && IsStatic(pair.A))) continue;
    const int body = A_rests ? pair.A : pair.B;
    const Eigen::Vector3d n_W = (A_rests ? -1 : 1) * pair.manifold.n_AB_W;
    FreeFlight& flight = flights_[At(body)];
    const BodyState& state = flight.start.state;
    // What still rises or falls about its contacts is not at rest: a support would do
    // work on it.
    const double stopped = kStopped * impact_.scale();
    if (std::abs(n_W.dot(state.v_WB)) > stopped) continue;
    const auto points = pair.manifold.points();
    const bool rests =
        std::all_of(points.begin(), points.end(), [&](const ContactPoint& contact) {
          const Eigen::Vector3d r = contact.p_WC - state.p_WB;
          return std::abs(n_W.dot(state.w_WB.cross(r))) <= stopped;
        });
    const double load = n_W.dot(flight.a_W);
    if (!rests || load >= 0) continue;
    flight.a_W -= load * n_W;
    const double force = -load / flight.start.inverse_mass;
    supports_.push_back({body, k, force * pair.manifold.n_AB_W, t, rules_.h});
  }
}

void ImpactSolver::EndSupports() {
  for (const Support& support : supports_) {
    ContactPair& pair = struck_[support.pair];
    const Eigen::Vector3d J_W = (support.until - support.from) * support.force_B_W;
    const std::size_t count = pair.manifold.points().size();
    for (std::size_t i = 0; i < count; ++i) {
      pair.J_W[i] += J_W / static_cast<double>(count);
    }
  }
}

}  // namespace cookbook
