#include "engine/dynamics/broad_phase/broad_phase.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "engine/dynamics/body/free_flight.h"
#include "engine/dynamics/contacts/collide_bodies.h"
#include "engine/dynamics/contacts/contact_cache.h"

namespace cookbook {
namespace {

using Pairs = std::set<std::pair<int, int>>;

constexpr double kMargin = 1e-3;    // Greatest speculative margin of a body. [m]
constexpr double kStep = 1.0 / 60;  // [s]

/** Returns a uniformly distributed number in [low, high), independent of the case size.
 */
int Draw(int low, int high) {
  return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(low, high));
}

double Uniform(double low, double high) {
  return low + (high - low) * Draw(0, 1 << 20) / (1 << 20);
}

Eigen::Vector3d InCube(double half) {
  return {Uniform(-half, half), Uniform(-half, half), Uniform(-half, half)};
}

/** Returns a body between a grain and a rock in size, at rest or as fast as a bullet. */
RigidBody RandomBody() {
  const double size = std::pow(10, Uniform(-2, 0.7));
  BodyDefinition body;
  switch (Draw(0, 10)) {
    case 0:
      body.shape = HalfSpace{};
      body.mass = 0;
      break;
    case 1:
      body.shape = Point{};
      break;
    case 2:
    case 3:
    case 4:
      body.shape = Box{size * Eigen::Vector3d(Uniform(0.1, 1), Uniform(0.1, 1), 1)};
      break;
    default:
      body.shape = Sphere{size};
  }
  body.collides = Draw(0, 10) > 0;
  if (Draw(0, 6) == 0) body.mass = 0;
  body.state.p_WB = InCube(2.5);
  // Half-spaces perpendicular to an axis have finite bounds on one side, others do not.
  if (Draw(0, 2) == 0) {
    body.state.q_WB = Eigen::Quaterniond(1, Uniform(-1, 1), Uniform(-1, 1), 1);
    body.state.q_WB.normalize();
  }
  if (body.mass > 0 && Draw(0, 4) > 0) {
    body.state.v_WB = std::pow(10, Uniform(-2, 2.5)) * InCube(1);
    body.state.w_WB = InCube(20);
  }
  RigidBody made = MakeRigidBody(body);
  made.speculative_margin = Uniform(0, kMargin);
  return made;
}

std::vector<RigidBody> RandomBodies() {
  std::vector<RigidBody> bodies;
  for (int i = Draw(2, 40); i > 0; --i) bodies.push_back(RandomBody());
  return bodies;
}

bool CanCollide(const RigidBody& body) {
  return body.collides && !body.is_point;
}

/** Moves body `i` in free flight for a step. Sometimes it falls asleep, wakes or changes
 its velocity before. */
void Move(std::size_t i, std::vector<RigidBody>& bodies,
          const std::vector<RigidBody>& first) {
  RigidBody& body = bodies[i];
  if (first[i].is_static()) return;
  const int fate = Draw(0, 12);
  if (fate == 0) body.inverse_mass = 0;
  if (fate == 1) body.inverse_mass = first[i].inverse_mass;
  if (fate == 2) body.state.v_WB = -body.state.v_WB;
  if (fate == 3) body.state.v_WB += InCube(3);
  body = FreeFlight{body}.At(kStep, Gyroscopic::kOff);
}

/** Whether the two bodies may be within the margin before the next step ends. */
bool MayCollide(const RigidBody& A, const RigidBody& B) {
  if (!CanCollide(A) || !CanCollide(B)) return false;
  if (A.is_static() && B.is_static()) return false;
  const auto grown = [](const RigidBody& body) -> Aabb {
    const double by =
        body.is_static() ? 0 : kMargin + MaxTravel(body, body.state.v_WB, kStep);
    const Aabb bounds = BoundsOf(body).bounds();
    return {bounds.low.array() - by, bounds.high.array() + by};
  };
  return grown(A).Overlaps(grown(B));
}

/** Keeps the near pairs like ContactCache, and checks the new ones. */
class NearPairs {
 public:
  void Add(const std::vector<std::pair<int, int>>& new_pairs,
           const std::vector<RigidBody>& first) {
    for (const auto& [a, b] : new_pairs) {
      RC_ASSERT(a < b);
      const RigidBody& A = first[static_cast<std::size_t>(a)];
      const RigidBody& B = first[static_cast<std::size_t>(b)];
      RC_ASSERT(CanCollide(A) && CanCollide(B));
      RC_ASSERT(!A.is_static() || !B.is_static());
      RC_ASSERT(near_.insert({a, b}).second);
    }
  }

  void DropThoseApart(const BroadPhase& broad_phase) {
    std::erase_if(near_, [&](const std::pair<int, int>& pair) {
      return !broad_phase.AreStillNear(pair.first, pair.second);
    });
  }

  bool Has(int a, int b) const { return near_.contains(std::minmax(a, b)); }

 private:
  Pairs near_;
};

RC_GTEST_PROP(BroadPhase, PairsThatMayCollideInAStepAreNearAndReportedOnce, ()) {
  std::vector<RigidBody> bodies = RandomBodies();
  const std::vector<RigidBody> first = bodies;
  BroadPhase broad_phase;
  ThreadPool pool(1);
  NearPairs near;
  const int late = Draw(0, 10);  // The step in which the last body is added.
  std::vector<std::pair<int, int>> new_pairs;
  int known = 0;
  for (int step = 0; step < 20; ++step) {
    const int count = static_cast<int>(bodies.size()) - (step < late ? 1 : 0);
    for (; known < count; ++known) {
      broad_phase.Add(bodies[static_cast<std::size_t>(known)]);
    }
    const std::span<const RigidBody> present(bodies.data(),
                                             static_cast<std::size_t>(count));
    new_pairs.clear();
    broad_phase.Update(present, kMargin, kStep, pool, new_pairs);
    near.DropThoseApart(broad_phase);
    near.Add(new_pairs, first);
    for (int a = 0; a < count; ++a) {
      for (int b = a + 1; b < count; ++b) {
        if (MayCollide(present[static_cast<std::size_t>(a)],
                       present[static_cast<std::size_t>(b)])) {
          RC_ASSERT(near.Has(a, b));
        }
      }
    }
    // An impact changes the velocity of one body during the step.
    const int hit = Draw(0, count);
    RigidBody& body = bodies[static_cast<std::size_t>(hit)];
    if (CanCollide(body) && !body.is_static()) {
      body.state.v_WB = InCube(200);
      const double reach = kMargin + MaxTravel(body, body.state.v_WB, kStep);
      std::vector<int> candidates;
      new_pairs.clear();
      broad_phase.EnlargeProxy(hit, body, reach, new_pairs, candidates);
      near.Add(new_pairs, first);
      RC_ASSERT(std::is_sorted(new_pairs.begin(), new_pairs.end()));
      RC_ASSERT(std::is_sorted(candidates.begin(), candidates.end()));
      for (const int other : candidates) RC_ASSERT(near.Has(hit, other));
      for (int other = 0; other < count; ++other) {
        if (other == hit || !MayCollide(body, present[static_cast<std::size_t>(other)])) {
          continue;
        }
        RC_ASSERT(std::find(candidates.begin(), candidates.end(), other) !=
                  candidates.end());
      }
    }
    for (int i = 0; i < count; ++i) Move(static_cast<std::size_t>(i), bodies, first);
  }
}

RC_GTEST_PROP(BroadPhase, ItsDistanceBoundIsNoMoreThanTheDistance, ()) {
  std::vector<RigidBody> bodies = {RandomBody(), RandomBody()};
  while (!CanCollide(bodies[0]) || bodies[0].is_static()) bodies[0] = RandomBody();
  while (!CanCollide(bodies[1])) bodies[1] = RandomBody();
  BroadPhase broad_phase;
  for (const RigidBody& body : bodies) broad_phase.Add(body);
  const double gap = broad_phase.DistanceBound(0, 1);
  Manifold manifold;
  CollideSpeculative(0, bodies[0], bodies[1], Eigen::Vector3d::Zero(), manifold);
  // The manifold of two separated boxes has only a bound as well.
  const bool boxes = std::holds_alternative<Box>(bodies[0].shape) &&
                     std::holds_alternative<Box>(bodies[1].shape);
  if (manifold.touching || !boxes) RC_ASSERT(gap <= std::max(0.0, manifold.separation));
  RC_CLASSIFY(gap > 0);
}

/** Whether the summaries have the bodies and numbers of points of the contact pairs. */
bool SummariesAgree(const ContactCache& cache) {
  const std::span<const ContactPair> pairs = cache.pairs();
  const std::span<const PairSummary> summaries = cache.summaries();
  return std::equal(pairs.begin(), pairs.end(), summaries.begin(), summaries.end(),
                    [](const ContactPair& pair, const PairSummary& summary) {
                      return summary.A == pair.A && summary.B == pair.B &&
                             summary.count == pair.manifold.count;
                    });
}

RC_GTEST_PROP(ContactCache, FindsTheSameContactsAsAnExhaustiveSearch, ()) {
  std::vector<RigidBody> bodies = RandomBodies();
  const std::vector<RigidBody> first = bodies;
  ContactCache cache;
  ThreadPool pool(1);
  for (const RigidBody& body : bodies) cache.Add(body);
  int most = 0;
  for (int step = 0; step < 20; ++step) {
    cache.Update(bodies, {kMargin, false}, kStep, pool);
    Pairs found;
    for (const ContactPair& pair : cache.pairs()) {
      RC_ASSERT(found.insert({pair.A, pair.B}).second);
    }
    RC_ASSERT(SummariesAgree(cache));
    most = std::max(most, static_cast<int>(found.size()));
    for (int a = 0; a < static_cast<int>(bodies.size()); ++a) {
      for (int b = a + 1; b < static_cast<int>(bodies.size()); ++b) {
        const RigidBody& A = bodies[static_cast<std::size_t>(a)];
        const RigidBody& B = bodies[static_cast<std::size_t>(b)];
        if (!CanCollide(A) || !CanCollide(B) || (A.is_static() && B.is_static()))
          continue;
        Manifold manifold;
        CollideSpeculative(SpeculativeMarginBetween(A, B), A, B, Eigen::Vector3d::Zero(),
                           manifold);
        RC_ASSERT(found.contains({a, b}) == (manifold.count > 0));
      }
    }
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      const BodyState before = bodies[i].state;
      Move(i, bodies, first);
      cache.AddTravel(i, Travel(before, bodies[i]));
    }
  }
  RC_CLASSIFY(most > 0);
}

// The contacts are so many that they are sometimes sorted in spatial order.
TEST(ContactCache, ItsSummariesAgreeWithItsContacts) {
  constexpr int kRow = 12;
  std::vector<RigidBody> bodies;
  ContactCache cache;
  for (int k = 0; k < kRow * kRow * kRow; ++k) {
    const int i = k * 1009 % (kRow * kRow * kRow);
    const int layer = i / (kRow * kRow);
    BodyDefinition ball;
    ball.shape = Sphere{0.5};
    ball.state.p_WB = 0.99 * Eigen::Vector3d(i % kRow, i / kRow % kRow, layer);
    bodies.push_back(MakeRigidBody(ball));
    cache.Add(bodies.back());
  }
  ThreadPool pool(1);
  constexpr std::size_t kFaces = std::size_t{3} * kRow * kRow * (kRow - 1);
  for (int step = 0; step < 70; ++step) {
    // Half of the bodies fall asleep: their pairs are not collided again.
    if (step == 30) {
      for (RigidBody& body : bodies) {
        if (body.state.p_WB[0] < 5) body.inverse_mass = 0;
      }
    }
    cache.Update(bodies, {kMargin, false}, kStep, pool);
    EXPECT_EQ(cache.pairs().size(), kFaces);
    EXPECT_TRUE(SummariesAgree(cache)) << step;
  }
  cache.ClearContacts(7);
  EXPECT_EQ(cache.pairs()[7].manifold.count, 0);
  EXPECT_TRUE(SummariesAgree(cache));
}

TEST(BroadPhase, NewPairsOfABodyAreInTheOrderInWhichBodiesWereAdded) {
  std::vector<RigidBody> bodies;
  BroadPhase broad_phase;
  constexpr int kCount = 60;
  for (int k = 0; k < kCount; ++k) {
    BodyDefinition ball;  // A row in shuffled order, shorter than a radius.
    ball.state.p_WB = {0.001 * (k * 37 % kCount), 0, 0};
    bodies.push_back(MakeRigidBody(ball));
    broad_phase.Add(bodies.back());
  }
  ThreadPool pool(1);
  std::vector<std::pair<int, int>> new_pairs;
  broad_phase.Update(bodies, kMargin, kStep, pool, new_pairs);
  EXPECT_EQ(new_pairs.size(), std::size_t{kCount} * (kCount - 1) / 2);
  constexpr int kLate = 23;
  const Eigen::Vector3d p_WB = bodies[kLate].state.p_WB;
  for (const double away : {100.0, 0.0}) {
    bodies[kLate].state.p_WB = p_WB + away * Eigen::Vector3d::UnitY();
    new_pairs.clear();
    broad_phase.Update(bodies, kMargin, kStep, pool, new_pairs);
  }
  EXPECT_EQ(new_pairs.size(), std::size_t{kCount - 1});
  EXPECT_TRUE(std::is_sorted(new_pairs.begin(), new_pairs.end()));
}

// Floats could not distinguish these positions: they round 1e8 m to 8 m.
TEST(BroadPhase, SeparatedBodiesAreNotNearHoweverFarFromTheOrigin) {
  for (const double far : {1e7, 1e8, 1e9, 1e11}) {
    std::vector<RigidBody> bodies;
    BroadPhase broad_phase;
    for (int k = 0; k < 40; ++k) {
      BodyDefinition box;
      box.shape = Box{{0.5, 0.5, 0.5}};
      box.state.p_WB = {far, far, 2.0 * k};
      bodies.push_back(MakeRigidBody(box));
      broad_phase.Add(bodies.back());
    }
    ThreadPool pool(1);
    std::vector<std::pair<int, int>> new_pairs;
    broad_phase.Update(bodies, kMargin, kStep, pool, new_pairs);
    EXPECT_TRUE(new_pairs.empty()) << far << ": " << new_pairs.size();
  }
}

// The bounds overflow. No empty slot of a tree node is treated as a body.
TEST(BroadPhase, AHugeBodyIsNearEveryOtherOnce) {
  for (const double half : {3.4028233e38, 1e300, std::numeric_limits<double>::max()}) {
    std::vector<RigidBody> bodies;
    BroadPhase broad_phase;
    for (int k = 0; k < 20; ++k) {
      BodyDefinition body;
      body.state.p_WB = {5.0 * k, 0, 0};
      if (k == 0) {
        body.shape = Box{{half, half, half}};
        body.mass = 0;
      }
      bodies.push_back(MakeRigidBody(body));
      broad_phase.Add(bodies.back());
    }
    ThreadPool pool(1);
    std::vector<std::pair<int, int>> new_pairs;
    broad_phase.Update(bodies, kMargin, kStep, pool, new_pairs);
    EXPECT_EQ(Pairs(new_pairs.begin(), new_pairs.end()).size(), 19u) << half;
    EXPECT_EQ(new_pairs.size(), 19u) << half;
  }
}

TEST(BroadPhase, AWideFloorIsNotNearABodyFarAboveIt) {
  BodyDefinition floor;
  floor.shape = Box{{1000, 1, 1000}};
  floor.mass = 0;
  BodyDefinition ball;
  ball.state.p_WB = {0, 3, 0};
  const std::vector<RigidBody> bodies = {MakeRigidBody(floor), MakeRigidBody(ball)};
  BroadPhase broad_phase;
  ThreadPool pool(1);
  for (const RigidBody& body : bodies) broad_phase.Add(body);
  std::vector<std::pair<int, int>> new_pairs;
  broad_phase.Update(bodies, kMargin, kStep, pool, new_pairs);
  EXPECT_TRUE(new_pairs.empty());
}

}  // namespace
}  // namespace cookbook
