#include "scenarios/generators/ensemble.h"

#include <gtest/gtest.h>

namespace touchstone {
namespace {

WorldScenario BallOnFloor() {
  WorldScenario scenario;
  scenario.world.bodies.resize(2);
  scenario.world.bodies[0].name = "floor";
  scenario.world.bodies[0].placed.shape = Box{{9, 1, 9}};
  scenario.world.bodies[0].mass = 0;
  scenario.world.bodies[1].name = "ball";
  scenario.world.bodies[1].placed.shape = Sphere{0.5};
  scenario.world.bodies[1].placed.X_WB.p_WB = {0.1, 2, 0.3};
  scenario.ensemble = Ensemble{4, 1e-3, 7};
  return scenario;
}

Eigen::Vector3d ShiftOf(const WorldScenario& scenario, int member, std::size_t body) {
  return MemberOf(scenario, member).bodies[body].placed.X_WB.p_WB -
         scenario.world.bodies[body].placed.X_WB.p_WB;
}

TEST(MemberOfEnsemble, IsTheWorldItselfAtIndexZero) {
  EXPECT_TRUE(ShiftOf(BallOnFloor(), 0, 1).isZero(0));
}

TEST(MemberOfEnsemble, DisplacesMovingBodiesByAtMostTheJitter) {
  const WorldScenario scenario = BallOnFloor();
  constexpr double kRounding = 1e-15;  // Rounding of coordinates up to 2. [m]
  for (int member = 1; member < scenario.ensemble->members; ++member) {
    EXPECT_TRUE(ShiftOf(scenario, member, 0).isZero(0));
    const Eigen::Vector3d shift = ShiftOf(scenario, member, 1);
    EXPECT_GT(shift.cwiseAbs().minCoeff(), 0);
    EXPECT_LE(shift.cwiseAbs().maxCoeff(), scenario.ensemble->jitter + kRounding);
  }
}

TEST(MemberOfEnsemble, DiffersForEveryIndexAndSeed) {
  WorldScenario scenario = BallOnFloor();
  const Eigen::Vector3d first = ShiftOf(scenario, 1, 1);
  EXPECT_EQ(ShiftOf(scenario, 1, 1), first);
  EXPECT_NE(ShiftOf(scenario, 2, 1), first);
  scenario.ensemble->seed = 8;
  EXPECT_NE(ShiftOf(scenario, 1, 1), first);
}

}  // namespace
}  // namespace touchstone
