#include <array>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "oracles/bullet/bullet_oracles.h"
#include "tests/oracles/simulator_promises.h"

namespace touchstone {
namespace {

struct Bullets {
  std::vector<std::unique_ptr<Oracle>> in_double =
      BulletOracles(BulletPrecision::kDouble);
  std::vector<std::unique_ptr<Oracle>> in_float = BulletOracles(BulletPrecision::kFloat);
};

/* "bullet" and "bullet_float". */
std::array<const Oracle*, 2> Simulators() {
  static const Bullets bullets;
  return {bullets.in_double.front().get(), bullets.in_float.front().get()};
}

// The tolerance is the rounding of velocities of a few metres per second in every step.
TEST(BulletWorld, ContactImpulsesAccountForTheChangeOfMomentum) {
  const World world = BrickOnSlab();
  for (const Oracle* oracle : Simulators()) {
    ExpectImpulsesChangeMomentum(*oracle, world,
                                 64 * world.steps * oracle->info().unit_roundoff);
  }
}

TEST(BulletWorld, BodiesThatDoNotCollidePassThroughEverything) {
  for (const Oracle* oracle : Simulators()) {
    ExpectPassesThroughEverything(*oracle);
  }
}

// Bullet's default ERP removes a fifth of a slight overlap in a step; the adapter keeps
// it.
TEST(BulletWorld, PushesOverlapOutOnlyAsShipped) {
  for (const Oracle* oracle : Simulators()) {
    ExpectPushesOverlapOutOnlyAsShipped(*oracle, 0.2e-3 / World().dt, 1e-5);
  }
}

/** Returns the state of the only moving body, the last, at the end. */
BodyState EndOf(const Oracle& oracle, const WorldSetup& setup, const World& world) {
  return oracle.SetUp(setup)->Simulate(world).samples.back().bodies.back();
}

/** Returns a shape that moves with `v` m/s along x above a plane, its origin at `height`
 m. Nothing bounces or rubs. */
World OnPlane(const Shape& shape, double height, double v) {
  World world;
  world.gravity_W = {0, 0, -9.81};
  world.dt = 1e-3;
  world.steps = 3000;
  world.sample_every = world.steps;
  for (const bool moves : {false, true}) {
    RigidBody& body = world.bodies.emplace_back();
    body.placed.shape = moves ? shape : Shape(HalfSpace{});
    body.placed.X_WB.p_WB.z() = moves ? height : 0;
    body.mass = moves ? 1 : 0;
    body.v_WB.x() = moves ? v : 0;
    body.restitution = 0;
    body.friction = 0;
  }
  world.bodies.back().inertia = Eigen::Vector3d::Constant(1. / 6);
  return world;
}

// A hull of half a metre falls 5 cm, and Bullet's default margin keeps it 4 cm above.
TEST(BulletWorld, AHullFloatsByTheMarginOnlyAsShipped) {
  ConvexHull cube;
  for (int i = 0; i < 8; ++i)
    cube.vertices.emplace_back(i & 1 ? 0.5 : -0.5, i & 2 ? 0.5 : -0.5,
                               i & 4 ? 0.5 : -0.5);
  const World world = OnPlane(cube, 0.55, 0);
  for (const Oracle* oracle : Simulators()) {
    EXPECT_NEAR(EndOf(*oracle, {}, world).p_WB.z(), 0.5, 2e-3);
    EXPECT_NEAR(EndOf(*oracle, {.chosen = {{"margin", 0.04}}}, world).p_WB.z(), 0.54,
                2e-3);
  }
}

// A margin rounds a box within its size.
TEST(BulletWorld, ABoxRestsOnItsFaceWithAnyMargin) {
  const World world = OnPlane(Box{{0.5, 0.5, 0.5}}, 0.5, 0);
  for (const Oracle* oracle : Simulators()) {
    for (const double margin : {0., 0.04, 1.})
      EXPECT_NEAR(EndOf(*oracle, {.chosen = {{"margin", margin}}}, world).p_WB.z(), 0.5,
                  1e-4);
  }
}

// Slower than 0.8 m/s for two seconds, which is asleep.
TEST(BulletWorld, ASlowBodyStopsOnlyIfItMaySleep) {
  const World world = OnPlane(Box{{0.5, 0.5, 0.5}}, 0.5, 0.1);
  for (const Oracle* oracle : Simulators()) {
    EXPECT_NEAR(EndOf(*oracle, {}, world).v_WB.x(), 0.1, 1e-6);
    EXPECT_EQ(EndOf(*oracle, {.chosen = {{"sleeping", 1}}}, world).v_WB.x(), 0);
  }
}

TEST(BulletWorld, APushWakesABodyThatSleeps) {
  const World world = OnPlane(Box{{0.5, 0.5, 0.5}}, 0.5, 0);
  for (const Oracle* oracle : Simulators()) {
    const auto sleeping = oracle->SetUp({.chosen = {{"sleeping", 1}}});
    const auto simulation = sleeping->Begin(world);
    for (int i = 0; i < world.steps; ++i) simulation->Step();
    WorldState state;
    simulation->Read(state);
    const Eigen::Vector3d p_W = state.bodies.back().p_WB;
    simulation->Push(1, p_W, {0.5, 0, 0});
    simulation->Step();
    simulation->Read(state);
    EXPECT_NEAR(state.bodies.back().v_WB.x(), 0.5, 1e-6);
  }
}

TEST(BulletWorld, ClosestPointsDoNotSimulate) {
  const std::vector<std::unique_ptr<Oracle>> oracles =
      BulletOracles(BulletPrecision::kDouble);
  EXPECT_EQ(oracles[1]->Begin(BrickOnSlab()), nullptr);
  EXPECT_EQ(oracles[1]->Simulate(BrickOnSlab()).status, AnswerStatus::kUnsupported);
}

TEST(BulletWorld, StatesWhyItHasNoSprings) {
  for (const Oracle* oracle : Simulators()) {
    World world = BrickOnSlab();
    world.springs.emplace_back();
    const Trajectory trajectory = oracle->Simulate(world);
    EXPECT_EQ(trajectory.status, AnswerStatus::kUnsupported);
    EXPECT_EQ(trajectory.reason,
              "Bullet has springs along the axes of a body but none between two points");
  }
}

}  // namespace
}  // namespace touchstone
