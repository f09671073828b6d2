// Islands that come to rest at once.

#include "engine/dynamics/solver/static_equilibrium.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "engine/dynamics/solver/constraint_group.h"
#include "engine/dynamics/world/world.h"
#include "tests/engine/dynamics/random.h"

namespace cookbook {
namespace {

constexpr double kG = 9.82;
constexpr double kH = 1.0 / 240;

/** Speed that gravity adds in a step, times the rounding error of loads of some hundred
 bodies. [m/s] */
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
           const Eigen::Vector3d& half_extents = {0.5, 0.5, 0.5}, double heading = 0) {
  BodyDefinition box;
  box.shape = Box{half_extents};
  box.restitution = 0;
  box.friction = 0.6;
  box.mass = mass;
  box.state.p_WB = p_WB;
  box.state.q_WB = Eigen::AngleAxisd(heading, Eigen::Vector3d::UnitY());
  return world.AddBody(box);
}

/** Returns the greatest |v| + |ω|. */
double MaxSpeed(const World& world) {
  double max = 0;
  for (int i = 1; i < world.body_count(); ++i) {
    max = std::max(max, world.state(i).v_WB.norm() + world.state(i).w_WB.norm());
  }
  return max;
}

void ExpectToRest(World& world, int steps) {
  for (int k = 0; k < steps && !testing::Test::HasFailure(); ++k) {
    world.Step(kH);
    EXPECT_LT(MaxSpeed(world), kRest) << k;
  }
}

/** The sum of the contact impulses on a body in a step. */
struct Received {
  Eigen::Vector3d impulse = Eigen::Vector3d::Zero();  ///< [N s]
  /** About the centre. [N m s] */
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
};

Received ReceivedBy(const World& world, int body) {
  std::vector<ContactImpulse> impulses;
  world.AppendContactImpulses(impulses);
  Received received;
  for (const ContactImpulse& contact : impulses) {
    if (contact.A != body && contact.B != body) continue;
    const Eigen::Vector3d J_W = contact.B == body ? contact.J_B_W : -contact.J_B_W;
    received.impulse += J_W;
    received.moment += (contact.p_WC - world.state(body).p_WB).cross(J_W);
  }
  return received;
}

TEST(StaticEquilibrium, AStackOfTwentyStandsThoughIterationsWouldNotHoldIt) {
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

// There are gaps between the boxes, of the rounding of a coordinate. The contacts close
// in the step.
TEST(StaticEquilibrium, AStackStandsFarFromTheOrigin) {
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
    // Gaps close by some nanometres in a step. There is no other motion.
    EXPECT_LT(MaxSpeed(world), 1e-6) << gap;
  }
}

TEST(StaticEquilibrium, TheStackSwaysIfTheSettingIsOff) {
  Settings settings;
  settings.static_equilibrium = false;
  World world(settings);
  AddFloor(world);
  for (int i = 0; i < 20; ++i) AddBox(world, {0, 0.5 + i, 0});
  for (int k = 0; k < 240; ++k) world.Step(kH);
  EXPECT_GT(MaxSpeed(world), 1e3 * kRest);
}

TEST(StaticEquilibrium, AThousandTimesHeavierBoxRestsFromTheFirstStep) {
  World world{Settings()};
  AddFloor(world);
  AddBox(world, {0, 0.5, 0});
  constexpr double kHeavy = 1000;
  AddBox(world, {0.1, 1.5, -0.2}, kHeavy);
  for (int step = 0; step < 20; ++step) {
    world.Step(kH);
    // The lower box bears its own weight `kHeavy` times. Its speed is some ten roundings
    // of that.
    EXPECT_LT(MaxSpeed(world), 1e-14 * kHeavy * kG * kH) << step;
  }
}

// Iterations would not converge. Each step would leave a little more motion than the one
// before, and some of the heavy boxes would fall.
TEST(StaticEquilibrium, AMuchHeavierBoxStaysAfterContactsYield) {
  Random random(1);
  for (int k = 0; k < 40; ++k) {
    World world{Settings()};
    BodyDefinition floor;
    floor.shape = HalfSpace{};
    floor.state.q_WB = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(),
                                                          Eigen::Vector3d::UnitY());
    floor.mass = 0;
    floor.friction = 0.6;
    world.AddBody(floor);
    const double height = random.Uniform(0.3, 0.5);
    const double heavy = random.LogUniform(1000, 4000);
    AddBox(world, {0, height, 0}, 1,
           {random.Uniform(0.1, 0.4), height, random.Uniform(0.1, 0.4)},
           random.Uniform(0, 3));
    AddBox(world, {random.Uniform(-0.05, 0.05), 2 * height + 0.1, 0.01}, heavy,
           {0.3, 0.1, 0.2}, random.Uniform(0, 3));
    if (k % 2 == 1) {
      // A gate, which is a cycle, and shares a batch with the lower box.
      AddBox(world, {4, 0.5, 0});
      AddBox(world, {6, 0.5, 0});
      AddBox(world, {5, 1.1, 0}, 5, {1.5, 0.1, 0.5});
    }
    for (int step = 0; step < 333; ++step) world.Step(kH / 2);
    // The lower box bears its own weight `heavy` times. Its speed is some ten roundings
    // of that, and its angular velocity that over its size.
    for (const int i : {1, 2}) {
      const double speed = world.state(i).v_WB.norm() + world.state(i).w_WB.norm();
      EXPECT_LT(speed, 1e-14 * heavy * kG * kH) << k;
    }
  }
}

TEST(StaticEquilibrium, ABranchingStackRests) {
  World world{Settings()};
  AddFloor(world);
  AddBox(world, {0, 0.5, 0}, 0.1, {3, 0.5, 1});  // A plank with two stacks on it.
  for (int i = 0; i < 6; ++i) {
    AddBox(world, {-2, 1.5 + i, 0}, 1 + i);
    AddBox(world, {1.9, 1.5 + i, 0.1});
  }
  ExpectToRest(world, 20);
}

/** Expects that the bodies stay at rest for half a second, up to some roundings of the
 impulses on a body that bears `ratio` times its weight. */
void ExpectToStand(World& world, double ratio) {
  std::vector<Eigen::Vector3d> placed;
  placed.reserve(static_cast<std::size_t>(world.body_count()));
  for (int i = 0; i < world.body_count(); ++i) placed.push_back(world.state(i).p_WB);
  for (int step = 0; step < 120 && !testing::Test::HasFailure(); ++step) {
    world.Step(kH);
    EXPECT_LT(MaxSpeed(world), 1e-13 * ratio * kG * kH) << step;
  }
  for (int i = 0; i < world.body_count(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    EXPECT_LT((world.state(i).p_WB - placed[k]).norm(), 1e-13 * ratio) << i;
  }
}

TEST(StaticEquilibrium, AGateBearsAHeavyLintel) {
  for (const double mass : {1e-3, 1.0, 2000.0, 1e6}) {
    World world{Settings()};
    AddFloor(world);
    AddBox(world, {-0.4, 0.4, 0}, 1, {0.1, 0.4, 0.1});
    AddBox(world, {0.4, 0.4, 0}, 1, {0.1, 0.4, 0.1});
    AddBox(world, {0.03, 0.9, 0.01}, mass, {0.5, 0.1, 0.15});
    ExpectToStand(world, 1 + mass);
  }
}

TEST(StaticEquilibrium, ATableBearsMoreOrLessThanItsLegs) {
  for (const double mass : {1.0 / 2000, 2000.0}) {
    // The centre of the top is between all four legs, or between three of them only.
    for (const double x : {0.1, 0.9}) {
      World world{Settings()};
      AddFloor(world);
      for (const double leg_x : {-1.0, 1.0}) {
        for (const double leg_z : {-1.0, 1.0})
          AddBox(world, {leg_x, 0.5, leg_z}, 1, {0.1, 0.5, 0.1});
      }
      AddBox(world, {x, 1.05, 0.2}, mass, {2.2, 0.05, 1.2});
      ExpectToStand(world, 1 + mass);
    }
  }
}

TEST(StaticEquilibrium, APyramidStands) {
  World world{Settings()};
  AddFloor(world);
  for (int row = 0; row < 4; ++row) {
    for (int k = 0; k < 4 - row; ++k)
      AddBox(world, {1.1 * k + 0.55 * row, 0.5 + row, 0.01 * k});
  }
  ExpectToStand(world, 4);
}

TEST(StaticEquilibrium, ATableWhoseTopIsTooFarOutFalls) {
  World world{Settings()};
  AddFloor(world);
  for (const double x : {-1.0, 1.0}) {
    for (const double z : {-1.0, 1.0}) AddBox(world, {x, 0.5, z}, 1, {0.1, 0.5, 0.1});
  }
  // The legs reach to x = 1.1.
  const int top = AddBox(world, {1.11, 1.05, 0}, 2000, {2.2, 0.05, 1.2});
  for (int step = 0; step < 240; ++step) world.Step(kH);
  EXPECT_GT(world.state(top).q_WB.vec().norm(), 0.01);
}

TEST(StaticEquilibrium, ABoxBetweenWallsFallsUnlessPressed) {
  for (const double press : {0.0, 30.0}) {
    World world{Settings()};
    for (const double x : {-1.5, 1.5}) {
      BodyDefinition wall;
      wall.shape = Box{{1, 10, 10}};
      wall.state.p_WB = {x, 0, 0};
      wall.mass = 0;
      wall.friction = 0.6;
      world.AddBody(wall);
    }
    BodyDefinition box;
    box.shape = Box{{0.5, 0.5, 0.5}};
    box.mass = 1;
    box.friction = 0.6;
    box.force_W = {press, 0, 0};
    const int held = world.AddBody(box);
    for (int step = 0; step < 24; ++step) world.Step(kH);
    // Friction at the right wall holds up to 0.6 × 30 N, and the weight is 9.82 N. Its
    // moment is that of a load 0.33 × 0.5 m off the middle of the face.
    const double fall = press > 0 ? 0 : 0.5 * kG * 0.1 * 0.1;
    EXPECT_NEAR(world.state(held).p_WB.y(), -fall, 1e-6);
  }
}

TEST(StaticEquilibrium, ContactImpulsesBalanceGravity) {
  World world{Settings()};
  AddFloor(world);
  // Each box is further out, so that none has its load in the middle.
  for (int i = 0; i < 6; ++i) AddBox(world, {0.05 * i, 0.5 + i, 0.02 * i}, 6 - i);
  ExpectToRest(world, 3);
  for (int i = 1; i <= 6; ++i) {
    const Received received = ReceivedBy(world, i);
    const double weight = (7 - i) * kG * kH;
    EXPECT_LT((received.impulse - Eigen::Vector3d(0, weight, 0)).norm(), 1e-12) << i;
    EXPECT_LT(received.moment.norm(), 1e-12) << i;
  }
}

TEST(StaticEquilibrium, ASlopeHoldsBoxesUpToItsFrictionAndNoMore) {
  for (const double steepness : {0.95, 1.05}) {
    Settings settings;
    const double angle = std::atan(0.6 * steepness);
    settings.gravity_W = kG * Eigen::Vector3d(std::sin(angle), -std::cos(angle), 0);
    World world(settings);
    AddFloor(world);
    // Two flat boxes, which do not tip.
    AddBox(world, {0, 0.1, 0}, 1, {0.5, 0.1, 0.5});
    const int upper = AddBox(world, {0, 0.3, 0}, 1, {0.5, 0.1, 0.5});
    constexpr int kSteps = 48;
    for (int k = 0; k < kSteps; ++k) world.Step(kH);
    // Both slide on the floor, or the upper box slides on the lower one.
    const double slides =
        kSteps * kH * kG * std::max(0.0, std::sin(angle) - 0.6 * std::cos(angle));
    if (slides == 0) {
      EXPECT_LT(MaxSpeed(world), kRest);
    } else {
      EXPECT_GT(world.state(upper).v_WB.x(), 0.999 * slides);
    }
  }
}

TEST(StaticEquilibrium, AnOverhangingStackFalls) {
  World world{Settings()};
  AddFloor(world);
  AddBox(world, {0, 0.5, 0});
  AddBox(world, {0.4, 1.5, 0});
  const int top = AddBox(world, {0.8, 2.5, 0});
  // The centre of the two upper boxes is 0.6 m out, 0.1 m beyond the edge.
  for (int k = 0; k < 240; ++k) world.Step(kH);
  EXPECT_LT(world.state(top).p_WB.y(), 2.4);
}

TEST(StaticEquilibrium, ABodyThrownUpIsNotHeld) {
  World world{Settings()};
  AddFloor(world);
  AddBox(world, {0, 0.5, 0});
  const int top = AddBox(world, {0, 1.5, 0});
  world.Step(kH);
  world.ApplyImpulse(top, {0, 1.5, 0}, {0, 1, 0});
  world.Step(kH);
  EXPECT_NEAR(world.state(top).v_WB.y(), 1 - kG * kH, 1e-12);
}

TEST(StaticEquilibrium, FrictionAloneSlowsASlidingBody) {
  World world{Settings()};
  AddFloor(world);
  AddBox(world, {0, 0.1, 0}, 1, {0.5, 0.1, 0.5});
  const int upper = AddBox(world, {0, 0.3, 0}, 1, {0.5, 0.1, 0.5});
  world.Step(kH);
  world.ApplyImpulse(upper, {0, 0.3, 0}, {1, 0, 0});
  world.Step(kH);
  EXPECT_NEAR(world.state(upper).v_WB.x(), 1 - 0.6 * kG * kH, 1e-3 * kG * kH);
}

/** An island of boxes with given pairs, and one iteration over its contacts. Body 0 is a
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

  void AddPair(int A, int B) {
    ContactPair& pair = pairs.emplace_back();
    pair.A = A;
    pair.B = B;
  }

  /** Stacks boxes on the floor. */
  void Stack(int count) {
    for (int i = 0; i < count; ++i) {
      Add({0.01 * i, 0.5 + i, 0});
      AddPair(i, i + 1);
    }
  }

  /** Returns whether all bodies come to rest. Expects that otherwise nothing changes. */
  bool ComesToRest() {
    Iterate();
    const std::vector<Velocity> velocities_before = velocities_;
    const std::vector<double> impulses_before = Impulses();
    StaticEquilibrium static_equilibrium;
    SolverBodies without_impulses = Bodies();
    without_impulses.velocities = free;
    static_equilibrium.Solve(group_.view(), islands_, 1e-14 * group_.max_speed(),
                             without_impulses, velocities_);
    bool rests = true;
    bool same = impulses_before == Impulses();
    for (std::size_t i = 1; i < bodies.size(); ++i) {
      rests = rests && velocities_[i].v.isZero(0) && velocities_[i].w.isZero(0);
      same = same && velocities_[i].v == velocities_before[i].v &&
             velocities_[i].w == velocities_before[i].w;
    }
    EXPECT_NE(rests, same);
    return rests;
  }

  /** Returns the linear and angular momentum of `body` that the contacts leave. */
  Received RemainingMomentum(int body) {
    const auto i = static_cast<std::size_t>(body);
    const RigidBody& b = bodies[i];
    Received remaining{free[i].v / b.inverse_mass, b.moments.cwiseProduct(free[i].w)};
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
        remaining.impulse += sign * J_W;
        remaining.moment +=
            at(batch.B[0] == body ? contact.r_B : contact.r_A).cross(sign * J_W);
      }
    }
    return remaining;
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
    parameters.restitution_threshold_factor = 1;
    parameters.restitution_factor = 1;
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

  std::vector<double> Impulses() {
    std::vector<double> impulses;
    for (const ContactConstraintLanes<double>& contact : group_.view().contacts) {
      for (const auto* lanes :
           {&contact.impulse, &contact.friction_impulse1, &contact.friction_impulse2}) {
        impulses.insert(impulses.end(), lanes->begin(), lanes->end());
      }
    }
    return impulses;
  }

  std::vector<InverseInertia> inertias_;
  std::vector<Velocity> before_;
  std::vector<Velocity> velocities_;
  std::vector<int> islands_;
  ConstraintGroup<double> group_;
  ThreadPool pool_{1};
};

/** Expects that the contacts stop all bodies. Their loads are some g h. */
void ExpectNoRemainingMomentum(Island& island) {
  for (int i = 1; i < static_cast<int>(island.bodies.size()); ++i) {
    const Received remaining = island.RemainingMomentum(i);
    EXPECT_LT(remaining.impulse.norm(), 1e-14) << i;
    EXPECT_LT(remaining.moment.norm(), 1e-14) << i;
  }
}

TEST(StaticEquilibriumSolve, StopsEachBody) {
  Island island;
  island.Stack(4);
  EXPECT_TRUE(island.ComesToRest());
  ExpectNoRemainingMomentum(island);
}

TEST(StaticEquilibriumSolve, DoesNotDependOnTheOrderOfBodiesInAPair) {
  Island island;
  island.Stack(4);
  std::swap(island.pairs[0].A, island.pairs[0].B);
  std::swap(island.pairs[2].A, island.pairs[2].B);
  island.bodies[4].state.v_WB = {0.01, 0, 0};
  EXPECT_TRUE(island.ComesToRest());
  ExpectNoRemainingMomentum(island);
}

TEST(StaticEquilibriumSolve, StopsASlipUpToTheFriction) {
  // A step of friction stops μ g h = 0.0245 m/s of the upper box.
  for (const double v : {0.024, 0.025}) {
    Island island;
    island.Stack(2);
    // Flat, so that it does not tip.
    island.bodies[2] = island.bodies[1];
    island.bodies[2].shape = Box{{0.5, 0.05, 0.5}};
    island.bodies[2].state.p_WB = {0, 1.05, 0};
    island.bodies[2].state.v_WB = {v, 0, 0};
    EXPECT_EQ(island.ComesToRest(), v < 0.6 * kG * kH) << v;
    if (v < 0.6 * kG * kH) ExpectNoRemainingMomentum(island);
  }
}

TEST(StaticEquilibriumSolve, StopsASpinUpToTheFriction) {
  // The corners, at √½ m, each bear g h/4. Their friction has the moment μ g h √½; the
  // moment of inertia is 1/6 kg m².
  const double max_spin = 0.6 * kG * kH * std::sqrt(0.5) * 6;
  for (const double fraction : {0.99, 1.01}) {
    Island island;
    island.Stack(1);
    island.bodies[1].state.w_WB = {0, fraction * max_spin, 0};
    EXPECT_EQ(island.ComesToRest(), fraction < 1) << fraction;
    if (fraction < 1) ExpectNoRemainingMomentum(island);
  }
}

TEST(StaticEquilibriumSolve, DoesNotPull) {
  // The load of a cube on two of its corners has the moment ½ m g h; the moment of
  // inertia is 1/6 kg m².
  const double max_spin = 0.5 * kG * kH * 6;
  for (const double fraction : {0.99, 1.01}) {
    Island island;
    island.Stack(1);
    island.bodies[1].state.w_WB = {fraction * max_spin, 0, 0};
    EXPECT_EQ(island.ComesToRest(), fraction < 1) << fraction;
    if (fraction < 1) ExpectNoRemainingMomentum(island);
  }
}

TEST(StaticEquilibriumSolve, StopsCyclesAndSecondSupports) {
  Island arch;
  arch.Stack(1);
  arch.Add({3, 0.5, 0});
  arch.AddPair(0, 2);
  arch.Add({1.5, 1.5, 0}, {2, 0.5, 0.5});
  arch.AddPair(1, 3);
  arch.AddPair(2, 3);
  EXPECT_TRUE(arch.ComesToRest());
  ExpectNoRemainingMomentum(arch);

  Island seam;
  seam.Stack(1);
  seam.Add({0.2, -1, 0}, {0.1, 1, 10}, 0);
  seam.AddPair(2, 1);
  EXPECT_TRUE(seam.ComesToRest());
}

TEST(StaticEquilibriumSolve, LeavesWhatNothingSupports) {
  // The number of pairs equals that of bodies.
  Island cycle;
  cycle.Stack(2);
  cycle.pairs[0].A = 1;
  cycle.pairs[0].B = 2;
  EXPECT_FALSE(cycle.ComesToRest());

  Island cycle_with_branch;
  cycle_with_branch.Stack(3);
  cycle_with_branch.pairs[0].A = 1;
  cycle_with_branch.pairs[0].B = 2;
  EXPECT_FALSE(cycle_with_branch.ComesToRest());
}

TEST(StaticEquilibriumSolve, LeavesOpenContacts) {
  Island island;
  island.Stack(2);
  island.bodies[2].state.p_WB.y() += 1e-5;
  EXPECT_FALSE(island.ComesToRest());
}

TEST(StaticEquilibriumSolve, LeavesBouncingContacts) {
  Island island;
  island.restitution = 0.5;
  island.bodies[0].restitution = 0.5;
  island.Stack(2);
  island.bodies[2].state.v_WB = {0, -1, 0};
  EXPECT_FALSE(island.ComesToRest());
}

TEST(StaticEquilibriumSolve, LeavesABodyThatStandsOnALine) {
  Island island;
  island.Add({0, 1, 0}, {1e-8, 1, 2}, 0);
  island.Add({0, 2.5, 0});
  island.bodies[1].state.p_WB = {0, 1, 0};
  island.AddPair(1, 2);
  island.bodies[2].state.w_WB = {0, 0, 1e-3};
  EXPECT_FALSE(island.ComesToRest());
}

}  // namespace
}  // namespace cookbook
