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

/** Gravity as on a slope down which x leads. */
Eigen::Vector3d GravityOnSlope(double angle) {
  return 9.81 * Eigen::Vector3d(std::sin(angle), -std::cos(angle), 0);
}

/** How fast a plate creeps after three steps on a slope that its friction just holds,
 among so many others that slide. [m/s] */
double CreepOfAPlateAmong(int others) {
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

// At the threshold every contact slides or nearly does, which sweeps find slowest: what
// others would have used up is there for the one that needs it.
TEST(Sliding, HowWellAPlateIsHeldDoesNotDependOnHowManyOthersSlide) {
  const double alone = CreepOfAPlateAmong(0);
  EXPECT_GT(alone, 0);
  EXPECT_LT(CreepOfAPlateAmong(30), 2 * alone);
}

// The block, or its mirror image in the plane of x and y.
BodyState ABlockThatSpinsDownASlope(double handed) {
  Settings settings;
  settings.gravity_W = GravityOnSlope(std::numbers::pi / 9);
  World world(settings);
  world.AddBody(Ground(0.6));
  BodyDefinition block;
  block.shape = Box{{0.5, 0.25, 0.5}};
  block.restitution = 0;
  block.friction = 0.3;
  block.state.p_WB = {0, 0.25, 0};
  block.state.w_WB = {0, handed * 25, 0};
  const int body = world.AddBody(block);
  for (int k = 0; k < 480; ++k) world.Step(1.0 / 240);
  return world.state(body);
}

// Four contacts carry the block in many ways, and its friction hangs on which: there is
// one that a mirror does not change.
TEST(Sliding, ABlockThatSpinsSlidesAsItsMirrorImageDoes) {
  const BodyState block = ABlockThatSpinsDownASlope(1);
  const BodyState image = ABlockThatSpinsDownASlope(-1);
  EXPECT_GT(block.p_WB.x(), 4);
  // A step's share of an order remains: 2 ‰ of the way that the block drifts aside.
  const Eigen::Vector3d mirrored(image.p_WB.x(), image.p_WB.y(), -image.p_WB.z());
  EXPECT_LT((block.p_WB - mirrored).norm(), 1e-3);
}

}  // namespace
}  // namespace cookbook
