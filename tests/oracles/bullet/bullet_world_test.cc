#include <array>
#include <memory>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "oracles/bullet/bullet_oracles.h"

namespace touchstone {
namespace {

using Eigen::Vector3d;

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

Pose At(const Vector3d& p_W) {
  return Pose::FromQuaternion(p_W, Eigen::Quaterniond(Eigen::AngleAxisd(
                                       0.3, Vector3d(0.2, 1, -0.4).normalized())));
}

/* A turned brick that falls on a corner, sliding and spinning, onto a static slab. */
World BrickOnSlab() {
  World world;
  RigidBody slab;
  slab.name = "slab";
  slab.mass = 0;
  slab.placed = {Box{{5, 0.5, 5}}, Pose::FromQuaternion({0, -0.5, 0}, {1, 0, 0, 0})};
  RigidBody brick;
  brick.name = "brick";
  brick.mass = 1.7;
  brick.placed = {Box{{0.3, 0.2, 0.1}}, At({0.1, 0.4, -0.2})};
  brick.v_WB = {0.7, -1, 0.3};
  brick.w_WB = {1, 2, -0.5};
  brick.force_W = {0.4, 0.1, -0.2};
  world.bodies = {slab, brick};
  return world;
}

TEST(BulletWorld, ContactImpulsesAreWhatChangesMomentum) {
  for (const Oracle* oracle : Simulators()) {
    const World world = BrickOnSlab();
    const RigidBody& brick = world.bodies[1];
    const Trajectory trajectory = oracle->Simulate(world);
    ASSERT_EQ(trajectory.samples.size(), static_cast<std::size_t>(world.steps) + 1);
    Vector3d momentum = brick.mass * brick.v_WB;
    std::size_t next = 0;
    int contacts = 0;
    // Velocities of metres a second, each rounded in every step.
    const double allowed = 64 * world.steps * oracle->info().unit_roundoff;
    for (int step = 1; step <= world.steps; ++step) {
      momentum += world.dt * (brick.mass * world.gravity_W + brick.force_W);
      for (; next < trajectory.impulses.size() && trajectory.impulses[next].step == step;
           ++next, ++contacts) {
        const ContactImpulse& impulse = trajectory.impulses[next];
        EXPECT_LE(impulse.separation, 0);
        EXPECT_GE(impulse.J_B_W.dot(impulse.n_AB_W), 0);
        momentum += impulse.B == 1 ? impulse.J_B_W : Vector3d(-impulse.J_B_W);
      }
      const Vector3d v =
          trajectory.samples[static_cast<std::size_t>(step)].bodies[1].v_WB;
      ASSERT_LE((brick.mass * v - momentum).norm(), allowed)
          << oracle->info().name << " step " << step;
    }
    EXPECT_EQ(next, trajectory.impulses.size());
    EXPECT_GT(contacts, 20);  // It landed.
  }
}

TEST(BulletWorld, BodiesThatDoNotCollidePassThroughEverything) {
  for (const Oracle* oracle : Simulators()) {
    World world = BrickOnSlab();
    world.bodies[1].collides = false;
    const Trajectory trajectory = oracle->Simulate(world);
    EXPECT_TRUE(trajectory.impulses.empty());
    EXPECT_LT(trajectory.samples.back().bodies[1].p_WB.y(), -5);
    EXPECT_EQ(trajectory.samples.back().bodies[0].p_WB, Vector3d(0, -0.5, 0));
  }
}

// Bullet's default ERP takes a fifth of a slight overlap in a step; here it stays.
TEST(BulletWorld, PushesOverlapOutOnlyAsShipped) {
  for (const Oracle* oracle : Simulators()) {
    World world = BrickOnSlab();
    world.bodies[1].placed = {Sphere{0.1},
                              Pose::FromQuaternion({0, 0.1 - 1e-3, 0}, {1, 0, 0, 0})};
    world.bodies[1].v_WB = world.bodies[1].w_WB = world.bodies[1].force_W = {0, 0, 0};
    WorldState state;
    for (const bool as_shipped : {false, true}) {
      const auto simulation =
          as_shipped ? oracle->BeginAsShipped(world) : oracle->Begin(world);
      simulation->Step();
      simulation->Read(state);
      EXPECT_NEAR(state.bodies[1].v_WB.y(), as_shipped ? 0.2e-3 / world.dt : 0, 1e-5);
    }
  }
}

TEST(BulletWorld, ClosestPointsDoNotSimulate) {
  const std::vector<std::unique_ptr<Oracle>> oracles =
      BulletOracles(BulletPrecision::kDouble);
  EXPECT_EQ(oracles[1]->Begin(BrickOnSlab()), nullptr);
  EXPECT_EQ(oracles[1]->Simulate(BrickOnSlab()).status, AnswerStatus::kUnsupported);
}

TEST(BulletWorld, SaysWhyItHasNoSprings) {
  for (const Oracle* oracle : Simulators()) {
    World world = BrickOnSlab();
    world.springs.emplace_back();
    const Trajectory trajectory = oracle->Simulate(world);
    EXPECT_EQ(trajectory.status, AnswerStatus::kUnsupported);
    EXPECT_EQ(trajectory.reason,
              "Bullet has springs along the axes of a body, and none between two points");
  }
}

}  // namespace
}  // namespace touchstone
