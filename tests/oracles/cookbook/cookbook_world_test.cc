#include <cstddef>
#include <filesystem>
#include <iterator>

#include <gtest/gtest.h>

#include "oracles/cookbook/cookbook_oracle.h"

namespace touchstone {
namespace {

TEST(CookbookWorld, SlidingBallEndsUpRollingAtFiveSeventhsOfItsSpeed) {
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
  // Angular momentum about the contact point is conserved: 5/7 of the speed remains.
  EXPECT_NEAR(trajectory.samples.back().bodies[1].v_WB[0], 25.0 / 7, 1e-12);
}

TEST(CookbookWorld, DistinguishesParticlesAndNodesFromBodies) {
  World world;
  world.bodies.resize(1);
  world.bodies[0].name = "ball";
  world.bodies[0].placed.shape = Sphere{0.5};
  world.bodies[0].placed.X_WB.p_WB = {9, 0, 0};
  world.particles.resize(2);
  world.particles[0].name = "anchor";
  world.particles[0].mass = 0;
  world.particles[1].name = "bob";
  world.particles[1].p_W = {0, -2, 0};
  // The bob hangs in static equilibrium, so it stays there.
  world.springs.push_back({{AnchorKind::kParticle, 0, {0, 0, 0}},
                           {AnchorKind::kParticle, 1, {0, 0, 0}},
                           9.82,
                           0,
                           1});
  world.cloths.resize(1);
  world.cloths[0].name = "net";
  world.cloths[0].centre = {3, 4, 5};
  world.steps = 240;
  const CookbookOracle oracle;
  ASSERT_EQ(oracle.info().CannotSimulate(world), "");
  const Trajectory trajectory = oracle.Simulate(world);
  ASSERT_EQ(trajectory.status, AnswerStatus::kAnswered);
  const WorldState& end = trajectory.samples.back();
  ASSERT_EQ(end.bodies.size(), 1u);
  ASSERT_EQ(end.particles.size(), 2u);
  ASSERT_EQ(end.nodes.size(), 9u);
  EXPECT_NEAR(end.bodies[0].p_WB[1], -0.5 * 9.82, 1e-12);
  EXPECT_EQ(end.particles[0].p_W, Eigen::Vector3d(0, 0, 0));
  EXPECT_LT((end.particles[1].p_W - Eigen::Vector3d(0, -2, 0)).norm(), 1e-12);
  EXPECT_LT((end.nodes[4].p_W - Eigen::Vector3d(3, 4 - 0.5 * 9.82, 5)).norm(), 1e-12);
}

std::ptrdiff_t ThreadsOfThisProcess() {
  return std::distance(std::filesystem::directory_iterator("/proc/self/task"), {});
}

TEST(CookbookWorld, UsesTheRequestedNumberOfThreads) {
  World world;
  const CookbookOracle oracle;
  ASSERT_TRUE(oracle.info().steps_in_threads);
  const std::ptrdiff_t before = ThreadsOfThisProcess();
  const auto shipped = oracle.BeginAsShipped(world);
  EXPECT_EQ(ThreadsOfThisProcess(), before);
  const auto three = oracle.BeginInThreads(world, 3);
  EXPECT_EQ(ThreadsOfThisProcess(), before + 2);
}

TEST(CookbookWorld, RefusesWhatItCannotSimulate) {
  World world;
  world.bodies.resize(1);
  world.bodies[0].name = "can";
  world.bodies[0].placed.shape = Cylinder{0.1, 0.2};
  const CookbookOracle oracle;
  EXPECT_EQ(oracle.Simulate(world).status, AnswerStatus::kUnsupported);
}

}  // namespace
}  // namespace touchstone
