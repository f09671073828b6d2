#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "engine/dynamics/world/world.h"

namespace cookbook {
namespace {

BodyDefinition Ground(double friction) {
  BodyDefinition ground;
  ground.shape = Box{{40, 1, 40}};
  ground.state.p_WB = {0, -1, 0};
  ground.mass = 0;
  ground.restitution = 0;
  ground.friction = friction;
  return ground;
}

/** Returns gravity in the frame of a slope; x points down the slope. [m/s²] */
Eigen::Vector3d GravityOnSlope(double angle) {
  return 9.81 * Eigen::Vector3d(std::sin(angle), -std::cos(angle), 0);
}

/** Returns the creep speed after three steps of a plate on a slope at the threshold of
 its friction, next to `others` plates that slide. [m/s] */
double CreepSpeedOfPlate(int others) {
  Settings settings;
  settings.gravity_W = GravityOnSlope(std::numbers::pi / 4);
  World world(settings);
  world.AddBody(Ground(1));
  BodyDefinition plate;
  plate.shape = Box{{0.4, 0.1, 0.3}};
  plate.restitution = 0;
  plate.state.p_WB = {0, 0.1, 0};
  plate.friction = 1;
  const int held = world.AddBody(plate);
  for (int i = 0; i < others; ++i) {
    plate.state.p_WB.z() += 1;
    plate.friction = 0.1;
    world.AddBody(plate);
  }
  for (int k = 0; k < 3; ++k) world.Step(1.0 / 240);
  return world.state(held).v_WB.norm();
}

// Iterations converge slowest at the threshold, where every contact slides or nearly
// does. Islands that have converged must leave the iteration budget to the others.
TEST(Sliding, CreepOfAPlateDoesNotDependOnTheNumberOfOtherPlates) {
  const double alone = CreepSpeedOfPlate(0);
  EXPECT_GT(alone, 0);
  // A plate that rests keeps a rounding of the speed that gravity adds in a step.
  const double rounding = 0x1p-53 * 9.81 / 240;
  EXPECT_LT(CreepSpeedOfPlate(30), 2 * std::max(alone, rounding));
}

/** Returns the final state of a block that spins while it slides down a slope.
 `spin_sign` −1: the mirror image in the plane of x and y. */
BodyState SpinningBlockOnSlope(double spin_sign) {
  Settings settings;
  settings.gravity_W = GravityOnSlope(std::numbers::pi / 9);
  World world(settings);
  world.AddBody(Ground(0.6));
  BodyDefinition block;
  block.shape = Box{{0.5, 0.25, 0.5}};
  block.restitution = 0;
  block.friction = 0.3;
  block.state.p_WB = {0, 0.25, 0};
  block.state.w_WB = {0, spin_sign * 25, 0};
  const int body = world.AddBody(block);
  for (int k = 0; k < 480; ++k) world.Step(1.0 / 240);
  return world.state(body);
}

// The load of four contacts is statically indeterminate, and the friction depends on its
// distribution. The linear distribution is symmetric.
TEST(Sliding, ASpinningBlockSlidesLikeItsMirrorImage) {
  const BodyState block = SpinningBlockOnSlope(1);
  const BodyState image = SpinningBlockOnSlope(-1);
  EXPECT_GT(block.p_WB.x(), 4);
  // The effect of the order of contacts in a step remains: 2 ‰ of the sideways drift.
  const Eigen::Vector3d mirrored(image.p_WB.x(), image.p_WB.y(), -image.p_WB.z());
  EXPECT_LT((block.p_WB - mirrored).norm(), 1e-3);
}

}  // namespace
}  // namespace cookbook
