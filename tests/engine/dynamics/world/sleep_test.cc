#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include "engine/dynamics/world/world.h"

namespace cookbook {
namespace {

constexpr double kStep = 1.0 / 240;

Settings SleepsAfterHalfASecond() {
  Settings settings;
  settings.sleep_after = 0.5;
  return settings;
}

void AddFloor(World& world) {
  BodyDefinition floor;
  floor.shape = Box{{50, 1, 50}};
  floor.state.p_WB = {0, -1, 0};
  floor.mass = 0;
  world.AddBody(floor);
}

/** Adds a stack of three boxes at rest; returns the lowest. */
int AddStack(World& world, double x) {
  BodyDefinition box;
  box.shape = Box{{0.5, 0.5, 0.5}};
  int lowest = 0;
  for (int k = 0; k < 3; ++k) {
    box.state.p_WB = {x, 0.5 + k, 0};
    const int added = world.AddBody(box);
    if (k == 0) lowest = added;
  }
  return lowest;
}

void RunFor(World& world, double seconds) {
  for (int k = 0; k < static_cast<int>(seconds / kStep); ++k) world.Step(kStep);
}

bool StackSleeps(const World& world, int lowest) {
  const bool sleeps = world.IsAsleep(lowest);
  for (int k = 1; k < 3; ++k) EXPECT_EQ(world.IsAsleep(lowest + k), sleeps) << k;
  return sleeps;
}

TEST(Sleep, IsOffUnlessAskedFor) {
  World world;
  AddFloor(world);
  const int stack = AddStack(world, 0);
  RunFor(world, 2);
  EXPECT_FALSE(StackSleeps(world, stack));
}

TEST(Sleep, BeginsAfterTheTimeAtRestAndFreezesTheBodies) {
  World world(SleepsAfterHalfASecond());
  AddFloor(world);
  const int stack = AddStack(world, 0);
  RunFor(world, 0.45);
  EXPECT_FALSE(StackSleeps(world, stack));
  RunFor(world, 0.1);
  ASSERT_TRUE(StackSleeps(world, stack));
  const BodyState before = world.state(stack + 2);
  RunFor(world, 1);
  EXPECT_EQ(world.state(stack + 2).p_WB, before.p_WB);
  EXPECT_EQ(world.state(stack + 2).q_WB.coeffs(), before.q_WB.coeffs());
  EXPECT_EQ(world.state(stack + 2).v_WB, Eigen::Vector3d(0, 0, 0));
  EXPECT_FALSE(world.IsAsleep(0));  // A static body does not sleep.
}

TEST(Sleep, WakesTheWholeIslandThatABodyApproachesAndNoOther) {
  World world(SleepsAfterHalfASecond());
  AddFloor(world);
  const int hit = AddStack(world, 0);
  const int other = AddStack(world, 10);
  BodyDefinition ball;
  ball.shape = Sphere{0.2};
  ball.mass = 0.3;
  ball.state.p_WB = {0, 8, 0};  // It falls for 1.03 s.
  world.AddBody(ball);
  RunFor(world, 0.9);
  ASSERT_TRUE(StackSleeps(world, hit));
  RunFor(world, 0.2);
  EXPECT_FALSE(StackSleeps(world, hit));
  EXPECT_TRUE(StackSleeps(world, other));
}

// A body that was asleep takes part in an impact as if it had never slept.
TEST(Sleep, DoesNotChangeAnImpact) {
  Settings weightless = SleepsAfterHalfASecond();
  weightless.gravity_W.setZero();
  World with_sleep(weightless);
  weightless.sleep_after.reset();
  World awake(weightless);
  for (World* world : {&with_sleep, &awake}) {
    BodyDefinition ball;
    ball.shape = Sphere{0.5};
    ball.restitution = 1;
    ball.friction = 0;
    world->AddBody(ball);
    ball.state.p_WB = {-4, 0, 0};
    ball.state.v_WB = {2, 0, 0};
    world->AddBody(ball);
    RunFor(*world, 1);  // They meet after 1.5 s.
  }
  ASSERT_TRUE(with_sleep.IsAsleep(0));
  for (World* world : {&with_sleep, &awake}) RunFor(*world, 1);
  EXPECT_FALSE(with_sleep.IsAsleep(0));
  for (int i = 0; i < 2; ++i) {
    EXPECT_EQ(with_sleep.state(i).v_WB, awake.state(i).v_WB);
    EXPECT_EQ(with_sleep.state(i).p_WB, awake.state(i).p_WB);
  }
  EXPECT_EQ(with_sleep.state(0).v_WB, Eigen::Vector3d(2, 0, 0));
}

TEST(Sleep, EndsWithAnImpulseOrAForce) {
  for (const bool is_force : {false, true}) {
    World world(SleepsAfterHalfASecond());
    AddFloor(world);
    const int stack = AddStack(world, 0);
    RunFor(world, 1);
    ASSERT_TRUE(StackSleeps(world, stack));
    const Eigen::Vector3d p_W = world.state(stack + 2).p_WB;
    if (is_force) {
      world.ApplyForce(stack + 2, p_W, {0, 480, 0});
    } else {
      world.ApplyImpulse(stack + 2, p_W, {0, 2, 0});
    }
    EXPECT_FALSE(StackSleeps(world, stack));
    world.Step(kStep);
    EXPECT_GT(world.state(stack + 2).v_WB[1], 0.5);
  }
}

TEST(Sleep, AStackThatWakesStaysInPlace) {
  World world(SleepsAfterHalfASecond());
  AddFloor(world);
  const int stack = AddStack(world, 0);
  RunFor(world, 1);
  ASSERT_TRUE(StackSleeps(world, stack));
  world.ApplyImpulse(stack, world.state(stack).p_WB, {0.01, 0, 0});
  RunFor(world, 0.4);
  EXPECT_FALSE(StackSleeps(world, stack));
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(world.state(stack + k).p_WB[1], 0.5 + k, 1e-6);
}

// The broad phase uses doubles: a float rounds 1e8 m to 8 m.
TEST(Sleep, ABounceNearbyDoesNotWakeABoxFarFromTheOrigin) {
  constexpr double kFar = 1e8;
  World world(SleepsAfterHalfASecond());
  BodyDefinition floor;
  floor.shape = HalfSpace{};
  floor.state.q_WB =
      Eigen::Quaterniond(Eigen::AngleAxisd(-M_PI / 2, Eigen::Vector3d::UnitX()));
  floor.mass = 0;
  floor.restitution = 1;
  world.AddBody(floor);
  BodyDefinition box;
  box.shape = Box{{0.5, 0.5, 0.5}};
  box.restitution = 0;
  box.state.p_WB = {kFar, 0.5, 0};
  const int resting = world.AddBody(box);
  BodyDefinition ball;
  ball.shape = Sphere{0.5};
  ball.restitution = 1;
  ball.state.p_WB = {kFar + 5, 2, 0};
  const int bouncing = world.AddBody(ball);
  RunFor(world, 3);
  EXPECT_TRUE(world.IsAsleep(resting));
  EXPECT_FALSE(world.IsAsleep(bouncing));
}

TEST(Sleep, DoesNotBeginWhileAJointedBodyMoves) {
  World world(SleepsAfterHalfASecond());
  BodyDefinition bob;
  bob.shape = Sphere{0.1};
  bob.state.p_WB = {0, -3, 0};
  const int first = world.AddBody(bob);
  bob.state.p_WB = {2, -3, 0};
  const int second = world.AddBody(bob);
  bob.state.p_WB = {-3, -3, 0};
  const int alone = world.AddBody(bob);
  world.AddJoint({{-1, {0, 0, 0}}, {first, {0, 0, 0}}, 3});
  world.AddJoint({{first, {0, 0, 0}}, {second, {0, 0, 0}}, 2});
  world.AddJoint({{-1, {-3, 0, 0}}, {alone, {0, 0, 0}}, 3});
  RunFor(world, 2);
  EXPECT_FALSE(world.IsAsleep(first));
  EXPECT_FALSE(world.IsAsleep(second));
  EXPECT_TRUE(world.IsAsleep(alone));
  EXPECT_NEAR(world.state(alone).p_WB[1], -3, 1e-9);
}

TEST(Sleep, RefusesATimeThatIsNotPositive) {
  Settings settings;
  for (const double never : {0.0, -1.0, std::numeric_limits<double>::infinity()}) {
    settings.sleep_after = never;
    EXPECT_THROW(World{settings}, std::invalid_argument) << never;
  }
}

// The body is slow for longer than the time to fall asleep, but it is accelerating.
TEST(Sleep, DoesNotBeginForBodiesThatAForceAccelerates) {
  Settings settings;
  settings.gravity_W = {0, -9.81, 0};
  settings.sleep_after = 0.005;
  for (const BodyShape& shape : {BodyShape(Sphere{0.1}), BodyShape(Point{})}) {
    World thrown(settings);
    BodyDefinition body;
    body.shape = shape;
    body.state.v_WB = {0, 1, 0};
    thrown.AddBody(body);
    for (int k = 0; k < 1000; ++k) thrown.Step(1e-3);
    // After 1 s: 1000 steps with one or two rounding errors each.
    EXPECT_NEAR(thrown.state(0).p_WB[1], 1 - 9.81 / 2, 1e-11);
  }
  settings.gravity_W.setZero();
  for (const bool is_applied : {false, true}) {
    World pushed(settings);
    BodyDefinition body;
    if (!is_applied) body.force_W = {0.5, 0, 0};
    pushed.AddBody(body);
    for (int k = 0; k < 1000; ++k) {
      if (is_applied) pushed.ApplyForce(0, pushed.state(0).p_WB, {0.5, 0, 0});
      pushed.Step(1e-3);
    }
    EXPECT_NEAR(pushed.state(0).p_WB[0], 0.25, 1e-11) << is_applied;
  }
}

TEST(Sleep, BeginsForAPointAtRest) {
  World world(SleepsAfterHalfASecond());
  AddFloor(world);
  BodyDefinition point;
  point.shape = Point{};
  point.restitution = 0;
  point.state.p_WB = {0.3, 0.01, 0.2};
  const int body = world.AddBody(point);
  RunFor(world, 0.7);
  EXPECT_TRUE(world.IsAsleep(body));
}

}  // namespace
}  // namespace cookbook
