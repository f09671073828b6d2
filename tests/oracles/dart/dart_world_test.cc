#include <memory>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "oracles/dart/dart_oracles.h"
#include "tests/oracles/simulator_promises.h"

namespace touchstone {
namespace {

using Eigen::Vector3d;

const Oracle& Dart() {
  static const std::vector<std::unique_ptr<Oracle>> oracles = DartOracles();
  return *oracles.front();
}

// The tolerance is the rounding of velocities of a few metres per second in every step.
// DART transforms them between the frames of the world, the body and the joint.
TEST(DartWorld, ContactImpulsesAccountForTheChangeOfMomentum) {
  const World world = BrickOnSlab();
  ExpectImpulsesChangeMomentum(Dart(), world, 8 * 64 * world.steps * 0x1p-53);
}

// Δv = J/m, R_WBᵀ Δw = I⁻¹ (r × R_WBᵀ J)
TEST(DartWorld, PushActsAtItsPoint) {
  World world = BrickOnSlab();
  world.gravity_W.setZero();
  world.bodies = {world.bodies[1]};
  RigidBody& brick = world.bodies[0];
  brick.force_W.setZero();
  brick.v_WB.setZero();
  brick.w_WB.setZero();
  const Vector3d p_BoP(0.1, -0.05, 0.02);
  const Vector3d J_W(0.3, 0.4, -0.1);
  const std::unique_ptr<Simulation> simulation = Dart().Begin(world);
  simulation->Push(0, brick.placed.X_WB * p_BoP, J_W);
  WorldState state;
  simulation->Read(state);
  EXPECT_LE((state.bodies[0].v_WB - J_W / brick.mass).norm(), 1e-15);
  const Eigen::Matrix3d& R_WB = brick.placed.X_WB.R_WB;
  const Vector3d w_B =
      p_BoP.cross(R_WB.transpose() * J_W).cwiseQuotient(InertiaOf(brick));
  EXPECT_LE((R_WB.transpose() * state.bodies[0].w_WB - w_B).norm(), 1e-14 * w_B.norm());
}

TEST(DartWorld, BodiesThatDoNotCollidePassThroughEverything) {
  ExpectPassesThroughEverything(Dart());
}

TEST(DartWorld, DoesNotSupportRestitutionsThatItCannotCombine) {
  World world = BrickOnSlab();
  world.bodies.push_back(world.bodies[1]);
  world.bodies[2].name = "other";
  world.bodies[2].restitution = 0.1;
  const Trajectory trajectory = Dart().Simulate(world);
  EXPECT_EQ(trajectory.status, AnswerStatus::kUnsupported);
  EXPECT_NE(trajectory.reason.find("multiplies"), std::string::npos);
}

// DART's default removes a hundredth of the overlap in a step, up to 1 mm/s; the adapter
// keeps it.
TEST(DartWorld, PushesOverlapOutOnlyAsShipped) {
  ExpectPushesOverlapOutOnlyAsShipped(Dart(), 1e-3, 1e-5);
}

}  // namespace
}  // namespace touchstone
