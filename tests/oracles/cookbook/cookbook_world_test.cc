#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <iterator>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

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

/** Returns 150 boxes in a row that fall 1 cm onto a floor: 600 contacts, more than the
 iteration budget allows to converge. */
World ManyBoxes() {
  World world;
  world.gravity_W = {0, -9.81, 0};
  world.dt = 1.0 / 240;
  world.steps = 120;
  world.sample_every = 120;
  world.bodies.resize(151);
  RigidBody& floor = world.bodies[0];
  floor.placed.shape = Box{{400, 1, 400}};
  floor.placed.X_WB.p_WB = {0, -1, 0};
  floor.mass = 0;
  for (std::size_t k = 1; k < world.bodies.size(); ++k) {
    RigidBody& box = world.bodies[k];
    box.placed.shape = Box{{0.25, 0.25, 0.25}};
    box.placed.X_WB.p_WB = {1.0 * static_cast<double>(k), 0.26, 0};
    box.v_WB = {0.5, 0, 0.1};
    box.restitution = 0;
  }
  return world;
}

/** Returns where ManyBoxes() are after half a second with the settings `chosen`. */
std::vector<BodyState> BoxesWith(std::map<std::string, double, std::less<>> chosen) {
  const CookbookOracle oracle;
  const Trajectory trajectory =
      oracle.SetUp({.as_shipped = false, .chosen = std::move(chosen)})
          ->Simulate(ManyBoxes());
  EXPECT_EQ(trajectory.status, AnswerStatus::kAnswered) << trajectory.reason;
  return trajectory.samples.back().bodies;
}

double GreatestDistance(const std::vector<BodyState>& a,
                        const std::vector<BodyState>& b) {
  double greatest = 0;
  for (std::size_t k = 0; k < a.size(); ++k)
    greatest = std::max(greatest, (a[k].p_WB - b[k].p_WB).norm());
  return greatest;
}

// 120 steps of ten iterations of 30 operations round by 6e-8 of at most 0.6 m/s.
TEST(CookbookWorld, SinglePrecisionMovesManyBodiesByRoundingOnly) {
  const double distance =
      GreatestDistance(BoxesWith({}), BoxesWith({{"single_precision", 0}}));
  EXPECT_GT(distance, 0) << "Single precision was not used.";
  EXPECT_LT(distance, 120 * 10 * 30 * 6e-8 * 0.6 / 240);
}

TEST(CookbookWorld, ThreadsDoNotChangeTheMotion) {
  EXPECT_EQ(GreatestDistance(BoxesWith({}), BoxesWith({{"threads", 3}})), 0);
}

TEST(CookbookWorld, ThreadsHaveTheSettingsThatAreChosen) {
  const CookbookOracle oracle;
  const std::unique_ptr<Oracle> chosen =
      oracle.SetUp({.as_shipped = false, .chosen = {{"iterations", 30}}});
  const World world = ManyBoxes();
  WorldState one;
  WorldState two;
  const std::unique_ptr<Simulation> alone = chosen->BeginAsShipped(world);
  const std::unique_ptr<Simulation> shared = chosen->BeginInThreads(world, 2);
  for (int k = 0; k < 20; ++k) {
    alone->Step();
    shared->Step();
  }
  alone->Read(one);
  shared->Read(two);
  EXPECT_EQ(GreatestDistance(one.bodies, two.bodies), 0);
}

TEST(CookbookWorld, IterationsAndTheirBudgetReachTheEngine) {
  EXPECT_GT(GreatestDistance(BoxesWith({}), BoxesWith({{"iterations", 30}})), 1e-9);
  EXPECT_GT(GreatestDistance(BoxesWith({}), BoxesWith({{"iteration_budget", 100'000}})),
            1e-9);
}

TEST(CookbookWorld, BodiesThatSleepHaveNoVelocity) {
  const auto greatest_speed = [](const std::vector<BodyState>& bodies) {
    double speed = 0;
    for (const BodyState& body : bodies)
      speed = std::max(speed, body.v_WB.norm() + body.w_WB.norm());
    return speed;
  };
  EXPECT_GT(greatest_speed(BoxesWith({})), 0);
  EXPECT_EQ(greatest_speed(BoxesWith({{"sleep_after", 0.1}})), 0);
}

}  // namespace
}  // namespace touchstone
