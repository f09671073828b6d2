#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "engine/dynamics/world/world.h"

namespace cookbook {
namespace {

constexpr double kH = 1.0 / 240;
constexpr int kSteps = 240;

/** Returns a number in [-1, 1), evenly distributed over k. */
double NumberOf(int k) {
  const double x = (6000 + k) * std::numbers::phi;
  return 2 * (x - std::floor(x)) - 1;
}

/** Returns where a row of independent boxes on a floor is after a second. `sliding`: the
 boxes start at about 1 m/s and turn, with friction. */
std::vector<Eigen::Vector3d> RowAfterOneSecond(int boxes, bool sliding) {
  World world;
  BodyDefinition floor;
  floor.shape = Box{{4000, 1, 4000}};
  floor.state.p_WB = {0, -1, 0};
  floor.mass = 0;
  world.AddBody(floor);
  for (int k = 0; k < boxes; ++k) {
    BodyDefinition box;
    box.shape = Box{{0.5, 0.5, 0.5}};
    box.restitution = 0;
    box.state.p_WB = {3.0 * k, 0.5, 0};
    if (sliding) {
      box.state.v_WB = {1 + 0.1 * NumberOf(k), 0, 0.5 * NumberOf(k + 1)};
      box.state.w_WB = {0, 0.5 * NumberOf(k + 2), 0};
    }
    world.AddBody(box);
  }
  for (int k = 0; k < kSteps; ++k) world.Step(kH);
  std::vector<Eigen::Vector3d> positions;
  for (int k = 1; k <= boxes; ++k) positions.push_back(world.state(k).p_WB);
  return positions;
}

/** Returns the greatest distance by which one more box elsewhere moves any box, over rows
 in which the iteration budget goes from many iterations to none beyond the first. [m] */
double GreatestJump(bool sliding) {
  double jump = 0;
  std::vector<Eigen::Vector3d> before = RowAfterOneSecond(60, sliding);
  // 4 contacts × 7 iterations × 143 boxes spend the budget of 4000.
  for (int boxes = 61; boxes <= 160; ++boxes) {
    const std::vector<Eigen::Vector3d> now = RowAfterOneSecond(boxes, sliding);
    for (std::size_t k = 0; k < before.size(); ++k)
      jump = std::max(jump, (now[k] - before[k]).norm());
    before = now;
  }
  return jump;
}

// The loads of 7 iterations are exact to a float's rounding of g h in each step.
TEST(NumberOfBodies, OneMoreBoxDoesNotMoveBoxesAtRest) {
  EXPECT_LT(GreatestJump(false), kSteps * 6e-8 * 9.82 * kH * 1.0);
}

// One iteration more or less changes what the solver leaves of the sliding friction. The
// boxes slide by v²/2µg, about 10 cm.
TEST(NumberOfBodies, OneMoreBoxMovesSlidingBoxesByLessThanAHundredthOfTheirWay) {
  EXPECT_LT(GreatestJump(true), 1e-3);
}

// Nothing depends on the others once no budget is left for more iterations.
TEST(NumberOfBodies, BoxesBeyondTheBudgetMoveTheSameInAnyWorld) {
  const std::vector<Eigen::Vector3d> fewer = RowAfterOneSecond(150, true);
  const std::vector<Eigen::Vector3d> more = RowAfterOneSecond(300, true);
  for (std::size_t k = 0; k < fewer.size(); ++k) EXPECT_EQ(fewer[k], more[k]) << k;
}

}  // namespace
}  // namespace cookbook
