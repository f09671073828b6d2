#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "engine/dynamics/world/world.h"
#include "tests/engine/dynamics/random.h"

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

// The tiles are thinner than the speculative margin. If all eight corners were contacts,
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

/** State of sixteen columns of boxes ten seconds after they were dropped. */
struct ColumnsAtEnd {
  double fastest = 0;  ///< Speed of the fastest box. [m/s]
  double deepest = 0;  ///< Depth of the deepest contact. [m]
};

/** Drops sixteen columns of `height` boxes of 1 kg each, placed like the boxes of
 `touchstone bench worlds`. */
ColumnsAtEnd DropColumns(int height, const Settings& settings) {
  World world(settings);
  AddFloor(world);
  Random random(1);
  for (int k = 0; k < 16 * height; ++k) {
    const int column = k / height;
    const int row = column / 4;
    const double x = 4 * (column % 4) - 6 + random.Uniform(-0.05, 0.05);
    const double z = 4 * row - 6 + random.Uniform(-0.05, 0.05);
    Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();
    for (int axis = 0; axis < 3; ++axis) turn.vec()[axis] = random.Uniform(-0.05, 0.05);
    AddBox(world, {x, 0.6 + 1.31 * (k % height), z}, turn.normalized());
  }
  for (int k = 0; k < 2400; ++k) world.Step(kH);
  ColumnsAtEnd end;
  for (int i = 1; i < world.body_count(); ++i)
    end.fastest = std::max(end.fastest, world.state(i).v_WB.norm());
  std::vector<ContactImpulse> impulses;
  world.AppendContactImpulses(impulses);
  for (const ContactImpulse& contact : impulses)
    end.deepest = std::max(end.deepest, -contact.separation);
  return end;
}

// A column that rocks as a block of 1 : 10 loses 3 % of its energy in an impact (Housner
// 1963), and what a few iterations leave swings like a spring.
TEST(Pile, ColumnsThatRockComeToRestBecauseContactsYield) {
  EXPECT_LT(DropColumns(10, Settings()).fastest, 0.01);
  Settings rigid;
  rigid.contact_frequency = std::numeric_limits<double>::infinity();
  EXPECT_GT(DropColumns(10, rigid).fastest, 0.05);
}

// Columns as in a pile of 10,000 boxes. If position correction lifts the springs of the
// contacts, it gives back in each swing what their dampers have taken.
TEST(Pile, ColumnsOfTwentyOneBoxesComeToRest) {
  EXPECT_LT(DropColumns(21, Settings()).fastest, 0.01);
}

// The mean load of the ball's contact is a thousandth of the load that it gets. It sags
// by a hundredth of the radius at most while the mean load follows.
TEST(Pile, ABallDoesNotSinkInUnderABoxAThousandTimesHeavier) {
  Settings settings;
  settings.gravity_W = {0, -9.81, 0};
  World world(settings);
  AddFloor(world);
  BodyDefinition ball;
  ball.shape = Sphere{0.05};
  ball.mass = 1;
  ball.restitution = 0;
  ball.state.p_WB.y() = 0.05;
  const int light = world.AddBody(ball);
  BodyDefinition box;
  box.shape = Box{{1, 0.5, 1}};
  box.mass = 1000;
  box.restitution = 0;
  box.state.p_WB.y() = 1.6;
  world.AddBody(box);
  const auto height_after = [&](double seconds) {
    for (int k = 0; k < seconds * 120; ++k) world.Step(1.0 / 120);
    return world.state(light).p_WB.y();
  };
  const double landed = height_after(0.6);  // It falls for 0.45 s.
  EXPECT_GT(landed, 0.045);
  EXPECT_GE(height_after(3), landed - 0.01 * 0.05);
}

TEST(Pile, AThinPlateDoesNotSinkInUnderAHeavyBall) {
  Settings settings;
  settings.gravity_W = {0, -9.81, 0};
  World world(settings);
  AddFloor(world);
  const double half_thickness = 0.01;
  BodyDefinition plate;
  plate.shape = Box{{0.3, half_thickness, 0.3}};
  plate.mass = 0.5;
  plate.restitution = 0;
  plate.state.p_WB.y() = half_thickness;
  const int pressed = world.AddBody(plate);
  BodyDefinition ball;
  ball.shape = Sphere{0.15};
  ball.mass = 50;
  ball.restitution = 0;
  ball.state.p_WB.y() = 0.47;
  world.AddBody(ball);
  const double h = 1.0 / 480;
  for (int k = 0; k < 480; ++k) world.Step(h);
  const double slop = 2 * 9.81 * h * h;
  EXPECT_GT(world.state(pressed).p_WB.y(), 0.99 * half_thickness - slop);
}

// The depth that is tolerated, 2 g h², and the sag of a spring of frequency f under a
// quarter of the nine boxes on the lowest one. A contact at a corner moves 1/m + 6 (½² +
// ½²)/m = 4/m of each of its bodies. Twice the sag allows for boxes that do not stand in
// the middle.
TEST(Pile, ContactsAreNoDeeperThanTheSagOfTheirSprings) {
  const Settings settings;
  const double g = settings.gravity_W.norm();
  const double omega = 2 * std::numbers::pi * settings.contact_frequency;
  const double sag = 9 * g / 4 * (4 + 4) / (omega * omega);
  EXPECT_LT(DropColumns(10, settings).deepest, 2 * g * kH * kH + 2 * sag);
}

}  // namespace
}  // namespace cookbook
