// Heaps that come to rest at once, where each body stands on one other.

#include "engine/dynamics/solver/static_equilibrium.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "engine/dynamics/solver/constraint_group.h"
#include "engine/dynamics/world/world.h"

namespace cookbook {
namespace {

constexpr double kG = 9.82;
constexpr double kH = 1.0 / 240;

/** Rounding of what a step of gravity makes, of loads of some hundred times a body's. */
constexpr double kRest = 1e-12 * kG * kH;

void AddFloor(World& world) {
  BodyDefinition floor;
  floor.shape = Box{{10, 1, 10}};
  floor.state.p_WB = {0, -1, 0};
  floor.mass = 0;
  floor.friction = 0.6;
  world.AddBody(floor);
}

int AddBox(World& world, const Eigen::Vector3d& p_WB, double mass = 1,
           const Eigen::Vector3d& half_extents = {0.5, 0.5, 0.5}) {
  BodyDefinition box;
  box.shape = Box{half_extents};
  box.restitution = 0;
  box.friction = 0.6;
  box.mass = mass;
  box.state.p_WB = p_WB;
  return world.AddBody(box);
}

double Fastest(const World& world) {
  double fastest = 0;
  for (int i = 1; i < world.body_count(); ++i) {
    fastest = std::max(fastest, world.state(i).v_WB.norm() + world.state(i).w_WB.norm());
  }
  return fastest;
}

void ExpectToRest(World& world, int steps) {
  for (int k = 0; k < steps && !testing::Test::HasFailure(); ++k) {
    world.Step(kH);
    EXPECT_LT(Fastest(world), kRest) << k;
  }
}

/** Impulse and its moment about the centre that the contacts give to a body in a step. */
struct Received {
  Eigen::Vector3d force = Eigen::Vector3d::Zero();
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
};

Received ReceivedBy(const World& world, int body) {
  std::vector<ContactImpulse> impulses;
  world.ReadImpulses(impulses);
  Received received;
  for (const ContactImpulse& contact : impulses) {
    if (contact.A != body && contact.B != body) continue;
    const Eigen::Vector3d J_W = contact.B == body ? contact.J_B_W : -contact.J_B_W;
    received.force += J_W;
    received.moment += (contact.p_WC - world.state(body).p_WB).cross(J_W);
  }
  return received;
}

TEST(StaticEquilibrium, AStackOfTwentyStandsThoughSweepsWouldNotHoldIt) {
  World world{Settings()};
  AddFloor(world);
  for (int i = 0; i < 20; ++i) {
    AddBox(world, {1e-6 * std::sin(i), 0.5 + i, 1e-6 * std::cos(3.0 * i)});
  }
  ExpectToRest(world, 240);
  for (int i = 1; i <= 20; ++i) {
    EXPECT_NEAR(world.state(i).p_WB.y(), i - 0.5, 1e-12) << i;
  }
}

// There the gaps between boxes are what a coordinate rounds: contacts that are not there
// yet, and arrive within the step.
TEST(StaticEquilibrium, AStackStandsFarFromTheOriginToo) {
  for (const double gap : {0.0, 1e-12, 1e-9}) {
    World world{Settings()};
    constexpr double kFar = 1000.1;
    BodyDefinition floor;
    floor.shape = Box{{10, 1, 10}};
    floor.state.p_WB = {0, kFar - 1, 0};
    floor.mass = 0;
    world.AddBody(floor);
    for (int i = 0; i < 20; ++i) {
      AddBox(world, {0, kFar + 0.35 + (0.7 + gap) * i, 0}, 1, {0.5, 0.35, 0.5});
    }
    for (int k = 0; k < 120; ++k) world.Step(kH);
    // Gaps close, by some nanometres a step: no more is to be seen.
    EXPECT_LT(Fastest(world), 1e-6) << gap;
  }
}

TEST(StaticEquilibrium, IsASettingWithoutWhichTheStackSways) {
  Settings settings;
  settings.static_equilibrium = false;
  World world(settings);
  AddFloor(world);
  for (int i = 0; i < 20; ++i) AddBox(world, {0, 0.5 + i, 0});
  for (int k = 0; k < 240; ++k) world.Step(kH);
  EXPECT_GT(Fastest(world), 1e3 * kRest);
}

TEST(StaticEquilibrium, AThousandfoldLoadRestsFromTheFirstStep) {
  World world{Settings()};
  AddFloor(world);
  AddBox(world, {0, 0.5, 0});
  AddBox(world, {0.1, 1.5, -0.2}, 1000);
  ExpectToRest(world, 20);
}

TEST(StaticEquilibrium, WhatBranchesRests) {
  World world{Settings()};
  AddFloor(world);
  AddBox(world, {0, 0.5, 0}, 0.1, {3, 0.5, 1});  // A plank with two stacks on it.
  for (int i = 0; i < 6; ++i) {
    AddBox(world, {-2, 1.5 + i, 0}, 1 + i);
    AddBox(world, {1.9, 1.5 + i, 0.1});
  }
  ExpectToRest(world, 20);
}

TEST(StaticEquilibrium, BodiesReceiveJustWhatGravityTakes) {
  World world{Settings()};
  AddFloor(world);
  // Each a tenth further out, so that none bears its load in the middle.
  for (int i = 0; i < 6; ++i) AddBox(world, {0.05 * i, 0.5 + i, 0.02 * i}, 6 - i);
  ExpectToRest(world, 3);
  for (int i = 1; i <= 6; ++i) {
    const Received received = ReceivedBy(world, i);
    const double weight = (7 - i) * kG * kH;
    EXPECT_LT((received.force - Eigen::Vector3d(0, weight, 0)).norm(), 1e-12) << i;
    EXPECT_LT(received.moment.norm(), 1e-12) << i;
  }
}

TEST(StaticEquilibrium, ASlopeHoldsWhatItsFrictionHoldsAndNoMore) {
  for (const double steepness : {0.95, 1.05}) {
    Settings settings;
    const double angle = std::atan(0.6 * steepness);
    settings.gravity_W = kG * Eigen::Vector3d(std::sin(angle), -std::cos(angle), 0);
    World world(settings);
    AddFloor(world);
    // A low one on another, that does not tip.
    AddBox(world, {0, 0.1, 0}, 1, {0.5, 0.1, 0.5});
    const int upper = AddBox(world, {0, 0.3, 0}, 1, {0.5, 0.1, 0.5});
    constexpr int kSteps = 48;
    for (int k = 0; k < kSteps; ++k) world.Step(kH);
    // Both slide on the floor, or the upper on the lower.
    const double slides =
        kSteps * kH * kG * std::max(0.0, std::sin(angle) - 0.6 * std::cos(angle));
    if (slides == 0) {
      EXPECT_LT(Fastest(world), kRest);
    } else {
      EXPECT_GT(world.state(upper).v_WB.x(), 0.999 * slides);
    }
  }
}

TEST(StaticEquilibrium, WhatLeansOutTooFarFalls) {
  World world{Settings()};
  AddFloor(world);
  AddBox(world, {0, 0.5, 0});
  AddBox(world, {0.4, 1.5, 0});
  const int top = AddBox(world, {0.8, 2.5, 0});
  // The two upper ones together are 0.6 m out, a tenth beyond the edge.
  for (int k = 0; k < 240; ++k) world.Step(kH);
  EXPECT_LT(world.state(top).p_WB.y(), 2.4);
}

TEST(StaticEquilibrium, WhatIsThrownUpIsNotHeld) {
  World world{Settings()};
  AddFloor(world);
  AddBox(world, {0, 0.5, 0});
  const int top = AddBox(world, {0, 1.5, 0});
  world.Step(kH);
  world.ApplyImpulse(top, {0, 1.5, 0}, {0, 1, 0});
  world.Step(kH);
  EXPECT_NEAR(world.state(top).v_WB.y(), 1 - kG * kH, 1e-12);
}

TEST(StaticEquilibrium, WhatSlidesIsSlowedByItsFrictionAlone) {
  World world{Settings()};
  AddFloor(world);
  AddBox(world, {0, 0.1, 0}, 1, {0.5, 0.1, 0.5});
  const int upper = AddBox(world, {0, 0.3, 0}, 1, {0.5, 0.1, 0.5});
  world.Step(kH);
  world.ApplyImpulse(upper, {0, 0.3, 0}, {1, 0, 0});
  world.Step(kH);
  EXPECT_NEAR(world.state(upper).v_WB.x(), 1 - 0.6 * kG * kH, 1e-3 * kG * kH);
}

/** Some bodies, which of them touch, and one sweep over their contacts. Body 0 is a
 floor. */
class Island {
 public:
  Island() { Add({0, -1, 0}, {10, 1, 10}, 0); }

  int Add(const Eigen::Vector3d& p_WB,
          const Eigen::Vector3d& half_extents = {0.5, 0.5, 0.5}, double mass = 1) {
    BodyDefinition box;
    box.shape = Box{half_extents};
    box.state.p_WB = p_WB;
    box.mass = mass;
    box.restitution = restitution;
    box.friction = 0.6;
    bodies.push_back(MakeRigidBody(box));
    bodies.back().speculative_margin = 1e-3;
    return static_cast<int>(bodies.size()) - 1;
  }

  void Join(int A, int B) {
    ContactPair& pair = pairs.emplace_back();
    pair.A = A;
    pair.B = B;
  }

  /** A tower on the floor. */
  void Stack(int count) {
    for (int i = 0; i < count; ++i) {
      Add({0.01 * i, 0.5 + i, 0});
      Join(i, i + 1);
    }
  }

  /** Returns whether all come to rest; expects that else nothing changes at all. */
  bool Rests() {
    Iterate();
    const std::vector<Velocity> swept = velocities_;
    const std::vector<double> borne = Borne();
    StaticEquilibrium static_equilibrium;
    static_equilibrium.Solve(group_.view(), islands_, 1e-14 * group_.max_speed(), Bodies());
    bool rests = true;
    bool same = borne == Borne();
    for (std::size_t i = 1; i < bodies.size(); ++i) {
      rests = rests && velocities_[i].v.isZero(0) && velocities_[i].w.isZero(0);
      same = same && velocities_[i].v == swept[i].v && velocities_[i].w == swept[i].w;
    }
    EXPECT_NE(rests, same);
    return rests;
  }

  /** What stays of the momentum of `body` and of its moment about the centre. */
  Received Left(int body) {
    const auto i = static_cast<std::size_t>(body);
    const RigidBody& b = bodies[i];
    Received left{free[i].v / b.inverse_mass, b.moments.cwiseProduct(free[i].w)};
    const ConstraintView<double> constraints = group_.view();
    for (const ConstraintBatch<double>& batch : constraints.batches) {
      const auto at = [](const VectorLanes<double>& v) {
        return Eigen::Vector3d(v[0][0], v[1][0], v[2][0]);
      };
      if (batch.A[0] != body && batch.B[0] != body) continue;
      for (int k = 0; k < batch.count; ++k) {
        const ContactConstraintLanes<double>& contact =
            constraints.contacts[static_cast<std::size_t>(batch.first) +
                          static_cast<std::size_t>(k)];
        const Eigen::Vector3d J_W = contact.impulse[0] * at(batch.n) +
                                    contact.friction_impulse1[0] * at(batch.t1) +
                                    contact.friction_impulse2[0] * at(batch.t2);
        const double sign = batch.B[0] == body ? 1 : -1;
        left.force += sign * J_W;
        left.moment +=
            at(batch.B[0] == body ? contact.r_B : contact.r_A).cross(sign * J_W);
      }
    }
    return left;
  }

  double restitution = 0;
  std::vector<RigidBody> bodies;
  std::vector<ContactPair> pairs;
  std::vector<Velocity> free;  ///< At the end of the step without impulses.

 private:
  SolverBodies Bodies() { return {bodies, inertias_, before_, velocities_}; }

  void Iterate() {
    ContactParameters parameters{};
    parameters.h = kH;
    parameters.resting_speed = 1;
    parameters.soft_mass_scale = 1;
    parameters.accumulated = true;
    std::vector<ColouredPair> ordered;
    for (ContactPair& pair : pairs) {
      std::array<ContactPair*, 1> one = {&pair};
      UpdateManifolds({1, false}, bodies, one);
      const auto k = static_cast<int>(ordered.size());
      ordered.push_back({k, k, pair.A, pair.B, pair.manifold.count});
    }
    before_.assign(bodies.size() + 1, {});
    free = before_;
    islands_.clear();
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      RigidBody& body = bodies[i];
      inertias_.push_back(InverseInertiaOf(body));
      islands_.push_back(body.is_static() ? static_cast<int>(i) : 1);
      if (body.is_static()) continue;
      body.load_acceleration = kG;
      before_[i] = {body.state.v_WB, body.state.w_WB};
      free[i] = before_[i];
      free[i].v.y() -= kG * kH;
    }
    velocities_ = free;
    group_.Begin(ordered, pairs, Bodies(), parameters, velocities_, pool_);
    group_.Iterate(1, velocities_, pool_);
  }

  std::vector<double> Borne() {
    std::vector<double> borne;
    for (const ContactConstraintLanes<double>& contact : group_.view().contacts) {
      for (const auto* lanes :
           {&contact.impulse, &contact.friction_impulse1, &contact.friction_impulse2}) {
        borne.insert(borne.end(), lanes->begin(), lanes->end());
      }
    }
    return borne;
  }

  std::vector<InverseInertia> inertias_;
  std::vector<Velocity> before_;
  std::vector<Velocity> velocities_;
  std::vector<int> islands_;
  ConstraintGroup<double> group_;
  ThreadPool pool_{1};
};

/** Of loads of some g h. */
void ExpectNothingLeft(Island& island) {
  for (int i = 1; i < static_cast<int>(island.bodies.size()); ++i) {
    const Received left = island.Left(i);
    EXPECT_LT(left.force.norm(), 1e-14) << i;
    EXPECT_LT(left.moment.norm(), 1e-14) << i;
  }
}

TEST(StandstillFind, BearsWhatEachBodyNeeds) {
  Island island;
  island.Stack(4);
  EXPECT_TRUE(island.Rests());
  ExpectNothingLeft(island);
}

TEST(StandstillFind, BearsItWhicheverBodyOfAPairIsTheFirst) {
  Island island;
  island.Stack(4);
  std::swap(island.pairs[0].A, island.pairs[0].B);
  std::swap(island.pairs[2].A, island.pairs[2].B);
  island.bodies[4].state.v_WB = {0.01, 0, 0};
  EXPECT_TRUE(island.Rests());
  ExpectNothingLeft(island);
}

TEST(StandstillFind, HoldsASlipNoFasterThanFrictionStops) {
  // A step of friction stops μ g h = 0.0245 m/s of the upper box.
  for (const double v : {0.024, 0.025}) {
    Island island;
    island.Stack(2);
    // Low, so that it does not tip.
    island.bodies[2] = island.bodies[1];
    island.bodies[2].shape = Box{{0.5, 0.05, 0.5}};
    island.bodies[2].state.p_WB = {0, 1.05, 0};
    island.bodies[2].state.v_WB = {v, 0, 0};
    EXPECT_EQ(island.Rests(), v < 0.6 * kG * kH) << v;
    if (v < 0.6 * kG * kH) ExpectNothingLeft(island);
  }
}

TEST(StandstillFind, HoldsASpinNoFasterThanFrictionStops) {
  // Corners √½ m out bear g h/4 each: together μ g h √½, and 1/6 kg m² has to stop.
  const double most = 0.6 * kG * kH * std::sqrt(0.5) * 6;
  for (const double share : {0.99, 1.01}) {
    Island island;
    island.Stack(1);
    island.bodies[1].state.w_WB = {0, share * most, 0};
    EXPECT_EQ(island.Rests(), share < 1) << share;
    if (share < 1) ExpectNothingLeft(island);
  }
}

TEST(StandstillFind, PullsAtNothing) {
  // On two of its corners a cube has ½ m g h, and 1/6 kg m² to stop.
  const double most = 0.5 * kG * kH * 6;
  for (const double share : {0.99, 1.01}) {
    Island island;
    island.Stack(1);
    island.bodies[1].state.w_WB = {share * most, 0, 0};
    EXPECT_EQ(island.Rests(), share < 1) << share;
    if (share < 1) ExpectNothingLeft(island);
  }
}

TEST(StandstillFind, LeavesRingsAndSecondSupports) {
  Island arch;
  arch.Stack(1);
  arch.Add({3, 0.5, 0});
  arch.Join(0, 2);
  arch.Add({1.5, 1.5, 0}, {2, 0.5, 0.5});
  arch.Join(1, 3);
  arch.Join(2, 3);
  EXPECT_FALSE(arch.Rests());

  Island seam;
  seam.Stack(1);
  seam.Add({0.2, -1, 0}, {0.1, 1, 10}, 0);
  seam.Join(2, 1);
  EXPECT_FALSE(seam.Rests());

  // As many pairs as bodies, and nothing to stand on.
  Island ring;
  ring.Stack(2);
  ring.pairs[0].A = 1;
  ring.pairs[0].B = 2;
  EXPECT_FALSE(ring.Rests());

  Island limb;
  limb.Stack(3);
  limb.pairs[0].A = 1;
  limb.pairs[0].B = 2;
  EXPECT_FALSE(limb.Rests());
}

TEST(StandstillFind, LetsComeWhatIsNotThereYet) {
  Island island;
  island.Stack(2);
  island.bodies[2].state.p_WB.y() += 1e-5;
  EXPECT_FALSE(island.Rests());
}

TEST(StandstillFind, HoldsNothingThatBounces) {
  Island island;
  island.restitution = 0.5;
  island.bodies[0].restitution = 0.5;
  island.Stack(2);
  island.bodies[2].state.v_WB = {0, -1, 0};
  EXPECT_FALSE(island.Rests());
}

TEST(StandstillFind, BalancesNothingOnALine) {
  Island island;
  island.Add({0, 1, 0}, {1e-8, 1, 2}, 0);
  island.Add({0, 2.5, 0});
  island.bodies[1].state.p_WB = {0, 1, 0};
  island.Join(1, 2);
  island.bodies[2].state.w_WB = {0, 0, 1e-3};
  EXPECT_FALSE(island.Rests());
}

}  // namespace
}  // namespace cookbook
