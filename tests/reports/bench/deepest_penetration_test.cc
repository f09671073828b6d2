#include "reports/bench/deepest_penetration.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "reports/worlds/truth/mechanics.h"
#include "tests/reports/worlds/motions.h"

namespace touchstone {
namespace {

World ThreeBalls() {
  World world;
  world.bodies = {BodyOf("a", Sphere{0.5}, 1, {0, 0, 0}),
                  BodyOf("b", Sphere{0.5}, 1, {0.9, 0, 0}),
                  BodyOf("c", Sphere{0.5}, 1, {4, 0, 0})};
  return world;
}

TEST(DeepestPenetration, IsThatOfThePairThatOverlapsMost) {
  const World world = ThreeBalls();
  const Penetration deepest = DeepestPenetration(world, StateAtStart(world));
  EXPECT_NEAR(deepest.depth, 0.1, 1e-9);
  EXPECT_EQ(deepest.A, 0);
  EXPECT_EQ(deepest.B, 1);
}

TEST(DeepestPenetration, IsNanForABodyWithoutAFinitePose) {
  const World world = ThreeBalls();
  WorldState state = StateAtStart(world);
  state.bodies[2].p_WB.y() = std::numeric_limits<double>::quiet_NaN();
  const Penetration deepest = DeepestPenetration(world, state);
  EXPECT_TRUE(std::isnan(deepest.depth));
  EXPECT_EQ(deepest.A, 2);
}

}  // namespace
}  // namespace touchstone
