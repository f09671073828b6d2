#include <gtest/gtest.h>

#include "oracles/cookbook/cookbook_oracle.h"

namespace touchstone {
namespace {

TEST(CookbookWorld, ABallOnAFloorRollsAsTheEngineSays) {
  World world;
  world.bodies.resize(2);
  world.bodies[0].name = "floor";
  world.bodies[0].placed = {HalfSpace{}, {}};
  world.bodies[0].mass = 0;
  world.bodies[1].name = "ball";
  world.bodies[1].placed.shape = Sphere{0.5};
  world.bodies[1].placed.X_WB.p_WB = {0, 0, 0.5};
  world.bodies[1].v_WB = {5, 0, 0};
  world.gravity_W = {0, 0, -9.81};
  world.dt = 1e-3;
  world.steps = 2000;
  const CookbookOracle oracle;
  ASSERT_EQ(oracle.info().CannotSimulate(world), "");

  const Trajectory trajectory = oracle.Simulate(world);
  ASSERT_EQ(trajectory.status, AnswerStatus::kAnswered);
  EXPECT_EQ(trajectory.diverged_at_step, 0);
  EXPECT_FALSE(trajectory.impulses.empty());
  // Angular momentum about the point of contact is kept: 5/7 of the speed is left.
  EXPECT_NEAR(trajectory.samples.back().bodies[1].v_WB[0], 25.0 / 7, 1e-12);
}

TEST(CookbookWorld, RefusesWhatItCannotSimulate) {
  World world;
  world.particles.resize(1);
  const CookbookOracle oracle;
  EXPECT_EQ(oracle.Simulate(world).status, AnswerStatus::kUnsupported);
}

}  // namespace
}  // namespace touchstone
