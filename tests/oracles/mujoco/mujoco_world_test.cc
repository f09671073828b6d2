#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "oracles/mujoco/mujoco_oracles.h"

namespace touchstone {
namespace {

using Eigen::Vector3d;

/* "mujoco" and "mujoco/rk4". */
const std::vector<std::unique_ptr<Oracle>>& Simulators() {
  static const std::vector<std::unique_ptr<Oracle>> oracles = MujocoOracles();
  return oracles;
}

const Oracle& Euler() {
  return *Simulators()[0];
}

const Oracle& Rk4() {
  return *Simulators()[1];
}

// What a contact leaves undone of what it is to change, 1 − mjMAXIMP.
constexpr double kSoftness = 1e-4;

RigidBody Ball(const Vector3d& p_W) {
  RigidBody ball;
  ball.name = "ball";
  ball.mass = 1.3;
  ball.restitution = 0;
  ball.placed = {Sphere{0.1}, Pose::FromQuaternion(p_W, {1, 0, 0, 0})};
  return ball;
}

RigidBody Slab() {
  RigidBody slab;
  slab.name = "slab";
  slab.mass = 0;
  slab.restitution = 0;
  slab.placed = {Box{{5, 0.5, 5}}, Pose::FromQuaternion({0, -0.5, 0}, {1, 0, 0, 0})};
  return slab;
}

/* A turned brick that falls on a corner, sliding and spinning, onto a static slab. */
World BrickOnSlab() {
  World world;
  RigidBody brick;
  brick.name = "brick";
  brick.mass = 1.7;
  brick.restitution = 0;
  const Eigen::AngleAxisd turn(0.3, Vector3d(0.2, 1, -0.4).normalized());
  brick.placed = {Box{{0.3, 0.2, 0.1}},
                  Pose::FromQuaternion({0.1, 0.4, -0.2}, Eigen::Quaterniond(turn))};
  brick.v_WB = {0.7, -1, 0.3};
  brick.w_WB = {1, 2, -0.5};
  brick.force_W = {0.4, 0.1, -0.2};
  world.bodies = {Slab(), brick};
  return world;
}

TEST(MujocoWorld, ContactImpulsesAreWhatChangesMomentum) {
  const World world = BrickOnSlab();
  const RigidBody& brick = world.bodies[1];
  const Trajectory trajectory = Euler().Simulate(world);
  ASSERT_EQ(trajectory.samples.size(), static_cast<std::size_t>(world.steps) + 1);
  Vector3d momentum = brick.mass * brick.v_WB;
  std::size_t next = 0;
  int contacts = 0;
  // Of velocities of metres a second, each rounded in every step, and of forces of
  // stiffnesses 1e4 times as large.
  const double allowed = 1e4 * 64 * world.steps * 0x1p-53;
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
  EXPECT_FALSE(Rk4().Simulate(world).gives_impulses);
}

// m v' = m v − h (k x + b v), x' = x + h v'.
TEST(MujocoWorld, SpringPullsAtTheStartOfAStep) {
  World world;
  world.gravity_W.setZero();
  world.dt = 1e-2;
  world.steps = 300;
  const Vector3d direction = Vector3d(0.3, -0.2, 0.7).normalized();
  const double rest_length = 0.8;
  const double k = 100;
  const double b = 0.7;
  world.bodies = {Ball((rest_length + 0.25) * direction)};
  const double m = world.bodies[0].mass;
  world.springs = {{{}, {AnchorKind::kBody, 0, Vector3d::Zero()}, k, b, rest_length}};
  const Trajectory euler = Euler().Simulate(world);
  const Trajectory rk4 = Rk4().Simulate(world);
  // x(t) = e^(−bt/2m) (cos ωt + b/(2mω) sin ωt) / 4
  const double decay = b / (2 * m);
  const double omega = std::sqrt(k / m - decay * decay);
  double x = 0.25;
  double v = 0;
  for (int step = 1; step <= world.steps; ++step) {
    const auto i = static_cast<std::size_t>(step);
    v -= world.dt * (k * x + b * v) / m;
    x += world.dt * v;
    ASSERT_NEAR(euler.samples[i].bodies[0].p_WB.dot(direction), rest_length + x,
                1e-14 * step);
    const double t = step * world.dt;
    const double truth = std::exp(-decay * t) *
                         (std::cos(omega * t) + decay / omega * std::sin(omega * t)) / 4;
    // Its phase is late by (ωh)⁵/120 a step; the amplitude goes less wrong.
    ASSERT_NEAR(rk4.samples[i].bodies[0].p_WB.dot(direction) - rest_length, truth,
                0.25 * std::pow(omega * world.dt, 5) / 120 * step * 1.5);
  }
}

// The velocity along the rod after the step is what shortens the excess length by a
// fifth, but for the share that a constraint leaves undone of what it changes.
TEST(MujocoWorld, DistanceJointTakesBackAFifthOfItsErrorAStep) {
  World world;
  world.dt = 1e-2;
  world.steps = 200;
  const double length = 0.9;
  world.bodies = {Ball({0.7, 0, 0.5})};
  world.joints = {{{AnchorKind::kBody, 0, Vector3d::Zero()},
                   {AnchorKind::kWorld, -1, Vector3d(0, 0.1, 0)},
                   length}};
  const Trajectory trajectory = Euler().Simulate(world);
  double longest = 0;
  for (int step = 1; step <= world.steps; ++step) {
    const auto before = static_cast<std::size_t>(step) - 1;
    const BodyState& body = trajectory.samples[before].bodies[0];
    const Vector3d r = body.p_WB - world.joints[0].B.point;
    const Vector3d n = r.normalized();
    const Vector3d v = trajectory.samples[before + 1].bodies[0].v_WB;
    const double wanted = -0.2 * (r.norm() - length) / world.dt;
    const double free = n.dot(body.v_WB + world.dt * world.gravity_W);
    ASSERT_NEAR(n.dot(v), wanted + kSoftness * (free - wanted), 1e-12);
    longest = std::max(longest, r.norm());
  }
  EXPECT_GT(longest, length + 1e-4);  // There was something to take back.
}

TEST(MujocoWorld, JointsHoldAtAnchorsOfStaticBodiesEitherWayRound) {
  World world;
  RigidBody post = Ball({0.2, 1, -0.3});
  post.name = "post";
  post.mass = 0;
  post.collides = false;
  world.bodies = {post, Ball({0.7, 1, 0.1})};
  const Anchor on_post{AnchorKind::kBody, 0, Vector3d(0.1, 0, 0)};
  const Anchor on_ball{AnchorKind::kBody, 1, Vector3d(0, 0.1, 0)};
  const double length = (world.bodies[0].placed.X_WB * on_post.point -
                         world.bodies[1].placed.X_WB * on_ball.point)
                            .norm();
  world.joints = {{on_post, on_ball, length}};
  const BodyState one = Euler().Simulate(world).samples.back().bodies[1];
  world.joints = {{on_ball, on_post, length}};
  const BodyState other = Euler().Simulate(world).samples.back().bodies[1];
  EXPECT_LE((one.p_WB - other.p_WB).norm(), 1e-9);  // Swings amplify a rounding.
  const double held =
      (one.p_WB + one.q_WB * on_ball.point - world.bodies[0].placed.X_WB * on_post.point)
          .norm();
  // A swing of 3 m/s moves off its circle by (v h)²/2 L = 1e-4 m a step, of which a fifth
  // is taken back in each.
  EXPECT_NEAR(held, length, 5 * 1e-4);
}

// Sinking by what a contact leaves undone of gravity in each step.
TEST(MujocoWorld, BodyAtRestSinksByTheSoftnessOfItsContact) {
  World world;
  world.dt = 1e-3;
  world.steps = 500;
  world.bodies = {Ball({0, 0.1 - 1e-6, 0}), Slab()};
  const BodyState end = Euler().Simulate(world).samples.back().bodies[0];
  EXPECT_NEAR(end.v_WB.y(), -kSoftness * 9.82 * world.dt, 1e-9);
}

TEST(MujocoWorld, PushActsAtItsPoint) {
  World world;
  world.gravity_W.setZero();
  world.steps = 1;
  world.bodies = {Ball(Vector3d::Zero())};
  world.bodies[0].inertia = Vector3d(0.01, 0.02, 0.025);
  const Eigen::Quaterniond q_WB(Eigen::AngleAxisd(0.7, Vector3d(1, 2, 2) / 3));
  world.bodies[0].placed.X_WB = Pose::FromQuaternion({0.3, 0.1, -0.2}, q_WB);
  const Vector3d p_BoP(0.1, -0.05, 0.02);
  const Vector3d J_W(0.3, 0.4, -0.1);
  world.pushes = {{0, 0, p_BoP, J_W}};
  const BodyState end = Rk4().Simulate(world).samples.back().bodies[0];
  EXPECT_LE((end.v_WB - J_W / 1.3).norm(), 1e-15);
  const Vector3d L_B = p_BoP.cross(q_WB.conjugate() * J_W);
  const Vector3d w_B = L_B.cwiseQuotient(*world.bodies[0].inertia);
  const Eigen::Matrix3d R = q_WB.toRotationMatrix();
  // It tumbles on for the rest of the step: angular momentum is what stays.
  const Vector3d L_W =
      end.q_WB *
      ((end.q_WB.conjugate() * end.w_WB).cwiseProduct(*world.bodies[0].inertia));
  EXPECT_LE((L_W - R * L_B).norm(), 1e-8 * L_B.norm());
  EXPECT_LE((end.w_WB - R * w_B).norm(), 0.1 * w_B.norm());
}

TEST(MujocoWorld, BodiesThatDoNotCollidePassThroughEverything) {
  for (const auto& oracle : Simulators()) {
    World world = BrickOnSlab();
    world.bodies[1].collides = false;
    const Trajectory trajectory = oracle->Simulate(world);
    EXPECT_TRUE(trajectory.impulses.empty());
    EXPECT_LT(trajectory.samples.back().bodies[1].p_WB.y(), -5);
    EXPECT_EQ(trajectory.samples.back().bodies[0].p_WB, Vector3d(0, -0.5, 0));
  }
}

TEST(MujocoWorld, WhatItStartsAnewHasDiverged) {
  World world;
  world.steps = 10;
  world.bodies = {Ball(Vector3d::Zero())};
  world.bodies[0].force_W = {1e300, 0, 0};
  const Trajectory trajectory = Euler().Simulate(world);
  EXPECT_EQ(trajectory.status, AnswerStatus::kAnswered);
  EXPECT_EQ(trajectory.diverged_at_step, 1);
  EXPECT_NE(trajectory.complaint.find("unstable"), std::string::npos)
      << trajectory.complaint;
}

}  // namespace
}  // namespace touchstone
