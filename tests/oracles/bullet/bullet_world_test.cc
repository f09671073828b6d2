#include <array>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "oracles/bullet/bullet_oracles.h"
#include "tests/oracles/simulator_promises.h"

namespace touchstone {
namespace {

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

// The tolerance is the rounding of velocities of a few metres per second in every step.
TEST(BulletWorld, ContactImpulsesAccountForTheChangeOfMomentum) {
  const World world = BrickOnSlab();
  for (const Oracle* oracle : Simulators()) {
    ExpectImpulsesChangeMomentum(*oracle, world,
                                 64 * world.steps * oracle->info().unit_roundoff);
  }
}

TEST(BulletWorld, BodiesThatDoNotCollidePassThroughEverything) {
  for (const Oracle* oracle : Simulators()) {
    ExpectPassesThroughEverything(*oracle);
  }
}

// Bullet's default ERP removes a fifth of a slight overlap in a step; the adapter keeps
// it.
TEST(BulletWorld, PushesOverlapOutOnlyAsShipped) {
  for (const Oracle* oracle : Simulators()) {
    ExpectPushesOverlapOutOnlyAsShipped(*oracle, 0.2e-3 / World().dt, 1e-5);
  }
}

TEST(BulletWorld, ClosestPointsDoNotSimulate) {
  const std::vector<std::unique_ptr<Oracle>> oracles =
      BulletOracles(BulletPrecision::kDouble);
  EXPECT_EQ(oracles[1]->Begin(BrickOnSlab()), nullptr);
  EXPECT_EQ(oracles[1]->Simulate(BrickOnSlab()).status, AnswerStatus::kUnsupported);
}

TEST(BulletWorld, StatesWhyItHasNoSprings) {
  for (const Oracle* oracle : Simulators()) {
    World world = BrickOnSlab();
    world.springs.emplace_back();
    const Trajectory trajectory = oracle->Simulate(world);
    EXPECT_EQ(trajectory.status, AnswerStatus::kUnsupported);
    EXPECT_EQ(trajectory.reason,
              "Bullet has springs along the axes of a body but none between two points");
  }
}

}  // namespace
}  // namespace touchstone
