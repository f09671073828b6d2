// Bodies at rest behave the same whether gravity, a force or a spring presses them on
// each other.

#include <cmath>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "engine/dynamics/world/world.h"

namespace cookbook {
namespace {

constexpr double kStep = 1.0 / 240;
constexpr double kG = 9.82;

/** The load on all bodies of a world. */
struct Load {
  Eigen::Vector3d gravity_W;
  Eigen::Vector3d force_per_mass_W;
};

const Load kGravity{{0, -kG, 0}, {0, 0, 0}};
const Load kForces{{0, 0, 0}, {0, -kG, 0}};
const Load kHalfOfEach{{0, -kG / 2, 0}, {0, -kG / 2, 0}};
const Load kForcesAgainstGravity{{0, kG, 0}, {0, -2 * kG, 0}};

Settings Under(const Eigen::Vector3d& gravity_W) {
  Settings settings;
  settings.gravity_W = gravity_W;
  return settings;
}

void AddFloor(World& world, double restitution = 1) {
  BodyDefinition floor;
  floor.shape = HalfSpace{};
  floor.state.q_WB = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(),
                                                        Eigen::Vector3d::UnitY());
  floor.mass = 0;
  floor.restitution = restitution;
  world.AddBody(floor);
}

BodyDefinition BoxAt(const Eigen::Vector3d& p_W, double mass,
                     const Eigen::Vector3d& force_W) {
  BodyDefinition box;
  box.shape = Box{{0.5, 0.5, 0.5}};
  box.restitution = 0;
  box.state.p_WB = p_W;
  box.mass = mass;
  box.force_W = force_W;
  return box;
}

BodyDefinition BallAt(const Eigen::Vector3d& p_W, double radius, double mass,
                      double restitution) {
  BodyDefinition ball;
  ball.shape = Sphere{radius};
  ball.state.p_WB = p_W;
  ball.mass = mass;
  ball.restitution = restitution;
  return ball;
}

/** Expects that `body` rests for eight steps, with a speed below `fraction` of the
 velocity that gravity would add in a step. */
void ExpectToRest(World& world, int body, double fraction) {
  for (int k = 0; k < 8; ++k) {
    world.Step(kStep);
    EXPECT_LT(world.state(body).v_WB.norm(), fraction * kG * kStep) << k;
  }
}

/** Simulates two stacks, one with a heavy box on a light one, a box that falls on a
 corner, a sliding box, and a ball that bounces and comes to rest. */
std::vector<BodyState> Simulate(const Load& load, int steps) {
  World world(Under(load.gravity_W));
  AddFloor(world);
  const auto add = [&](BodyDefinition body) {
    body.force_W = body.mass * load.force_per_mass_W;
    world.AddBody(body);
  };
  for (int k = 0; k < 3; ++k) add(BoxAt({0.1, 0.5 + k, -0.2}, 2, {0, 0, 0}));
  add(BoxAt({5.1, 0.5, -0.2}, 1, {0, 0, 0}));
  add(BoxAt({5.1, 1.5, -0.2}, 16, {0, 0, 0}));
  BodyDefinition falls = BoxAt({-4.3, 2.5, 1.7}, 0.5, {0, 0, 0});
  falls.state.q_WB = Eigen::Quaterniond(0.8, 0.3, -0.4, 0.1).normalized();
  falls.state.w_WB = {0.3, 1.1, -0.7};
  add(falls);
  BodyDefinition slides = BoxAt({9.3, 0.5, 3.1}, 4, {0, 0, 0});
  slides.state.v_WB = {1.3, 0, 0.4};
  add(slides);
  add(BallAt({-8.1, 1.2, 0.3}, 0.3, 1, 0.6));
  for (int k = 0; k < steps; ++k) world.Step(kStep);
  std::vector<BodyState> states;
  for (int i = 1; i < world.body_count(); ++i) states.push_back(world.state(i));
  return states;
}

/** Returns the greatest difference of a coordinate or a velocity. */
double Difference(const std::vector<BodyState>& a, const std::vector<BodyState>& b) {
  double greatest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    greatest = std::max({greatest, (a[i].p_WB - b[i].p_WB).cwiseAbs().maxCoeff(),
                         (a[i].v_WB - b[i].v_WB).cwiseAbs().maxCoeff(),
                         (a[i].w_WB - b[i].w_WB).cwiseAbs().maxCoeff()});
  }
  return greatest;
}

// Masses are powers of two, so that forces cause exactly the same acceleration.
TEST(ExternalLoads, ForcesGiveTheSameBitsAsGravity) {
  const std::vector<BodyState> by_gravity = Simulate(kGravity, 480);
  EXPECT_EQ(Difference(Simulate(kForces, 480), by_gravity), 0);
  EXPECT_EQ(Difference(Simulate(kHalfOfEach, 480), by_gravity), 0);
  EXPECT_EQ(Difference(Simulate(kForcesAgainstGravity, 480), by_gravity), 0);
}

TEST(ExternalLoads, AHeavyBoxOnALightOneRestsFromTheFirstStepUnderForces) {
  World world(Under({0, 0, 0}));
  AddFloor(world);
  world.AddBody(BoxAt({0.1, 0.5, -0.2}, 1, {0, -kG, 0}));
  const int heavy = world.AddBody(BoxAt({0.1, 1.5, -0.2}, 30, {0, -30 * kG, 0}));
  ExpectToRest(world, heavy, 1e-11);
}

TEST(ExternalLoads, ABoxWithoutAForceRestsUnderABoxWithOne) {
  World world(Under({0, 0, 0}));
  AddFloor(world);
  const int light = world.AddBody(BoxAt({0.1, 0.5, -0.2}, 1, {0, 0, 0}));
  const int heavy = world.AddBody(BoxAt({0.1, 1.5, -0.2}, 30, {0, -31 * kG, 0}));
  ExpectToRest(world, heavy, 1e-11);
  ExpectToRest(world, light, 1e-11);
}

TEST(ExternalLoads, AForceAppliedInEachStepKeepsBoxesAtRest) {
  World world(Under({0, 0, 0}));
  AddFloor(world);
  world.AddBody(BoxAt({0.1, 0.5, -0.2}, 1, {0, 0, 0}));
  const int heavy = world.AddBody(BoxAt({0.1, 1.5, -0.2}, 30, {0, 0, 0}));
  for (int k = 0; k < 8; ++k) {
    world.ApplyForce(heavy, world.state(heavy).p_WB, {0, -30 * kG, 0});
    world.Step(kStep);
    EXPECT_LT(world.state(heavy).v_WB.norm(), 1e-11 * kG * kStep) << k;
  }
}

TEST(ExternalLoads, ASpringKeepsBoxesAtRest) {
  World world(Under({0, 0, 0}));
  AddFloor(world);
  world.AddBody(BoxAt({0.1, 0.5, -0.2}, 1, {0, 0, 0}));
  const int heavy = world.AddBody(BoxAt({0.1, 1.5, -0.2}, 8, {0, 0, 0}));
  // Attached 1 m below the centre of the box, and stretched by 0.5 m.
  world.AddSpring({{heavy, {0, 0, 0}}, {-1, {0.1, 0.5, -0.2}}, 16 * kG, 0, 0.5});
  ExpectToRest(world, heavy, 1e-11);
}

TEST(ExternalLoads, BoxesRestInAnyDirection) {
  const Eigen::Quaterniond turn = Eigen::Quaterniond(0.7, -0.3, 0.2, 0.5).normalized();
  World world(Under({0, 0, 0}));
  BodyDefinition floor;
  floor.shape = HalfSpace{};
  floor.mass = 0;
  floor.state.q_WB = turn;
  world.AddBody(floor);
  int heavy = 0;
  for (const auto& [height, mass] : {std::pair(0.5, 1.0), std::pair(1.5, 30.0)}) {
    const Eigen::Vector3d p_W = turn * Eigen::Vector3d(0.1, -0.2, height);
    const Eigen::Vector3d force_W = turn * Eigen::Vector3d(0, 0, -mass * kG);
    BodyDefinition box = BoxAt(p_W, mass, force_W);
    box.state.q_WB = turn;
    heavy = world.AddBody(box);
  }
  ExpectToRest(world, heavy, 1e-11);
}

TEST(ExternalLoads, AForceOnADistantBodyDoesNotAffectAStack) {
  const auto run = [](bool driven) {
    World world(Under({0, -kG, 0}));
    AddFloor(world);
    for (int k = 0; k < 5; ++k) world.AddBody(BoxAt({0.1, 0.5 + k, -0.2}, 1, {0, 0, 0}));
    BodyDefinition shot = BallAt({-3, 2.5, 1.5}, 0.05, 1e-3, 0.5);
    if (driven) shot.force_W = {100, 0, 0};
    world.AddBody(shot);
    for (int k = 0; k < 100; ++k) world.Step(kStep);
    std::vector<BodyState> states;
    for (int i = 1; i <= 5; ++i) states.push_back(world.state(i));
    return states;
  };
  EXPECT_EQ(Difference(run(true), run(false)), 0);
}

TEST(ExternalLoads, AStackBearsALightBodyThatAGreatForcePressesOnIt) {
  World world(Under({0, -kG, 0}));
  AddFloor(world);
  for (int k = 0; k < 5; ++k) world.AddBody(BoxAt({0.1, 0.5 + k, -0.2}, 1, {0, 0, 0}));
  BodyDefinition light = BallAt({0.1, 5.05, -0.2}, 0.05, 1e-3, 0);
  light.force_W = {0, -100, 0};
  world.AddBody(light);
  for (int k = 0; k < 240; ++k) world.Step(kStep);
  for (int i = 1; i <= 5; ++i) {
    const Eigen::Vector3d place(0.1, i - 0.5, -0.2);
    EXPECT_LT((world.state(i).p_WB - place).norm(), 1e-6) << i;
  }
}

// No load acts on the ball, so it never comes to rest on a plate that a force presses
// down.
TEST(ExternalLoads, ABallWithoutALoadBouncesAtAnySpeed) {
  for (const double speed : {1.0, 1e-2, 1e-4}) {
    World world(Under({0, 0, 0}));
    AddFloor(world);
    BodyDefinition plate = BoxAt({0, 0.5, 0}, 1024, {0, 0, 0});
    plate.restitution = 1;
    world.AddBody(plate);
    world.AddBody(BoxAt({0.3, 1.5, 0}, 4, {0, -400, 0}));
    BodyDefinition ball = BallAt({-0.3, 1.1 + 10 * kStep * speed, 0}, 0.1, 0.001, 1);
    ball.state.v_WB = {0, -speed, 0};
    const int thrown = world.AddBody(ball);
    for (int k = 0; k < 40; ++k) world.Step(kStep);
    EXPECT_GT(world.state(thrown).v_WB.y(), 0.99 * speed) << speed;
  }
}

TEST(ExternalLoads, TwoBoxesThatAForcePushesMoveAsOneBody) {
  World world(Under({0, 0, 0}));
  world.AddBody(BoxAt({0, 0, 0}, 2, {6, 0, 0}));
  world.AddBody(BoxAt({1, 0, 0}, 1, {0, 0, 0}));
  const int steps = 240;
  for (int k = 0; k < steps; ++k) world.Step(kStep);
  const double t = steps * kStep;
  for (const int body : {0, 1}) {
    EXPECT_NEAR(world.state(body).p_WB.x(), body + 0.5 * 2 * t * t, 1e-9) << body;
    EXPECT_NEAR(world.state(body).v_WB.x(), 2 * t, 1e-9) << body;
  }
}

TEST(ExternalLoads, APendulumSwingsUnderAForceLikeUnderGravity) {
  const auto swing = [](const Load& load) {
    World world(Under(load.gravity_W));
    BodyDefinition bob;
    bob.shape = Point{};
    bob.mass = 2;
    bob.force_W = bob.mass * load.force_per_mass_W;
    bob.state.p_WB = {1, 0, 0};
    const int body = world.AddBody(bob);
    world.AddJoint({{-1, {0, 0, 0}}, {body, {0, 0, 0}}, 1});
    for (int k = 0; k < 1000; ++k) world.Step(1e-2);
    return std::vector<BodyState>{world.state(body)};
  };
  const std::vector<BodyState> by_gravity = swing(kGravity);
  EXPECT_EQ(Difference(swing(kForces), by_gravity), 0);
  EXPECT_EQ(Difference(swing(kHalfOfEach), by_gravity), 0);
}

TEST(ExternalLoads, BodiesWithBalancedForcesFallAsleep) {
  Settings settings;
  settings.sleep_after = 0.5;
  settings.gravity_W = {0, -kG, 0};
  World world(settings);
  // m g / m is not exactly g for every m.
  const std::vector<double> masses = {0.3, 0.7, 7, 49, 1.1};
  for (const double mass : masses) {
    world.AddBody(BoxAt({3 * mass, 3, 0}, mass, {0, mass * kG, 0}));
  }
  for (int k = 0; k < 150; ++k) world.Step(kStep);
  for (int body = 0; body < world.body_count(); ++body) {
    EXPECT_TRUE(world.IsAsleep(body)) << masses[static_cast<std::size_t>(body)];
  }
}

}  // namespace
}  // namespace cookbook
