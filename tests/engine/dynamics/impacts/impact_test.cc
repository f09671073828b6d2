#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "engine/dynamics/world/world.h"

namespace cookbook {
namespace {

BodyDefinition Floor() {
  BodyDefinition floor;
  floor.shape = Box{{20, 1, 20}};
  floor.state.p_WB = {0, -1, 0};
  floor.mass = 0;
  floor.restitution = 1;
  return floor;
}

TEST(Impact, AnElasticBallConservesEnergyForAnyTimeStep) {
  for (const double h : {1e-4, 1e-3, 4e-3, 1e-2, 4e-2}) {
    Settings settings;
    settings.gravity_W = {0, -9.81, 0};
    World world(settings);
    world.AddBody(Floor());
    BodyDefinition ball;
    ball.shape = Sphere{0.1};
    ball.mass = 10;
    ball.restitution = 1;
    ball.friction = 0;
    ball.state.p_WB = {0, 5, 0};
    const int body = world.AddBody(ball);
    const double start = 10 * 9.81 * 5;
    double worst = 0;
    const int steps = static_cast<int>(20 / h);
    for (int k = 0; k < steps; ++k) {
      world.Step(h);
      const BodyState& state = world.state(body);
      const double energy = 10 * (9.81 * state.p_WB[1] + state.v_WB.squaredNorm() / 2);
      worst = std::max(worst, std::abs(energy - start));
    }
    EXPECT_LT(worst, 16 * steps * start * 0x1p-53) << h;
  }
}

TEST(Impact, ABoxThatLandsFlatBouncesWithItsRestitution) {
  World world;
  world.AddBody(Floor());
  BodyDefinition box;
  box.shape = Box{{0.5, 0.3, 0.4}};
  box.restitution = 0.5;
  box.state.p_WB = {0, 0.3, 0};
  box.state.v_WB = {0, -4, 0};
  const int body = world.AddBody(box);
  const double h = 1e-3;
  world.Step(h);
  EXPECT_NEAR(world.state(body).v_WB[1], 2 - 9.82 * h, 1e-12);
  EXPECT_LT(world.state(body).w_WB.norm(), 1e-12);
}

/** A number in [−1, 1]. */
double AnyFraction() {
  return *rc::gen::inRange(-1000, 1001) / 1000.0;
}

double KineticEnergy(const World& world) {
  double energy = 0;
  for (int i = 0; i < world.body_count(); ++i) {
    energy += world.state(i).v_WB.squaredNorm() / 2;  // 1 kg each; the floor is static.
  }
  return energy;
}

// Any combination of impacts in one step. A ball that has just left the floor and is hit
// from above returns to the floor on its own path, and is not held there.
RC_GTEST_PROP(Impact, SimultaneousImpactsInAColumnOfBallsDoNotAddEnergy, ()) {
  Settings settings;
  settings.gravity_W.setZero();
  settings.speculative_margin = 1e-4;
  World world(settings);
  const double e = std::abs(AnyFraction());
  BodyDefinition floor = Floor();
  floor.restitution = e;
  world.AddBody(floor);
  double height = 0;
  for (int i = 0; i < 5; ++i) {
    BodyDefinition ball;
    ball.shape = Sphere{0.1};
    ball.restitution = e;
    ball.friction = 0;
    height += 1e-4 * AnyFraction();
    ball.state.p_WB = {0, height + 0.1, 0};
    ball.state.v_WB = {0, 5 * AnyFraction(), 0};
    height += 0.2;
    world.AddBody(ball);
  }
  const double before = KineticEnergy(world);
  world.Step(1e-3);
  // The rounding of about a hundred sums for each of five velocities, and the residual of
  // the solver.
  RC_ASSERT(KineticEnergy(world) <= before * (1 + 500 * 0x1p-53) + 1e-12);
}

TEST(Impact, ABallThatIsHitAsItLeavesTheFloorConservesEnergy) {
  const double h = 2e-3;
  Settings settings;
  settings.gravity_W = {0, -9.81, 0};
  World world(settings);
  world.AddBody(Floor());
  BodyDefinition ball;
  ball.shape = Sphere{0.1};
  ball.restitution = 1;
  ball.state.p_WB = {0, 0.1 + 4e-5, 0};
  ball.state.v_WB = {0, 4.43, 0};
  const int leaves = world.AddBody(ball);
  ball.state.p_WB = {0, 0.3 - 9e-3, 0};
  ball.state.v_WB = {0, -4.47, 0};
  const int approaches = world.AddBody(ball);
  const auto energy = [&] {
    double sum = 0;
    for (const int i : {leaves, approaches}) {
      sum += 9.81 * world.state(i).p_WB[1] + world.state(i).v_WB.squaredNorm() / 2;
    }
    return sum;
  };
  const double before = energy();
  for (int k = 0; k < 2; ++k) world.Step(h);
  // Each impact is early or late by less than a step, during which gravity does work.
  EXPECT_NEAR(energy(), before, 2 * h * 9.81 * 4.47);
  EXPECT_GT(world.state(leaves).v_WB[1], 4);
}

}  // namespace
}  // namespace cookbook
