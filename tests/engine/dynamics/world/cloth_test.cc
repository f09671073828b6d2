#include "engine/dynamics/world/cloth.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace cookbook {
namespace {

Cloth Sheet() {
  Cloth cloth;
  cloth.n = 5;
  cloth.spacing = 0.25;
  cloth.centre_W = {1.3, 2, -0.7};
  cloth.node_mass = 0.1;
  cloth.structural = {80, 0};
  cloth.shear = {40, 0};
  cloth.bend = {20, 0};
  return cloth;
}

TEST(Cloth, FallsRigidlyWithoutSupports) {
  World world;
  const int first = AddCloth(Sheet(), world);
  const double h = 1.0 / 240;
  for (int k = 0; k < 240; ++k) world.Step(h);
  for (int row = 0; row < 5; ++row) {
    for (int column = 0; column < 5; ++column) {
      const Eigen::Vector3d p(1.3 + 0.25 * (column - 2), 2 - 0.5 * 9.82,
                              -0.7 + 0.25 * (row - 2));
      const Eigen::Vector3d& at = world.state(first + 5 * row + column).p_WB;
      EXPECT_LT((at - p).norm(), 1e-12) << row << " " << column;
    }
  }
}

TEST(Cloth, HangsFromTwoCornersThatCarryItsWeight) {
  World world;
  Cloth cloth = Sheet();
  cloth.drag = 3;
  cloth.structural.damping = 0.2;
  cloth.pinned = {{0, 0}, {0, 4}};
  const int first = AddCloth(cloth, world);
  for (int k = 0; k < 2400; ++k) world.Step(1.0 / 100);
  // At rest, the springs at the two corners carry the weight of the other 23 nodes.
  Eigen::Vector3d total_force(0, 0, 0);
  const auto add_force = [&](int corner, int other, double k, double rest) {
    const Eigen::Vector3d d =
        world.state(first + other).p_WB - world.state(first + corner).p_WB;
    total_force += k * (d.norm() - rest) * d.normalized();
  };
  add_force(0, 1, 80, 0.25);
  add_force(0, 5, 80, 0.25);
  add_force(0, 6, 40, 0.25 * std::sqrt(2.0));
  add_force(0, 2, 20, 0.5);
  add_force(0, 10, 20, 0.5);
  add_force(4, 3, 80, 0.25);
  add_force(4, 9, 80, 0.25);
  add_force(4, 8, 40, 0.25 * std::sqrt(2.0));
  add_force(4, 2, 20, 0.5);
  add_force(4, 14, 20, 0.5);
  const double weight = 23 * 0.1 * 9.82;
  EXPECT_NEAR(total_force[1], -weight, 1e-6 * weight);
  EXPECT_NEAR(total_force[0], 0, 1e-6 * weight);
  // Left and right are mirror images.
  for (int row = 0; row < 5; ++row) {
    const Eigen::Vector3d left = world.state(first + 5 * row).p_WB;
    const Eigen::Vector3d right = world.state(first + 5 * row + 4).p_WB;
    EXPECT_NEAR(left[0] - 1.3, 1.3 - right[0], 1e-9);
    EXPECT_NEAR(left[1], right[1], 1e-9);
  }
  EXPECT_EQ(world.state(first).p_WB, Eigen::Vector3d(0.8, 2, -1.2));
}

TEST(Cloth, RefusesInvalidClothsAndLeavesTheWorldUnchanged) {
  const auto refused = [](auto change) {
    Cloth cloth = Sheet();
    change(cloth);
    World world;
    EXPECT_THROW(AddCloth(cloth, world), std::invalid_argument);
    EXPECT_EQ(world.body_count(), 0);
  };
  refused([](Cloth& c) { c.n = 2; });
  refused([](Cloth& c) { c.spacing = 0; });
  refused([](Cloth& c) { c.node_mass = 0; });
  refused([](Cloth& c) { c.drag = -1; });
  refused([](Cloth& c) { c.bounce = 1.5; });
  refused([](Cloth& c) { c.shear.stiffness = -1; });
  refused([](Cloth& c) { c.bend.damping = std::nan(""); });
  refused([](Cloth& c) { c.pinned = {{0, 5}}; });
}

}  // namespace
}  // namespace cookbook
