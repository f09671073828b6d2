#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "engine/dynamics/world/world.h"

namespace cookbook {
namespace {

constexpr double kH = 1.0 / 240;

void AddFloor(World& world) {
  BodyDefinition floor;
  floor.shape = Box{{20, 1, 20}};
  floor.state.p_WB = {0, -1, 0};
  floor.mass = 0;
  floor.restitution = 0;
  world.AddBody(floor);
}

int AddBox(World& world, const Eigen::Vector3d& p_W, const Eigen::Quaterniond& q_W) {
  BodyDefinition box;
  box.shape = Box{{0.5, 0.5, 0.5}};
  box.state.p_WB = p_W;
  box.state.q_WB = q_W;
  box.restitution = 0;
  return world.AddBody(box);
}

Eigen::Quaterniond AboutY(double angle) {
  return Eigen::Quaterniond(Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitY()));
}

std::map<std::pair<int, int>, int> ContactsOfPairs(const World& world) {
  std::vector<ContactImpulse> impulses;
  world.AppendContactImpulses(impulses);
  std::map<std::pair<int, int>, int> contacts;
  for (const ContactImpulse& impulse : impulses) ++contacts[{impulse.A, impulse.B}];
  return contacts;
}

/** Adds a box on the floor and one on top, rotated by 45°: 4 and 8 contacts. */
void AddRotatedStack(World& world) {
  AddFloor(world);
  AddBox(world, {0, 0.5, 0}, AboutY(0));
  AddBox(world, {0, 1.5, 0}, AboutY(std::numbers::pi / 4));
}

/** Returns the number of contacts between the two boxes of a rotated stack at rest. */
int ContactsOfRotatedStack(bool reduce_manifolds) {
  Settings settings;
  settings.reduce_manifolds = reduce_manifolds;
  World world(settings);
  AddRotatedStack(world);
  for (int k = 0; k < 5; ++k) world.Step(kH);
  return ContactsOfPairs(world)[{1, 2}];
}

TEST(Pile, AFaceKeepsFourContactsUnlessManifoldsAreNotReduced) {
  EXPECT_EQ(ContactsOfRotatedStack(true), 4);
  EXPECT_EQ(ContactsOfRotatedStack(false), 8);
}

// The tiles are thinner than the speculative margin: all eight corners are contacts, and
// the four widest might be the upper ones.
TEST(Pile, TilesLieFlatOnAHalfSpace) {
  World world;
  BodyDefinition ground;
  ground.shape = HalfSpace{};
  ground.state.q_WB = Eigen::AngleAxisd(-std::numbers::pi / 2, Eigen::Vector3d::UnitX());
  ground.mass = 0;
  world.AddBody(ground);
  BodyDefinition tile;
  tile.shape = Box{{0.15, 0.0025, 0.15}};
  tile.restitution = 0;
  for (int k = 0; k < 120; ++k) {
    const int row = k / 12;
    tile.state.p_WB = {0.5 * (k % 12), 0.0025, 0.5 * row};
    tile.state.q_WB = AboutY(0.1 * k);
    world.AddBody(tile);
  }
  for (int k = 0; k < 120; ++k) world.Step(1.0 / 60);
  for (int k = 1; k <= 120; ++k) {
    const BodyState& state = world.state(k);
    EXPECT_GT((state.q_WB * Eigen::Vector3d::UnitY()).y(), 1 - 1e-6) << k;
    EXPECT_NEAR(state.p_WB.y(), 0.0025, 1e-4) << k;
  }
}

double KineticEnergy(const World& world) {
  double energy = 0;
  for (int i = 0; i < world.body_count(); ++i) {
    const BodyState& state = world.state(i);
    energy += 0.5 * state.v_WB.squaredNorm() + 0.5 / 6 * state.w_WB.squaredNorm();
  }
  return energy;
}

// A hundred boxes of 1 kg fall on each other in columns, which rock. With all contacts of
// a face they never came to rest, with thousands of times the kinetic energy.
TEST(Pile, OfAHundredBoxesComesToRest) {
  World world;
  AddFloor(world);
  const auto number_of = [](int k) {  // In [-1, 1), evenly distributed.
    const double x = (6000 + k) * std::numbers::phi;
    return 2 * (x - std::floor(x)) - 1;
  };
  for (int k = 0; k < 100; ++k) {
    const int layer = k / 25;
    const int row = k / 5 % 5;
    const Eigen::Vector3d cell(k % 5 - 2, layer, row - 2);
    const Eigen::Vector3d shift(0.05 * number_of(7 * k), 0.6,
                                0.05 * number_of(7 * k + 1));
    const Eigen::Quaterniond turn(1, 0.05 * number_of(7 * k + 2),
                                  0.05 * number_of(7 * k + 3),
                                  0.05 * number_of(7 * k + 4));
    AddBox(world, 1.31 * cell + shift, turn.normalized());
  }
  for (int k = 0; k < 240; ++k) world.Step(kH);
  ASSERT_GT(ContactsOfPairs(world).size(), 90u);
  for (int k = 0; k < 960; ++k) world.Step(kH);
  EXPECT_LT(KineticEnergy(world), 1e-6);
}

/** Drops sixteen columns of ten boxes of 1 kg and returns the speed of the fastest body
 after ten seconds. [m/s] */
double SpeedOfColumnsAfterTenSeconds(double contact_frequency) {
  Settings settings;
  settings.contact_frequency = contact_frequency;
  World world(settings);
  AddFloor(world);
  const auto number_of = [](int k) {  // In [-1, 1), evenly distributed.
    const double x = (6000 + k) * std::numbers::phi;
    return 2 * (x - std::floor(x)) - 1;
  };
  for (int k = 0; k < 160; ++k) {
    const int column = k / 10;
    const Eigen::Vector3d shift(0.05 * number_of(7 * k), 0.6 + 1.31 * (k % 10),
                                0.05 * number_of(7 * k + 1));
    const Eigen::Quaterniond turn(1, 0.05 * number_of(7 * k + 2),
                                  0.05 * number_of(7 * k + 3),
                                  0.05 * number_of(7 * k + 4));
    AddBox(world, Eigen::Vector3d(4 * (column % 4) - 6, 0, 4 * (column / 4) - 6) + shift,
           turn.normalized());
  }
  for (int k = 0; k < 2400; ++k) world.Step(kH);
  double max = 0;
  for (int i = 1; i < world.body_count(); ++i)
    max = std::max(max, world.state(i).v_WB.norm());
  return max;
}

// A column that rocks as a block of 1 : 10 loses 3 % of its energy in an impact (Housner
// 1963), and what seven iterations leave swings like a spring.
TEST(Pile, ColumnsThatRockComeToRestBecauseContactsYield) {
  EXPECT_LT(SpeedOfColumnsAfterTenSeconds(Settings().contact_frequency), 0.01);
  EXPECT_GT(SpeedOfColumnsAfterTenSeconds(std::numeric_limits<double>::infinity()), 0.05);
}

}  // namespace
}  // namespace cookbook
