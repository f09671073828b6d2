#include <gtest/gtest.h>

#include "engine/dynamics/world/world.h"

namespace cookbook {
namespace {

TEST(FreeMotion, FreeFallIsExactForAnyTimeStep) {
  for (const int steps : {10, 100, 1000}) {
    World world;
    BodyDefinition ball;
    ball.shape = Sphere{0.3};
    ball.state.p_WB = {0.1, 2, -0.7};
    ball.state.v_WB = {3, 5, -1};
    world.AddBody(ball);
    const double t = 1.7;
    for (int k = 0; k < steps; ++k) world.Step(t / steps);

    const Eigen::Vector3d g = world.settings().gravity_W;
    const Eigen::Vector3d p = ball.state.p_WB + t * ball.state.v_WB + 0.5 * t * t * g;
    // Each step has a few rounding errors of the largest coordinate, about 10 m.
    const double tolerance = 4 * steps * 10 * 0x1p-53;
    EXPECT_LT((world.state(0).p_WB - p).norm(), tolerance);
    EXPECT_LT((world.state(0).v_WB - ball.state.v_WB - t * g).norm(), tolerance);
  }
}

}  // namespace
}  // namespace cookbook
