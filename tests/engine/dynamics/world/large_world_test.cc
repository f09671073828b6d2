#include <algorithm>
#include <cmath>
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
  world.ReadImpulses(impulses);
  std::map<std::pair<int, int>, int> contacts;
  for (const ContactImpulse& impulse : impulses) ++contacts[{impulse.A, impulse.B}];
  return contacts;
}

/** A box on the floor and one on it that is turned by an eighth: 4 and 8 contacts. */
void AddTurned(World& world) {
  AddFloor(world);
  AddBox(world, {0, 0.5, 0}, AboutY(0));
  AddBox(world, {0, 1.5, 0}, AboutY(std::numbers::pi / 4));
}

/** Settings under which a world of more contacts is large. */
Settings SmallUpTo(int contacts) {
  Settings settings;
  settings.iteration_budget = (settings.impulse_iterations + 1) * contacts;
  return settings;
}

TEST(LargeWorld, ASmallOneKeepsAllContactsOfAFace) {
  World world(SmallUpTo(12));
  AddTurned(world);
  for (int k = 0; k < 5; ++k) {
    world.Step(kH);
    EXPECT_EQ((ContactsOfPairs(world)[{1, 2}]), 8);
  }
}

// With four contacts a face it would be small again; it stays large all the same, else it
// would have all of them in every second step.
TEST(LargeWorld, KeepsFourContactsOfAFaceFromItsSecondStepOn) {
  World world(SmallUpTo(11));
  AddTurned(world);
  world.Step(kH);
  for (int k = 0; k < 5; ++k) {
    world.Step(kH);
    EXPECT_EQ((ContactsOfPairs(world)[{1, 2}]), 4);
    EXPECT_EQ((ContactsOfPairs(world)[{0, 1}]), 4);
  }
}

TEST(LargeWorld, IsSmallAgainWhereTwiceItsContactsAreFew) {
  World world(SmallUpTo(11));
  AddTurned(world);
  for (int k = 0; k < 3; ++k) world.Step(kH);
  ASSERT_EQ((ContactsOfPairs(world)[{1, 2}]), 4);
  world.ApplyImpulse(2, world.state(2).p_WB, {0, 3, 0});
  for (int k = 0; k < 3; ++k) world.Step(kH);
  ASSERT_EQ((ContactsOfPairs(world)[{1, 2}]), 0);
  // It comes down on a small world, in a step that sees all its contacts.
  for (int k = 0; k < 200 && ContactsOfPairs(world)[{1, 2}] == 0; ++k) world.Step(kH);
  EXPECT_GT((ContactsOfPairs(world)[{1, 2}]), 4);
}

// Thinner than the margin: all eight corners of a tile are contacts, and the four widest
// might be those above.
TEST(LargeWorld, TilesLieFlatOnAHalfSpace) {
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

double EnergyOfMotion(const World& world) {
  double energy = 0;
  for (int i = 0; i < world.body_count(); ++i) {
    const BodyState& state = world.state(i);
    energy += 0.5 * state.v_WB.squaredNorm() + 0.5 / 6 * state.w_WB.squaredNorm();
  }
  return energy;
}

// A hundred boxes of 1 kg that fall upon each other in columns, and these rock. With all
// the contacts of a face they rocked on for ever, by thousands of times as much.
TEST(LargeWorld, APileOfBoxesComesToRest) {
  World world;
  AddFloor(world);
  const auto share = [](int k) {  // In [-1, 1), evenly.
    const double x = (6000 + k) * std::numbers::phi;
    return 2 * (x - std::floor(x)) - 1;
  };
  for (int k = 0; k < 100; ++k) {
    const int layer = k / 25;
    const int row = k / 5 % 5;
    const Eigen::Vector3d cell(k % 5 - 2, layer, row - 2);
    const Eigen::Vector3d shift(0.05 * share(7 * k), 0.6, 0.05 * share(7 * k + 1));
    const Eigen::Quaterniond turn(1, 0.05 * share(7 * k + 2), 0.05 * share(7 * k + 3),
                                  0.05 * share(7 * k + 4));
    AddBox(world, 1.31 * cell + shift, turn.normalized());
  }
  for (int k = 0; k < 240; ++k) world.Step(kH);
  ASSERT_GT(ContactsOfPairs(world).size(), 90u);
  for (int k = 0; k < 960; ++k) world.Step(kH);
  EXPECT_LT(EnergyOfMotion(world), 1e-6);
}

}  // namespace
}  // namespace cookbook
