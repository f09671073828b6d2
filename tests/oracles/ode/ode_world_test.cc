#include <cstddef>
#include <memory>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "oracles/ode/ode_oracles.h"
#include "tests/oracles/simulator_promises.h"

namespace touchstone {
namespace {

using Eigen::Vector3d;

/* "ode" and "ode/quick". */
const std::vector<std::unique_ptr<Oracle>>& Simulators() {
  static const std::vector<std::unique_ptr<Oracle>> oracles = OdeOracles();
  return oracles;
}

// A rod yields by its CFM, 1e-12 m/s per newton. The force is at most 100 N here: in its
// first step the rod brings 1.3 kg to 0.7 m/s in 0.01 s.
constexpr double kSoftness = 1e-10;  // [m/s]

// The tolerance is the rounding of velocities of a few metres per second in every step.
TEST(OdeWorld, ContactImpulsesAccountForTheChangeOfMomentum) {
  const World world = BrickOnSlab();
  for (const auto& oracle : Simulators()) {
    ExpectImpulsesChangeMomentum(*oracle, world, 64 * world.steps * 0x1p-53);
  }
}

// m v' = m v − h (k (x + h v') + b v'), x' = x + h v'. ODE's manual derives ERP and CFM
// from this implicit step.
TEST(OdeWorld, SpringForceIsImplicit) {
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
      // QuickStep's over-relaxation (w = 1.3) of one constraint leaves 0.3^200 of its
      // error.
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

TEST(OdeWorld, DistanceJointCorrectsAFifthOfItsErrorPerStep) {
  for (const auto& oracle : Simulators()) {
    ExpectJointTakesBackAFifthOfItsError(*oracle, 0, kSoftness);
  }
}

TEST(OdeWorld, JointsHoldAtAnchorsOfStaticBodiesInEitherOrder) {
  for (const auto& oracle : Simulators()) {
    ExpectJointHoldsEitherWayRound(*oracle, 0);
  }
}

// ODE's default ERP removes a fifth of the overlap in a step; the adapter keeps it.
TEST(OdeWorld, PushesOverlapOutOnlyAsShipped) {
  for (const auto& oracle : Simulators()) {
    ExpectPushesOverlapOutOnlyAsShipped(*oracle, 0.2e-3 / World().dt, 1e-7);
  }
}

TEST(OdeWorld, QuickStepAnswersDoNotDependOnEarlierSimulations) {
  const Oracle& quick = *Simulators()[1];
  const World world = BrickOnSlab();
  const WorldState first = quick.Simulate(world).samples.back();
  const WorldState again = quick.Simulate(world).samples.back();
  EXPECT_EQ(first.bodies[1].p_WB, again.bodies[1].p_WB);
  EXPECT_EQ(first.bodies[1].w_WB, again.bodies[1].w_WB);
}

}  // namespace
}  // namespace touchstone
