#include <algorithm>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "engine/dynamics/world/world.h"

namespace cookbook {
namespace {

constexpr double kH = 1.0 / 120;
constexpr double kApproach = 2;  // [m/s]
constexpr int kBricksPerRow = 6;

/** Settings without an iteration budget, under which every world may be solved in single
 precision. */
Settings WithoutBudget() {
  Settings settings;
  settings.gravity_W.setZero();
  settings.iteration_budget = 0;
  return settings;
}

/** Adds two floating walls of `row` × `row` bricks that collide in the first step. The
 bricks are slightly rotated, of different masses, and have friction. `frame` [m/s] is
 added to all velocities. */
void AddTwoWalls(World& world, const Eigen::Vector3d& frame = {0, 0, 0},
                 int row = kBricksPerRow) {
  for (int wall = 0; wall < 2; ++wall) {
    for (int k = 0; k < row * row; ++k) {
      BodyDefinition brick;
      brick.shape = Box{{0.5, 0.4, 0.45}};
      brick.mass = 1 + 0.1 * (k % 4);
      brick.restitution = 0;
      const double tilt = 1e-4 * (k % 5);
      const int layer = k / row;
      brick.state.p_WB = {1.0 * wall, 0.8 * (k % row), 0.9 * layer};
      brick.state.q_WB = Eigen::Quaterniond(1, tilt, -tilt, 2 * tilt).normalized();
      brick.state.v_WB =
          frame + Eigen::Vector3d(wall == 0 ? kApproach : -kApproach, 0.3 * wall, 0);
      brick.state.w_WB = {0, 0, 0.01 * (k % 3)};
      world.AddBody(brick);
    }
  }
}

/** Returns the number of contacts with an impulse. */
int CountActingContacts(const World& world) {
  std::vector<ContactImpulse> impulses;
  world.AppendContactImpulses(impulses);
  int acting = 0;
  for (const ContactImpulse& impulse : impulses) {
    acting += impulse.J_B_W.isZero(0) ? 0 : 1;
  }
  return acting;
}

double MassOf(int body) {
  return 1 + 0.1 * (body % (kBricksPerRow * kBricksPerRow) % 4);
}

/** Returns the greatest difference of a velocity or spin. [m/s], [rad/s] */
double MaxDifference(const World& a, const World& b) {
  double greatest = 0;
  for (int i = 0; i < a.body_count(); ++i) {
    greatest = std::max({greatest, (a.state(i).v_WB - b.state(i).v_WB).norm(),
                         (a.state(i).w_WB - b.state(i).w_WB).norm()});
  }
  return greatest;
}

Eigen::Vector3d MomentumOf(const World& world) {
  Eigen::Vector3d p = Eigen::Vector3d::Zero();
  for (int i = 0; i < world.body_count(); ++i) p += MassOf(i) * world.state(i).v_WB;
  return p;
}

/** Returns the angular momentum about the origin of bodies with the velocities of `world`
 and the poses of `start`. */
Eigen::Vector3d AngularMomentumOf(const World& world, const World& start) {
  Eigen::Vector3d L = Eigen::Vector3d::Zero();
  for (int i = 0; i < world.body_count(); ++i) {
    const BodyState& at = start.state(i);
    const BodyState& now = world.state(i);
    const Eigen::Matrix3d R = at.q_WB.toRotationMatrix();
    const Eigen::Vector3d moments = PrincipalInertia(Box{{0.5, 0.4, 0.45}}, MassOf(i));
    L += MassOf(i) * at.p_WB.cross(now.v_WB) +
         R * moments.cwiseProduct(R.transpose() * now.w_WB);
  }
  return L;
}

// The two bodies of a contact receive exactly opposite impulses, however rounded.
TEST(SinglePrecision, KeepsMomentumToTheRoundingOfADouble) {
  World world(WithoutBudget());
  AddTwoWalls(world);
  const Eigen::Vector3d before = MomentumOf(world);
  for (int k = 0; k < 30; ++k) world.Step(kH);
  // 30 steps of about 300 impulses of 1 N s, each rounded by 2.2e-16 of itself.
  EXPECT_LT((MomentumOf(world) - before).norm(), 30 * 300 * 2.2e-16);
}

// The two impulses act at exactly the same point.
TEST(SinglePrecision, KeepsAngularMomentumToTheRoundingOfADouble) {
  Settings settings = WithoutBudget();
  settings.gyroscopic = Gyroscopic::kOff;
  settings.stabilisation = Stabilisation::kNone;
  World start(settings);
  World world(settings);
  AddTwoWalls(start);
  AddTwoWalls(world);
  world.Step(kH);
  ASSERT_GT(CountActingContacts(world), 100);
  const Eigen::Vector3d change =
      AngularMomentumOf(world, start) - AngularMomentumOf(start, start);
  // 300 impulses of 1 N s, about 5 m from the origin; the error of a float would be 1e-7.
  EXPECT_LT(change.norm(), 300 * 5 * 2.2e-16);
}

/** Expects that a step differs from one in double precision by rounding only. */
void ExpectOnlyRounding(const Eigen::Vector3d& frame) {
  World single(WithoutBudget());
  AddTwoWalls(single, frame);
  Settings settings = WithoutBudget();
  settings.single_precision = false;
  World exact(settings);
  AddTwoWalls(exact, frame);
  single.Step(kH);
  exact.Step(kH);
  ASSERT_GT(CountActingContacts(exact), 100);
  // Each of about 30 operations in ten iterations rounds by 6e-8 of the approach speed.
  // An iteration is linear in its initial values, except for the clamping.
  EXPECT_LT(MaxDifference(single, exact), 10 * 30 * 6e-8 * kApproach);
  EXPECT_NE(MaxDifference(single, exact), 0) << "Both were solved in double precision.";
}

TEST(SinglePrecision, DiffersFromDoublePrecisionByRoundingOnly) {
  ExpectOnlyRounding({0, 0, 0});
}

// The changes of velocities are rounded, not the velocities: the rounding error of a
// float of 1e5 m/s would be 4e-3 m/s.
TEST(SinglePrecision, IsAsAccurateInAFastFrame) {
  ExpectOnlyRounding({3e4, 1e5, -2e4});
}

/** Returns whether a world with that body is solved in double precision. */
bool ForcesDoublePrecision(const BodyDefinition& body, bool comes_first = false) {
  Settings settings = WithoutBudget();
  World world_of_default(settings);
  settings.single_precision = false;
  World world_of_doubles(settings);
  for (World* world : {&world_of_default, &world_of_doubles}) {
    if (comes_first) world->AddBody(body);
    AddTwoWalls(*world);
    if (!comes_first) world->AddBody(body);
    world->Step(kH);
  }
  return MaxDifference(world_of_default, world_of_doubles) == 0;
}

BodyDefinition FarAway(const BodyShape& shape) {
  BodyDefinition body;
  body.shape = shape;
  body.state.p_WB = {100, 0, 0};
  return body;
}

TEST(SinglePrecision, IsNotUsedForBodiesWhoseResponsesItCannotRepresent) {
  EXPECT_FALSE(ForcesDoublePrecision(FarAway(Box{{0.5, 0.5, 0.5}})));
  EXPECT_FALSE(ForcesDoublePrecision(FarAway(Box{{0.5, 0.05, 0.5}})));
  const BodyDefinition wire = FarAway(Box{{0.5, 0.01, 0.01}});
  EXPECT_TRUE(ForcesDoublePrecision(wire));
  EXPECT_TRUE(ForcesDoublePrecision(wire, true));
  BodyDefinition heavy = FarAway(Sphere{1});
  heavy.mass = 1e20;
  EXPECT_TRUE(ForcesDoublePrecision(heavy));
  BodyDefinition wheel = FarAway(Box{{1e3, 1e3, 1e3}});
  wheel.inertia = Eigen::Vector3d::Constant(1e-14);
  EXPECT_TRUE(ForcesDoublePrecision(wheel));
}

/** Adds a row of boxes that penetrate a floor by `depth` [m]. The floor is 200 km wide,
 and its centre is 50 km away. */
void AddBoxesOnWideFloor(World& world, double depth) {
  BodyDefinition floor;
  floor.shape = Box{{1e5, 1, 1e5}};
  floor.state.p_WB = {5e4, -1, 0};
  floor.mass = 0;
  world.AddBody(floor);
  for (int k = 0; k < 40; ++k) {
    BodyDefinition box;
    box.shape = Box{{0.05, 0.05, 0.05}};
    box.restitution = 0;
    box.state.p_WB = {0.2 * k, 0.05 - depth, 0};
    world.AddBody(box);
  }
}

TEST(SinglePrecision, BodiesFarFromTheCentreOfTheGroundStayAtRest) {
  Settings settings = WithoutBudget();
  settings.gravity_W = {0, -9.82, 0};
  World world(settings);
  AddBoxesOnWideFloor(world, 0);
  for (int k = 0; k < 240; ++k) world.Step(kH);
  ASSERT_GT(CountActingContacts(world), 100);
  for (int i = 1; i < world.body_count(); ++i) {
    // Rounding of ten iterations, relative to the speed that gravity adds in a step.
    EXPECT_LT(world.state(i).v_WB.norm(), 10 * 30 * 6e-8 * 9.82 * kH) << i;
  }
}

TEST(SinglePrecision, RemovesOverlapDownToTheSlopAndTheSagOfTheSprings) {
  Settings settings = WithoutBudget();
  settings.gravity_W = {0, -9.82, 0};
  World world(settings);
  const double slop = 2 * 9.82 * kH * kH;
  // The spring of a contact sags by g/ω² when a quarter of its box lies on it: at a
  // corner it has the effective mass m/4.
  const double omega = 2 * std::numbers::pi * settings.contact_frequency;
  const double tolerated = slop + 9.82 / (omega * omega);
  AddBoxesOnWideFloor(world, 5 * slop);
  for (int k = 0; k < 120; ++k) world.Step(kH);
  for (int i = 1; i < world.body_count(); ++i) {
    // A step removes a fifth of the depth beyond the slop: 4 · 0.8¹²⁰ of a slop remains,
    // and the rounding error of the depth as a float.
    EXPECT_NEAR(0.05 - world.state(i).p_WB.y(), tolerated, 1e-6 * slop) << i;
  }
}

// In single precision, colliding wires would gain 1e12 times their energy.
TEST(SinglePrecision, CrossingWiresGainNoEnergy) {
  World world(WithoutBudget());
  const auto add = [&](double x, double y, double v) {
    BodyDefinition wire;
    wire.shape = v > 0 ? Box{{0.5, 1e-5, 1e-5}} : Box{{1e-5, 1e-5, 0.5}};
    wire.restitution = 0;
    wire.state.p_WB = {x, y, 0};
    wire.state.v_WB = {0, v, 0};
    world.AddBody(wire);
  };
  constexpr int kPairs = 150;
  for (int k = 0; k < kPairs; ++k) {
    add(2 * k, -1.5e-5, 0.05);
    add(2 * k + 0.2, 1.5e-5, -0.05);
  }
  for (int k = 0; k < 3; ++k) world.Step(kH);
  double energy = 0;
  for (int i = 0; i < world.body_count(); ++i) {
    energy += 0.5 * world.state(i).v_WB.squaredNorm();
  }
  EXPECT_LE(energy, 2 * kPairs * 0.5 * 0.05 * 0.05);
}

// The walls are wide enough for the threads to share each colour.
TEST(SinglePrecision, TheBitsOfALargeIslandDoNotDependOnTheNumberOfThreads) {
  Settings settings = WithoutBudget();
  World one(settings);
  settings.threads = 3;
  World three(settings);
  for (World* world : {&one, &three}) {
    AddTwoWalls(*world, {0, 0, 0}, 60);
    for (int k = 0; k < 3; ++k) world->Step(kH);
  }
  EXPECT_EQ(MaxDifference(one, three), 0);
}

}  // namespace
}  // namespace cookbook
