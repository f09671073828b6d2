#include "reports/bench/world_quality.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "reports/worlds/truth/mechanics.h"
#include "tests/reports/bench/planted_simulator.h"

namespace touchstone {
namespace {

TEST(QualityOf, HasTheLargestSpeedAndHorizontalDisplacementOfABodyThatCanMove) {
  const World world = TwoBalls();
  WorldState state = StateAtStart(world);
  state.bodies[0].v_WB = {100, 0, 0};  // Static.
  state.bodies[1].v_WB = {0, -3, 4};
  state.bodies[1].p_WB += Eigen::Vector3d(6, 100, 8);
  const WorldQuality quality = QualityOf(world, state);
  EXPECT_EQ(quality.fastest, 5);
  EXPECT_EQ(quality.sideways, 10);
  EXPECT_EQ(quality.deepest, 0);
}

TEST(QualityOf, IsNanForABodyWithoutAFiniteState) {
  const World world = TwoBalls();
  WorldState state = StateAtStart(world);
  state.bodies[1].v_WB.x() = std::numeric_limits<double>::quiet_NaN();
  state.bodies[1].p_WB.x() = std::numeric_limits<double>::quiet_NaN();
  const WorldQuality quality = QualityOf(world, state);
  EXPECT_TRUE(std::isnan(quality.fastest));
  EXPECT_TRUE(std::isnan(quality.sideways));
  EXPECT_TRUE(std::isnan(quality.deepest));
}

}  // namespace
}  // namespace touchstone
