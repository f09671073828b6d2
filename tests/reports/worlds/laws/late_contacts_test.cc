#include "reports/worlds/law_support/late_contacts.h"

#include <gtest/gtest.h>

#include "tests/reports/worlds/motions.h"

namespace touchstone {
namespace {

/** Returns the lateness of a ball of radius 0.5 m at `height` [m] above the ground, with
 velocity `v_WB` [m/s]. */
double LatenessAt(double height, const Eigen::Vector3d& v_WB, int balls = 1) {
  World world;
  world.gravity_W = {0, -10, 0};
  world.dt = 0.01;
  world.bodies = {GroundOf()};
  for (int i = 0; i < balls; ++i) {
    world.bodies.push_back(BodyOf("ball", Sphere{0.5}, 2, {3.0 * i, 0.5 + height, 0}));
    world.bodies.back().v_WB = v_WB;
  }
  return LatenessOfFlushContacts(world, 1e-13);
}

TEST(LatenessOfFlushContacts, IsOneStepOfFallForEachBodyThatIsFlush) {
  // 1.5 × 2 g h² for each.
  EXPECT_NEAR(LatenessAt(0, {0, 0, 0}), 1.5 * 2 * 10 * 1e-4, 1e-15);
  EXPECT_NEAR(LatenessAt(0, {0, 0, 0}, 3), 3 * 1.5 * 2 * 10 * 1e-4, 1e-15);
}

TEST(LatenessOfFlushContacts, IsAStepOfTheApproachThatTheWorldStates) {
  EXPECT_NEAR(LatenessAt(0, {7, -2, 0}), 1.5 * (2 * 0.01 + 2 * 10 * 1e-4), 1e-15);
}

TEST(LatenessOfFlushContacts, IsNothingIfRoundingDecidesNoContact) {
  EXPECT_EQ(LatenessAt(1e-3, {0, 0, 0}), 0);
  EXPECT_EQ(LatenessAt(-1e-3, {0, 0, 0}), 0);
  EXPECT_EQ(LatenessAt(1e-9, {0, 0, 0}), 0);
}

}  // namespace
}  // namespace touchstone
