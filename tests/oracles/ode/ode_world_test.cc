#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "oracles/ode/ode_oracles.h"

namespace touchstone {
namespace {

using Eigen::Vector3d;

/* "ode" and "ode/quick". */
const std::vector<std::unique_ptr<Oracle>>& Simulators() {
  static const std::vector<std::unique_ptr<Oracle>> oracles = OdeOracles();
  return oracles;
}

// A rod gives by its CFM, 1e-12 m/s for each newton: of at most 100 N here, for in its
// first step it brings 1.3 kg to 0.7 m/s in 0.01 s.
constexpr double kSoftness = 1e-10;  // [m/s]

RigidBody Ball(const Vector3d& p_W) {
  RigidBody ball;
  ball.name = "ball";
  ball.mass = 1.3;
  ball.placed = {Sphere{0.1}, Pose::FromQuaternion(p_W, {1, 0, 0, 0})};
  return ball;
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
  const Eigen::AngleAxisd turn(0.3, Vector3d(0.2, 1, -0.4).normalized());
  brick.placed = {Box{{0.3, 0.2, 0.1}},
                  Pose::FromQuaternion({0.1, 0.4, -0.2}, Eigen::Quaterniond(turn))};
  brick.v_WB = {0.7, -1, 0.3};
  brick.w_WB = {1, 2, -0.5};
  brick.force_W = {0.4, 0.1, -0.2};
  world.bodies = {slab, brick};
  return world;
}

TEST(OdeWorld, ContactImpulsesAreWhatChangesMomentum) {
  for (const auto& oracle : Simulators()) {
    const World world = BrickOnSlab();
    const RigidBody& brick = world.bodies[1];
    const Trajectory trajectory = oracle->Simulate(world);
    ASSERT_EQ(trajectory.samples.size(), static_cast<std::size_t>(world.steps) + 1);
    Vector3d momentum = brick.mass * brick.v_WB;
    std::size_t next = 0;
    int contacts = 0;
    // Velocities of metres a second, each rounded in every step.
    const double allowed = 64 * world.steps * 0x1p-53;
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

// m v' = m v − h (k (x + h v') + b v'), x' = x + h v': the implicit step that ODE's
// manual derives ERP and CFM from.
TEST(OdeWorld, SpringTakesImplicitSteps) {
  for (const auto& oracle : Simulators()) {
    World world;
    world.gravity_W.setZero();
    world.dt = 1e-2;
    world.steps = 300;
    const Vector3d direction = Vector3d(0.3, -0.2, 0.7).normalized();
    const double rest_length = 0.8;
    double x = 0.25;
    world.bodies = {Ball((rest_length + x) * direction)};
    const double m = world.bodies[0].mass;
    const double k = 100;
    const double b = 0.7;
    world.springs = {{{}, {AnchorKind::kBody, 0, Vector3d::Zero()}, k, b, rest_length}};
    const Trajectory trajectory = oracle->Simulate(world);
    double v = 0;
    for (int step = 1; step <= world.steps; ++step) {
      const double h = world.dt;
      v = (m * v - h * k * x) / (m + h * h * k + h * b);
      x += h * v;
      const BodyState& body =
          trajectory.samples[static_cast<std::size_t>(step)].bodies[0];
      // QuickStep's relaxation (w = 1.3) of one row ends at 0.3^200 of its error.
      ASSERT_NEAR(body.p_WB.dot(direction), rest_length + x, 1e-13 * step);
      ASSERT_NEAR(body.v_WB.dot(direction), v, 1e-13 * step);
    }
  }
}

TEST(OdeWorld, SpringWithoutStiffnessAndDampingDoesNothing) {
  World world;
  world.bodies = {Ball({1, 2, 3})};
  world.springs = {{{}, {AnchorKind::kBody, 0, Vector3d::Zero()}, 0, 0, 1}};
  World without = world;
  without.springs.clear();
  for (const auto& oracle : Simulators()) {
    EXPECT_EQ(oracle->Simulate(world).samples.back().bodies[0].p_WB,
              oracle->Simulate(without).samples.back().bodies[0].p_WB);
  }
}

// The velocity along the rod after the step is what shortens the excess length by ERP a
// step: n·v' = −0.2 (|x| − L)/h.
TEST(OdeWorld, DistanceJointTakesBackAFifthOfItsErrorAStep) {
  for (const auto& oracle : Simulators()) {
    World world;
    world.dt = 1e-2;
    world.steps = 200;
    const double length = 0.9;
    world.bodies = {Ball({0.7, 0, 0.5})};
    world.joints = {{{AnchorKind::kBody, 0, Vector3d::Zero()},
                     {AnchorKind::kWorld, -1, Vector3d(0, 0.1, 0)},
                     length}};
    const Trajectory trajectory = oracle->Simulate(world);
    double longest = 0;
    for (int step = 1; step <= world.steps; ++step) {
      const auto before = static_cast<std::size_t>(step) - 1;
      const Vector3d r =
          trajectory.samples[before].bodies[0].p_WB - world.joints[0].B.point;
      const Vector3d v = trajectory.samples[before + 1].bodies[0].v_WB;
      ASSERT_NEAR(r.normalized().dot(v), -0.2 * (r.norm() - length) / world.dt,
                  kSoftness);
      longest = std::max(longest, r.norm());
    }
    EXPECT_GT(longest, length + 1e-4);  // There was something to take back.
  }
}

TEST(OdeWorld, JointsHoldAtAnchorsOfStaticBodiesEitherWayRound) {
  World world;
  RigidBody post = Ball({0.2, 1, -0.3});
  post.mass = 0;
  post.collides = false;
  world.bodies = {post, Ball({0.7, 1, 0.1})};
  const Anchor on_post{AnchorKind::kBody, 0, Vector3d(0.1, 0, 0)};
  const Anchor on_ball{AnchorKind::kBody, 1, Vector3d(0, 0.1, 0)};
  const double length = (world.bodies[0].placed.X_WB * on_post.point -
                         world.bodies[1].placed.X_WB * on_ball.point)
                            .norm();
  for (const auto& oracle : Simulators()) {
    world.joints = {{on_post, on_ball, length}};
    const BodyState one = oracle->Simulate(world).samples.back().bodies[1];
    world.joints = {{on_ball, on_post, length}};
    const BodyState other = oracle->Simulate(world).samples.back().bodies[1];
    EXPECT_EQ(one.p_WB, other.p_WB);
    const double held = (one.p_WB + one.q_WB * on_ball.point -
                         world.bodies[0].placed.X_WB * on_post.point)
                            .norm();
    // A second after: a swing of 3 m/s moves off its circle by (v h)²/2 L = 1e-4 m a
    // step, of which a fifth is taken back in each.
    EXPECT_NEAR(held, length, 5 * 1e-4);
  }
}

// ODE's default ERP takes a fifth of the overlap in a step; here it stays.
TEST(OdeWorld, PushesOverlapOutOnlyAsShipped) {
  for (const auto& oracle : Simulators()) {
    World world;
    world.bodies = {Ball({0, 0.1 - 1e-3, 0}), BrickOnSlab().bodies[0]};
    world.bodies[0].restitution = 0;
    WorldState state;
    for (const bool as_shipped : {false, true}) {
      const auto simulation =
          as_shipped ? oracle->BeginAsShipped(world) : oracle->Begin(world);
      simulation->Step();
      simulation->Read(state);
      EXPECT_NEAR(state.bodies[0].v_WB.y(), as_shipped ? 0.2e-3 / world.dt : 0, 1e-7);
    }
  }
}

TEST(OdeWorld, QuickStepGivesTheSameAnswerWhateverItDidBefore) {
  const Oracle& quick = *Simulators()[1];
  const World world = BrickOnSlab();
  const WorldState first = quick.Simulate(world).samples.back();
  const WorldState again = quick.Simulate(world).samples.back();
  EXPECT_EQ(first.bodies[1].p_WB, again.bodies[1].p_WB);
  EXPECT_EQ(first.bodies[1].w_WB, again.bodies[1].w_WB);
}

}  // namespace
}  // namespace touchstone
