#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "engine/collision/collide.h"
#include "engine/dynamics/world/world.h"
#include "tests/engine/random_boxes.h"

namespace cookbook::test {
namespace {

/** Returns the depth of two boxes; negative if they are apart. [m] */
double DepthOf(const Box& A, const BodyState& a, const Box& B, const BodyState& b) {
  const auto pose = [](const BodyState& state) {
    return Pose{state.q_WB.toRotationMatrix(), state.p_WB};
  };
  return -Collide(A, pose(a), B, pose(b)).separation;
}

/** Returns the greatest depth of two bars that lie on each other and spin, without
 gravity, friction and restitution, in a fifth of a second. [m] */
double DeepestOf(const Box& bar, const Eigen::Vector3d& w_A, const Eigen::Vector3d& w_B,
                 double h, Stabilisation stabilisation) {
  Settings settings;
  settings.stabilisation = stabilisation;
  settings.gravity_W.setZero();
  World world(settings);
  for (const bool is_upper : {false, true}) {
    BodyDefinition body;
    body.shape = bar;
    body.restitution = 0;
    body.friction = 0;
    body.state.p_WB = {0, 0, is_upper ? 2 * bar.half_extents.z() : 0};
    body.state.v_WB = {0, 0, is_upper ? -0.5 : 0.5};
    body.state.w_WB = is_upper ? w_B : w_A;
    world.AddBody(body);
  }
  double deepest = 0;
  for (int step = 0; step * h < 0.2; ++step) {
    world.Step(h);
    deepest = std::max(deepest, DepthOf(bar, world.state(0), bar, world.state(1)));
  }
  return deepest;
}

/** Returns the greatest depth of 300 pairs of bars, in multiples of ω² r h². */
double WorstWith(Stabilisation stabilisation) {
  const Box bar{{0.4, 0.05, 0.05}};
  const double h = 1.0 / 144;
  const double turn = 14 * 14 * 0.4 * h * h;  // [m]
  Random random(5);
  double worst = 0;
  for (int n = 0; n < 300; ++n) {
    const Eigen::Vector3d w_A = 14 * random.Direction();
    const Eigen::Vector3d w_B = 14 * random.Direction();
    worst = std::max(worst, DeepestOf(bar, w_A, w_B, h, stabilisation) / turn);
  }
  return worst;
}

// In a step two bodies turn into each other by up to ω² r h², and have an impact in each.
// Position correction removes a fifth of the depth in a step, so that it is at most a few
// times as much.
TEST(SpinningBars, DoNotSinkIntoEachOtherStepByStep) {
  EXPECT_LE(WorstWith(Stabilisation::kSplitImpulse), 2);
}

TEST(SpinningBars, SinkInWithoutStabilisation) {
  EXPECT_GE(WorstWith(Stabilisation::kNone), 3);
}

}  // namespace
}  // namespace cookbook::test
