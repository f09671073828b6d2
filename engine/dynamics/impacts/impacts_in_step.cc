#include "engine/dynamics/impacts/impacts_in_step.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>
#include <limits>

#include "engine/threads/prefetch.h"

namespace cookbook {
namespace {

/** Blows of a body in a step after which it flies on through what it meets: the next step
 sends it back. */
constexpr int kMostBlows = 8;

/** Bodies of a heap that takes part in a blow: that costs as much as a step of the heap.
 */
constexpr int kMostOfHeap = 32;
/** The same in a large world, whose blows are too many to be solved: a heap that a blow
 leaves half solved sinks deeper than what strikes it is late. Not of what would be
 through the heap by the next step. */
constexpr int kMostOfHeapOfMany = 4;

/** What a blow leaves of an approach, as a share of the speeds, where it sends nothing
 back: rounding, and what the solver leaves. */
constexpr double kStopped = 1e-9;

/** How much faster than a blow has to be what flies from within the margin. */
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

/** Returns true where some contact of a pair holds for sure, as MeetingAt() says, without
 a branch for each contact, which nothing foretells: how fast two bodies approach at p, u
 = n · (v_B + ω_B × (p − x_B) − v_A − ω_A × (p − x_A)), is linear in p. What that rounds
 is far below kTogether of the speeds. */
bool SurelyHolds(const Manifold& manifold, const RigidBody& A, const RigidBody& B,
                 double pull, const BlowRules& rules) {
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
         fastest > -0.999 * rules.resting_speed * rules.h * pull;
}

}  // namespace

Blows::Blows() {
  // Of most blows of most steps: from then on they allocate nothing.
  constexpr std::size_t kMany = 64;
  struck_.reserve(kMany);
  supports_.reserve(kMany);
  met_.reserve(kMany);
}

void Blows::Clear() {
  std::fill(blows_.begin(), blows_.end(), 0);
  struck_.clear();
  supports_.clear();
  meetings_.Clear();
}

void Blows::Begin(const Start& start, ContactFinder& finder, const Settings& settings,
                  double h, Crew& crew) {
  rules_ = {h, settings.resting_speed, settings.gyroscopic};
  const std::size_t count = start.bodies.size();
  flies_.resize(count);
  static_.resize(count);
  asleep_.resize(count);
  linked_.resize(count);
  blows_.resize(count);
  flights_.resize(count);
  begun_.resize(count);
  reaches_.resize(count);
  gains_.resize(count);
  pulls_.resize(count);
  Clear();
  blow_.BeginStep(count);
  if (!FindFlying(start, finder, crew)) return;
  FindHeaps();
  FindCandidates(start, finder, crew);
}

Meeting Blows::MeetingOf(const ContactPair& pair, std::span<const RigidBody> bodies,
                         const BlowRules& rules) const {
  const RigidBody& A = bodies[At(pair.A)];
  const RigidBody& B = bodies[At(pair.B)];
  const Eigen::Vector3d a_AB_W = pulls_[At(pair.B)] - pulls_[At(pair.A)];
  const double pull = PullOn(pair, A, B);
  if (SurelyHolds(pair.manifold, A, B, pull, rules)) return Meeting::kHolds;
  Meeting all = Meeting::kStrikes;
  for (const ContactPoint& contact : pair.manifold.points()) {
    const Meeting one =
        MeetingAt(contact.p_WC, pair.manifold.n_AB_W, A, B, a_AB_W, pull, rules);
    if (one == Meeting::kStrikes) continue;
    // What overlaps has to be parted, unless it strikes.
    if (one == Meeting::kHolds ||
        contact.separation < -MarginBetween(A, B) - TouchOf(A, B)) {
      return Meeting::kHolds;
    }
    all = Meeting::kParts;
  }
  return all;
}

void Blows::FindTouching(const ContactFinder& finder, std::span<const RigidBody> bodies,
                         Crew& crew) {
  const std::span<const ContactPair> contacts = finder.contacts();
  const std::span<const ContactEdge> edges = finder.edges();
  // A little more than Follow() asks for: what flies and is no blow there would sink in.
  BlowRules surely = rules_;
  surely.resting_speed *= kSurely;
  touching_.resize(edges.size());
  // What one contact holds is held whatever the others do: of two that are, by whichever
  // contacts threads have looked at by now, nothing more is asked.
  const auto flies = [&](int body) {
    return std::atomic_ref(flies_[At(body)]).load(std::memory_order_relaxed) != 0;
  };
  const auto hold = [&](int body) {
    std::atomic_ref(flies_[At(body)]).store(0, std::memory_order_relaxed);
  };
  crew.Share(edges.size(), kFewPairs, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      if (k + kAhead < end) {
        for (const int next : {edges[k + kAhead].A, edges[k + kAhead].B}) {
          if (!flies(next)) continue;
          Fetch(&bodies[At(next)].state, offsetof(RigidBody, R_WB));
          Fetch(&pulls_[At(next)], sizeof(Eigen::Vector3d));
        }
      }
      const ContactEdge& edge = edges[k];
      Meeting meeting = Meeting::kParts;
      if (flies(edge.A) || flies(edge.B)) {
        meeting = MeetingOf(contacts[k], bodies, surely);
      }
      touching_[k] = {edge.A, edge.B, meeting};
      if (meeting != Meeting::kHolds) continue;
      hold(edge.A);
      hold(edge.B);
    }
  });
}

bool Blows::FindFlying(const Start& start, ContactFinder& finder, Crew& crew) {
  crew.Share(start.bodies.size(), kFewBodies, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const RigidBody& body = start.bodies[i];
      static_[i] = body.is_static() ? 1 : 0;
      asleep_[i] = start.asleep[i] ? 1 : 0;
      linked_[i] = start.linked[i] ? 1 : 0;
      flies_[i] = !body.is_static() && !body.is_point && !start.linked[i] ? 1 : 0;
      pulls_[i].setZero();
      if (!static_[i]) pulls_[i] = (start.free[i].v - start.before[i].v) / rules_.h;
      reaches_[i] = Reach(body, start.free[i].v, rules_.h);
    }
  });
  FindTouching(finder, start.bodies, crew);
  const auto any_flies = [&] {
    return std::find(flies_.begin(), flies_.end(), 1) != flies_.end();
  };
  if (!any_flies()) return false;
  // What touches a body that is held is held, and what touches that; not what strikes.
  heaps_.Reset(flies_.size());
  strikers_.clear();
  for (const Touching& pair : touching_) {
    if (IsStatic(pair.A) || IsStatic(pair.B)) continue;
    if (pair.meeting == Meeting::kStrikes && (Flies(pair.A) || Flies(pair.B))) {
      strikers_.emplace_back(pair.A, pair.B);
    } else {
      heaps_.Join(pair.A, pair.B);
    }
  }
  most_of_heap_ = start.is_large ? kMostOfHeapOfMany : kMostOfHeap;
  if (!strikers_.empty()) HoldStrikersOfLargeHeaps();
  heap_ = heaps_.All();
  holds_.assign(flies_.size(), 0);
  for (std::size_t i = 0; i < heap_.size(); ++i) {
    if (!flies_[i] && !static_[i]) holds_[At(heap_[i])] = 1;
  }
  for (std::size_t i = 0; i < heap_.size(); ++i) {
    if (holds_[At(heap_[i])]) flies_[i] = 0;
  }
  for (std::size_t k = 0; k < touching_.size(); ++k) {
    if (!Flies(touching_[k].A) && !Flies(touching_[k].B)) continue;
    finder.Release(k);
  }
  return any_flies();
}

void Blows::HoldStrikersOfLargeHeaps() {
  crowds_ = heaps_;
  for (const auto& [A, B] : strikers_) crowds_.Join(A, B);
  heap_ = crowds_.All();
  MeasureHeaps();
  for (const auto& [A, B] : strikers_) {
    if (heap_size_[At(heap_[At(A)])] > most_of_heap_) heaps_.Join(A, B);
  }
}

void Blows::BeginFlight(int body, const Start& start) {
  // In its place: a whole body is not copied twice.
  BodyFlight& flight = flights_[At(body)];
  flight.start = start.bodies[At(body)];
  flight.from = 0;
  flight.pull_W = pulls_[At(body)];
  flight.a_W.setZero();
  flight.torque_W.setZero();
  if (!Flies(body)) return;
  flight.a_W = pulls_[At(body)];
  flight.torque_W = flight.start.Torque_W();
}

void Blows::FindCandidates(const Start& start, const ContactFinder& finder, Crew& crew) {
  near_.Clear(crew.shares());
  const auto is_asked = [&](int A, int B) {
    return (Flies(A) || Flies(B)) && HeapOf(A) <= kMostOfHeap && HeapOf(B) <= kMostOfHeap;
  };
  crew.ShareOut(finder.near_count(), kFewNear,
                [&](std::size_t share, std::size_t begin, std::size_t end) {
                  finder.ForEachGap(begin, end, is_asked, [&](int A, int B, double gap) {
                    if (gap > reaches_[At(A)] + reaches_[At(B)]) return;
                    near_.Of(share).push_back({A, B, gap});
                  });
                });
  std::fill(begun_.begin(), begun_.end(), 0);
  beginning_.clear();
  meetings_.Begin(start.bodies.size());
  near_.ForEach([&](const Near& pair) {
    for (const int body : {pair.A, pair.B}) {
      if (!std::exchange(begun_[At(body)], 1)) beginning_.push_back(body);
    }
    meetings_.Append(pair.A, pair.B, pair.gap);
  });
  crew.Share(beginning_.size(), kFewMeetings, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) BeginFlight(beginning_[k], start);
  });
}

void Blows::FindHeaps() {
  // What strikes and is held after all presses too.
  for (const auto& [A, B] : strikers_) {
    if (IsHeld(A) && IsHeld(B)) heaps_.Join(A, B);
  }
  heap_ = heaps_.All();
  MeasureHeaps();
}

void Blows::ListHeaps(std::span<const ContactEdge> contacts) {
  // The last contact first, so that the list of a heap has them in their order.
  first_of_heap_.assign(flies_.size(), -1);
  next_of_heap_.resize(contacts.size());
  for (int k = static_cast<int>(contacts.size()) - 1; k >= 0; --k) {
    const ContactEdge& edge = contacts[At(k)];
    if (edge.count == 0) continue;
    const int moving = IsStatic(edge.A) ? edge.B : edge.A;
    next_of_heap_[At(k)] = std::exchange(first_of_heap_[At(heap_[At(moving)])], k);
  }
}

void Blows::MeasureHeaps() {
  heap_size_.assign(flies_.size(), 0);
  for (std::size_t i = 0; i < flies_.size(); ++i) {
    int& size = heap_size_[At(heap_[i])];
    // What rods and springs hold is not asked either.
    size += linked_[i] ? kMostOfHeap + 1 : 1;
  }
}

void Blows::Follow(std::span<RigidBody> bodies, std::span<const Velocity> mean,
                   ContactFinder& finder, const Settings& settings, Crew& crew) {
  if (meetings_.size() == 0) return;
  const End end{bodies, mean, finder.contacts(), finder.edges()};
  heaps_are_listed_ = false;
  for (int index = 0; index < meetings_.size(); ++index) {
    for (const int body : {meetings_[index].A, meetings_[index].B}) {
      if (!IsHeld(body)) continue;
      BodyFlight& flight = flights_[At(body)];
      flight.start.state.v_WB = mean[At(body)].v;
      flight.start.state.w_WB = mean[At(body)].w;
    }
  }
  ForeseeAll(crew);
  for (int first = meetings_.TakeNext(); first >= 0; first = meetings_.TakeNext()) {
    const double t = meetings_[first].next;
    Strike(meetings_[first], end, settings, crew);
    for (const int body : blow_.members()) {
      if (!IsStatic(body)) Widen(body, t, end, finder);
    }
    blow_.Clear();
  }
  EndSupports();
  for (std::size_t i = 0; i < blows_.size(); ++i) {
    if (blows_[i] == 0) continue;
    const BodyState landed = flights_[i].At(rules_.h, rules_.gyroscopic).state;
    const BodyState before = bodies[i].state;
    bodies[i].state = landed;
    if (!flies_[i]) {
      bodies[i].state.v_WB = before.v_WB + gains_[i].v;
      bodies[i].state.w_WB = before.w_WB + gains_[i].w;
    }
    bodies[i].R_WB = landed.q_WB.toRotationMatrix();
    finder.HasGone(i, Travel(before, bodies[i]));
  }
}

bool Blows::ComeNear(const Candidate& candidate) const {
  const BodyFlight& A = flights_[At(candidate.A)];
  const BodyFlight& B = flights_[At(candidate.B)];
  const double h = rules_.h;
  const double way = h * (B.start.state.v_WB - A.start.state.v_WB).norm() +
                     0.5 * h * h * (B.a_W - A.a_W).norm() +
                     h * (TurningSpeed(A.start) + TurningSpeed(B.start));
  return candidate.gap <= way;
}

bool Blows::IsAsked(const Candidate& candidate) const {
  int heap = 0;
  for (const int body : {candidate.A, candidate.B}) {
    if (Flies(body) && blows_[At(body)] >= kMostBlows) return false;
    heap = std::max(heap, HeapOf(body));
  }
  const Eigen::Vector3d v_AB_W = flights_[At(candidate.B)].start.state.v_WB -
                                 flights_[At(candidate.A)].start.state.v_WB;
  return heap <= most_of_heap_ ||
         (heap <= kMostOfHeap &&
          MayGoThrough(flights_[At(candidate.A)].start, flights_[At(candidate.B)].start,
                       rules_.h * v_AB_W.norm()));
}

double Blows::NextMeeting(double from, const Candidate& candidate) const {
  if (!IsAsked(candidate)) return kNever;
  const BodyFlight& A = flights_[At(candidate.A)];
  const BodyFlight& B = flights_[At(candidate.B)];
  return FirstBlow(A, B, from, rules_).value_or(kNever);
}

void Blows::Foresee(double from, int index) {
  meetings_.Foresee(index, NextMeeting(from, meetings_[index]));
}

void Blows::ForeseeAll(Crew& crew) {
  foreseen_.resize(At(meetings_.size()));
  crew.Share(foreseen_.size(), kFewMeetings, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const Candidate& candidate = meetings_[static_cast<int>(k)];
      foreseen_[k] = ComeNear(candidate) ? NextMeeting(0, candidate) : kNever;
    }
  });
  for (int index = 0; index < meetings_.size(); ++index) {
    meetings_.Foresee(index, foreseen_[At(index)]);
  }
}

void Blows::Join(int body, double t) {
  if (!blow_.IsIn(body)) blow_.Add(body, flights_[At(body)].At(t, rules_.gyroscopic));
}

void Blows::TraceBack(int body, const End& end) {
  begun_[At(body)] = 1;
  BodyFlight& flight = flights_[At(body)];
  flight = {end.bodies[At(body)], rules_.h};
  flight.pull_W = pulls_[At(body)];
  if (Flies(body)) {
    flight.a_W = pulls_[At(body)];
    flight.torque_W = flight.start.Torque_W();
  } else if (!IsStatic(body)) {
    flight.start.state.v_WB = end.mean[At(body)].v;
    flight.start.state.w_WB = end.mean[At(body)].w;
  }
}

void Blows::Widen(int body, double t, const End& end, ContactFinder& finder) {
  const BodyFlight& flight = flights_[At(body)];
  const double left = rules_.h - t;
  const double way =
      Reach(flight.start, flight.start.state.v_WB + left * flight.a_W, left);
  double& reach = reaches_[At(body)];
  if (way <= reach * left / rules_.h) return;
  reach = way * rules_.h / left;
  met_.clear();
  finder.Widen(body, flight.start, way + flight.start.margin, met_);
  for (const int other : met_) {
    if (HeapOf(body) > kMostOfHeap || HeapOf(other) > kMostOfHeap) continue;
    if (!Flies(body) && !Flies(other)) continue;
    // It is static in this step, and wakes for the next.
    if (asleep_[At(other)]) continue;
    bool known = false;
    meetings_.ForEachOf(body, [&](int index) {
      known = known || meetings_[index].A == other || meetings_[index].B == other;
    });
    if (known) continue;
    if (!begun_[At(other)]) TraceBack(other, end);
    meetings_.Append(std::min(body, other), std::max(body, other), 0);
    Foresee(t, meetings_.size() - 1);
  }
}

void Blows::JoinHeap(int body, double t, const End& end) {
  const auto join = [&](int member) {
    if (!blow_.IsIn(member) && blows_[At(member)] == 0) TraceBack(member, end);
    Join(member, t);
  };
  join(body);
  if (!std::exchange(heaps_are_listed_, true)) ListHeaps(end.edges);
  for (int k = first_of_heap_[At(heap_[At(body)])]; k >= 0; k = next_of_heap_[At(k)]) {
    const ContactPair& contact = end.contacts[At(k)];
    join(contact.A);
    join(contact.B);
    blow_.Add(contact);
  }
}

void Blows::Gather(double t, const End& end) {
  const auto join = [&](int body) {
    if (IsHeld(body) && !blow_.IsIn(body)) JoinHeap(body, t, end);
    Join(body, t);
  };
  // Candidates are looked at in their order; those that a body brings which joins after
  // their turn, in the next look.
  looks_.clear();
  later_.clear();
  std::size_t brought = 0;
  const auto bring = [&](int after) {
    for (; brought < blow_.members().size(); ++brought) {
      const int body = blow_.members()[brought];
      if (IsStatic(body)) continue;
      meetings_.ForEachOf(body, [&](int index) {
        std::vector<int>& heap = index > after ? looks_ : later_;
        heap.push_back(index);
        std::push_heap(heap.begin(), heap.end(), std::greater<>());
      });
    }
  };
  for (bring(-1); !looks_.empty(); looks_.empty() ? looks_.swap(later_) : void()) {
    std::pop_heap(looks_.begin(), looks_.end(), std::greater<>());
    const int index = looks_.back();
    looks_.pop_back();
    Candidate& candidate = meetings_[index];
    if (std::exchange(candidate.known, true) || !IsAsked(candidate)) continue;
    const auto room_of = [&](int body) {
      return blow_.IsIn(body) ? blow_.BodyOf(body)
                              : flights_[At(body)].RoomAt(t, rules_.gyroscopic);
    };
    ContactPair pair;
    pair.manifold = CollideAtBlow(room_of(candidate.A), room_of(candidate.B));
    if (pair.manifold.count == 0) continue;
    pair.A = candidate.A;
    pair.B = candidate.B;
    join(pair.A);
    join(pair.B);
    blow_.Add(pair);
    bring(index);
  }
}

void Blows::Strike(const Candidate& first, const End& end, const Settings& settings,
                   Crew& crew) {
  const double t = first.next;
  // The flying one brings the other.
  Join(Flies(first.A) ? first.A : first.B, t);
  Gather(t, end);
  const std::size_t first_struck = struck_.size();
  blow_.Exchange(settings, rules_.h, crew, struck_);
  LetFly(t);
  SupportSince(first_struck, t);
  for (const int body : blow_.members()) {
    if (IsStatic(body)) continue;
    meetings_.ForEachOf(body, [&](int index) {
      if (std::exchange(meetings_[index].known, false)) Foresee(t, index);
    });
  }
}

void Blows::LetFly(double t) {
  for (std::size_t k = 0; k < blow_.members().size(); ++k) {
    const int body = blow_.members()[k];
    if (IsStatic(body)) continue;
    BodyFlight& flight = flights_[At(body)];
    flight.start = blow_.BodyOf(body);
    flight.start.state.v_WB = blow_.After(k).v;
    flight.start.state.w_WB = blow_.After(k).w;
    flight.from = t;
    if (Flies(body)) flight.a_W = pulls_[At(body)];
    for (Support& support : supports_) {
      if (support.body == body) support.until = std::min(support.until, t);
    }
    Velocity& gain = gains_[At(body)];
    if (blows_[At(body)] == 0) gain = {};
    gain.v += blow_.Gain(k).v;
    gain.w += blow_.Gain(k).w;
    ++blows_[At(body)];
  }
}

void Blows::SupportSince(std::size_t first, double t) {
  for (std::size_t k = first; k < struck_.size(); ++k) {
    const ContactPair& pair = struck_[k];
    const bool A_rests = Flies(pair.A) && IsStatic(pair.B);
    if (!A_rests && !(Flies(pair.B) && IsStatic(pair.A))) continue;
    const int body = A_rests ? pair.A : pair.B;
    const Eigen::Vector3d n_W = (A_rests ? -1 : 1) * pair.manifold.n_AB_W;
    BodyFlight& flight = flights_[At(body)];
    const BodyState& state = flight.start.state;
    // What still rises or falls about its contacts is not at rest: a support would do
    // work on it.
    const double stopped = kStopped * blow_.scale();
    if (std::abs(n_W.dot(state.v_WB)) > stopped) continue;
    const auto points = pair.manifold.points();
    const bool rests =
        std::all_of(points.begin(), points.end(), [&](const ContactPoint& contact) {
          const Eigen::Vector3d r = contact.p_WC - state.p_WB;
          return std::abs(n_W.dot(state.w_WB.cross(r))) <= stopped;
        });
    const double pull = n_W.dot(flight.a_W);
    if (!rests || pull >= 0) continue;
    flight.a_W -= pull * n_W;
    const double force = -pull / flight.start.inverse_mass;
    supports_.push_back({body, k, force * pair.manifold.n_AB_W, t, rules_.h});
  }
}

void Blows::EndSupports() {
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
