#include "tests/oracles/simulator_promises.h"

#include <algorithm>
#include <cstddef>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace touchstone {

using Eigen::Vector3d;

RigidBody Ball(const Vector3d& p_W) {
  RigidBody ball;
  ball.name = "ball";
  ball.mass = 1.3;
  ball.placed = {Sphere{0.1}, Pose::FromQuaternion(p_W, {1, 0, 0, 0})};
  return ball;
}

RigidBody Slab() {
  RigidBody slab;
  slab.name = "slab";
  slab.mass = 0;
  slab.placed = {Box{{5, 0.5, 5}}, Pose::FromQuaternion({0, -0.5, 0}, {1, 0, 0, 0})};
  return slab;
}

World BrickOnSlab() {
  RigidBody brick;
  brick.name = "brick";
  brick.mass = 1.7;
  const Eigen::AngleAxisd turn(0.3, Vector3d(0.2, 1, -0.4).normalized());
  brick.placed = {Box{{0.3, 0.2, 0.1}},
                  Pose::FromQuaternion({0.1, 0.4, -0.2}, Eigen::Quaterniond(turn))};
  brick.v_WB = {0.7, -1, 0.3};
  brick.w_WB = {1, 2, -0.5};
  brick.force_W = {0.4, 0.1, -0.2};
  World world;
  world.bodies = {Slab(), brick};
  return world;
}

void ExpectImpulsesChangeMomentum(const Oracle& oracle, const World& world,
                                  double allowed) {
  SCOPED_TRACE(oracle.info().name);
  const RigidBody& brick = world.bodies[1];
  const Trajectory trajectory = oracle.Simulate(world);
  ASSERT_EQ(trajectory.samples.size(), static_cast<std::size_t>(world.steps) + 1);
  Vector3d momentum = brick.mass * brick.v_WB;
  std::size_t next = 0;
  int contacts = 0;
  for (int step = 1; step <= world.steps; ++step) {
    momentum += world.dt * (brick.mass * world.gravity_W + brick.force_W);
    for (; next < trajectory.impulses.size() && trajectory.impulses[next].step == step;
         ++next, ++contacts) {
      const ContactImpulse& impulse = trajectory.impulses[next];
      EXPECT_LE(impulse.separation, 0);
      EXPECT_GE(impulse.J_B_W.dot(impulse.n_AB_W), 0);
      momentum += impulse.B == 1 ? impulse.J_B_W : Vector3d(-impulse.J_B_W);
    }
    const Vector3d v = trajectory.samples[static_cast<std::size_t>(step)].bodies[1].v_WB;
    ASSERT_LE((brick.mass * v - momentum).norm(), allowed) << "step " << step;
  }
  EXPECT_EQ(next, trajectory.impulses.size());
  EXPECT_GT(contacts, 20);  // It landed.
}

void ExpectPassesThroughEverything(const Oracle& oracle) {
  SCOPED_TRACE(oracle.info().name);
  World world = BrickOnSlab();
  world.bodies[1].collides = false;
  const Trajectory trajectory = oracle.Simulate(world);
  ASSERT_FALSE(trajectory.samples.empty());
  EXPECT_TRUE(trajectory.impulses.empty());
  EXPECT_LT(trajectory.samples.back().bodies[1].p_WB.y(), -5);
  EXPECT_EQ(trajectory.samples.back().bodies[0].p_WB, Vector3d(0, -0.5, 0));
}

void ExpectJointTakesBackAFifthOfItsError(const Oracle& oracle, double undone,
                                          double allowed) {
  SCOPED_TRACE(oracle.info().name);
  World world;
  world.dt = 1e-2;
  world.steps = 200;
  const double length = 0.9;
  world.bodies = {Ball({0.7, 0, 0.5})};
  world.joints = {{{AnchorKind::kBody, 0, Vector3d::Zero()},
                   {AnchorKind::kWorld, -1, Vector3d(0, 0.1, 0)},
                   length}};
  const Trajectory trajectory = oracle.Simulate(world);
  ASSERT_EQ(trajectory.samples.size(), static_cast<std::size_t>(world.steps) + 1);
  double longest = 0;
  for (int step = 1; step <= world.steps; ++step) {
    const auto before = static_cast<std::size_t>(step) - 1;
    const BodyState& body = trajectory.samples[before].bodies[0];
    const Vector3d r = body.p_WB - world.joints[0].B.point;
    const Vector3d n = r.normalized();
    const Vector3d v = trajectory.samples[before + 1].bodies[0].v_WB;
    const double wanted = -0.2 * (r.norm() - length) / world.dt;
    const double free = n.dot(body.v_WB + world.dt * world.gravity_W);
    ASSERT_NEAR(n.dot(v), wanted + undone * (free - wanted), allowed);
    longest = std::max(longest, r.norm());
  }
  EXPECT_GT(longest, length + 1e-4);  // There was an error to correct.
}

void ExpectJointHoldsEitherWayRound(const Oracle& oracle, double allowed) {
  SCOPED_TRACE(oracle.info().name);
  World world;
  RigidBody post = Ball({0.2, 1, -0.3});
  post.name = "post";
  post.mass = 0;
  post.collides = false;
  world.bodies = {post, Ball({0.7, 1, 0.1})};
  const Anchor on_post{AnchorKind::kBody, 0, Vector3d(0.1, 0, 0)};
  const Anchor on_ball{AnchorKind::kBody, 1, Vector3d(0, 0.1, 0)};
  const Vector3d p_WPost = post.placed.X_WB * on_post.point;
  const double length = (p_WPost - world.bodies[1].placed.X_WB * on_ball.point).norm();
  world.joints = {{on_post, on_ball, length}};
  const Trajectory one = oracle.Simulate(world);
  world.joints = {{on_ball, on_post, length}};
  const Trajectory other = oracle.Simulate(world);
  ASSERT_FALSE(one.samples.empty());
  ASSERT_FALSE(other.samples.empty());
  const BodyState& ball = one.samples.back().bodies[1];
  EXPECT_LE((ball.p_WB - other.samples.back().bodies[1].p_WB).norm(), allowed);
  // This is one second later. A swing of 3 m/s leaves its circle by (v h)²/2 L = 1e-4 m
  // per step, and each step corrects a fifth of the error.
  EXPECT_NEAR((ball.p_WB + ball.q_WB * on_ball.point - p_WPost).norm(), length, 5 * 1e-4);
}

void ExpectPushesOverlapOutOnlyAsShipped(const Oracle& oracle, double speed,
                                         double allowed) {
  SCOPED_TRACE(oracle.info().name);
  World world;
  world.bodies = {Ball({0, 0.1 - 1e-3, 0}), Slab()};
  WorldState state;
  for (const bool as_shipped : {false, true}) {
    const auto simulation =
        as_shipped ? oracle.BeginAsShipped(world) : oracle.Begin(world);
    simulation->Step();
    simulation->Read(state);
    EXPECT_NEAR(state.bodies[0].v_WB.y(), as_shipped ? speed : 0, allowed);
  }
  WorldSetup chosen;
  for (const WorldParameter& parameter : oracle.info().parameters) {
    EXPECT_EQ(Refusal(parameter, parameter.here), "") << parameter.name;
    EXPECT_EQ(Refusal(parameter, parameter.shipped), "") << parameter.name;
    chosen.chosen[parameter.name] = parameter.shipped;
  }
  for (const WorldSetup& setup : {chosen, WorldSetup{.as_shipped = true, .chosen = {}}}) {
    world.steps = 1;
    world.sample_every = 1;
    const Trajectory trajectory = oracle.SetUp(setup)->Simulate(world);
    ASSERT_EQ(trajectory.status, AnswerStatus::kAnswered) << trajectory.reason;
    EXPECT_EQ(trajectory.samples.back().bodies[0].v_WB, state.bodies[0].v_WB);
  }
}

}  // namespace touchstone
