#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

#include <Eigen/Geometry>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "oracles/mujoco/mujoco_oracles.h"
#include "tests/oracles/simulator_promises.h"

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

// The fraction by which a contact falls short of its target, 1 − mjMAXIMP.
constexpr double kSoftness = 1e-4;

/* Returns `world` with restitution 0, because MuJoCo has none. */
World WithoutRebound(World world) {
  for (RigidBody& body : world.bodies) {
    body.restitution = 0;
  }
  return world;
}

// The tolerance is the rounding of velocities of a few metres per second in every step,
// and of forces with stiffnesses 1e4 times as large.
TEST(MujocoWorld, ContactImpulsesAccountForTheChangeOfMomentum) {
  const World world = WithoutRebound(BrickOnSlab());
  ExpectImpulsesChangeMomentum(Euler(), world, 1e4 * 64 * world.steps * 0x1p-53);
  EXPECT_FALSE(Rk4().Simulate(world).gives_impulses);
}

// Four layers of sixteen cubes close up in the third step. They then have 96 faces of
// four contacts and 72 edges, more than the initial buffer holds. The step is repeated
// from its initial state.
TEST(MujocoWorld, EnlargesTheContactBufferDuringAStep) {
  constexpr int kRow = 4;
  constexpr double kGap = 3e-3;
  World world;
  world.gravity_W.setZero();
  world.dt = 1e-2;
  world.steps = 4;
  const double rate = kGap / (1 + kGap) / (2.5 * world.dt);
  for (int i = 0; i < kRow * kRow * kRow; ++i) {
    RigidBody cube;
    cube.name = fmt::format("cube{}", i);
    cube.placed.shape = Box{{0.5, 0.5, 0.5}};
    const Vector3d in_layer = (1 + kGap) * Vector3d(i % kRow, i / kRow % kRow, 0);
    const int layer = i / (kRow * kRow);
    cube.placed.X_WB.p_WB = in_layer + Vector3d(0, 0, 1.1 * layer);
    cube.v_WB = -rate * in_layer;
    cube.restitution = 0;
    world.bodies.push_back(cube);
  }
  const Trajectory trajectory = Euler().Simulate(world);
  ASSERT_EQ(trajectory.samples.size(), 5U) << trajectory.reason;
  const auto spacing = [&](std::size_t step) {
    const std::vector<BodyState>& bodies = trajectory.samples[step].bodies;
    return (bodies[1].p_WB - bodies[0].p_WB).norm();
  };
  EXPECT_NEAR(spacing(2), 1 + kGap / 5, 1e-12);
  EXPECT_NEAR(spacing(3), 1 - kGap / 5, 1e-12);
  EXPECT_NEAR(spacing(4), 1 - kGap / 5, kGap * kSoftness * 10);
  EXPECT_GE(trajectory.impulses.size(), 96U * 4 + 72 * 2);
}

// m v' = m v − h (k x + b v), x' = x + h v'.
TEST(MujocoWorld, SpringForceIsExplicit) {
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
    // The phase of RK4 lags by (ωh)⁵/120 per step; the error of the amplitude is smaller.
    ASSERT_NEAR(rk4.samples[i].bodies[0].p_WB.dot(direction) - rest_length, truth,
                0.25 * std::pow(omega * world.dt, 5) / 120 * step * 1.5);
  }
}

TEST(MujocoWorld, DistanceJointCorrectsAFifthOfItsErrorPerStep) {
  ExpectJointTakesBackAFifthOfItsError(Euler(), kSoftness, 1e-12);
}

// The tolerance is larger than a rounding because a pendulum amplifies it.
TEST(MujocoWorld, JointsHoldAtAnchorsOfStaticBodiesInEitherOrder) {
  ExpectJointHoldsEitherWayRound(Euler(), 1e-9);
}

// The body sinks by the fraction of gravity that its contact leaves uncorrected per step.
TEST(MujocoWorld, BodyAtRestSinksByTheSoftnessOfItsContact) {
  World world;
  world.dt = 1e-3;
  world.steps = 500;
  world.bodies = {Ball({0, 0.1 - 1e-6, 0}), Slab()};
  world = WithoutRebound(world);
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
  // The body tumbles during the rest of the step; its angular momentum is constant.
  const Vector3d L_W =
      end.q_WB *
      ((end.q_WB.conjugate() * end.w_WB).cwiseProduct(*world.bodies[0].inertia));
  EXPECT_LE((L_W - R * L_B).norm(), 1e-8 * L_B.norm());
  EXPECT_LE((end.w_WB - R * w_B).norm(), 0.1 * w_B.norm());
}

TEST(MujocoWorld, BodiesThatDoNotCollidePassThroughEverything) {
  for (const auto& oracle : Simulators()) {
    ExpectPassesThroughEverything(*oracle);
  }
}

TEST(MujocoWorld, ReportsAWorldThatMujocoResetsAsDiverged) {
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
