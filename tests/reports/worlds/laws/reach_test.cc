#include "reports/worlds/law_support/reach.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/reports/worlds/motions.h"

namespace touchstone {
namespace {

/** A ball that moves along x from 0 to 4 m, a ball beside its way at x = 2 m, one at rest
 far away, and level ground under them. */
struct Passing {
  explicit Passing(double beside) {
    world.bodies = {BodyOf("moving", Sphere{0.2}, 1, {0, 1, 0}),
                    BodyOf("beside", Box{{0.2, 0.2, 0.2}}, 1, {2, 1, beside}),
                    BodyOf("far", Sphere{0.2}, 1, {2, 9, 0}), GroundOf()};
    world.dt = 0.1;
    world.steps = 40;
    motion = Stepped(world, [](WorldState& state) { state.bodies[0].p_WB.x() += 0.1; });
  }

  World world;
  Trajectory motion;
};

TEST(Reach, TellsWhenBoundingSpheresMeet) {
  const Passing passing(0.5);
  const Reach reach({passing.world, DoubleEngine(), passing.motion});
  EXPECT_TRUE(reach.MayEverTouch(0, 1));
  EXPECT_FALSE(reach.MayTouch(0, 0, 1));
  EXPECT_TRUE(reach.MayTouch(20, 0, 1));
  EXPECT_FALSE(reach.MayTouch(40, 0, 1));
  EXPECT_FALSE(reach.MayEverTouch(0, 2));
}

TEST(Reach, SpheresThatJustTouchMayTouch) {
  const Passing passing(0.2 + 0.2 * std::sqrt(3));
  const Reach reach({passing.world, DoubleEngine(), passing.motion});
  EXPECT_TRUE(reach.MayTouch(20, 0, 1));
  const Passing beyond(0.2 + 0.2 * std::sqrt(3) + 1e-6);
  EXPECT_FALSE(Reach({beyond.world, DoubleEngine(), beyond.motion}).MayTouch(20, 0, 1));
}

TEST(Reach, AHalfSpaceReachesWhatIsAsLow) {
  Passing passing(0.5);
  EXPECT_FALSE(Reach({passing.world, DoubleEngine(), passing.motion}).MayEverTouch(0, 3));
  passing.motion.samples[7].bodies[0].p_WB.y() = 0.2;
  const Reach reach({passing.world, DoubleEngine(), passing.motion});
  EXPECT_TRUE(reach.MayEverTouch(0, 3));
  EXPECT_TRUE(reach.MayTouch(7, 3, 0));
  EXPECT_FALSE(reach.MayTouch(8, 0, 3));
}

}  // namespace
}  // namespace touchstone
