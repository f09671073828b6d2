#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "engine/dynamics/world/world.h"

namespace cookbook {
namespace {

constexpr double kGravity = 9.81;

Settings OnEarth() {
  Settings settings;
  settings.gravity_W = {0, -kGravity, 0};
  return settings;
}

void AddFloor(double restitution, World& world) {
  BodyDefinition floor;
  floor.shape = Box{{20, 1, 20}};
  floor.state.p_WB = {0.3, -1, 0.2};
  floor.mass = 0;
  floor.restitution = restitution;
  world.AddBody(floor);
}

/** The same without edges: the half-space below y = 0. */
void AddGround(double restitution, World& world) {
  BodyDefinition ground;
  ground.shape = HalfSpace{};
  ground.state.q_WB = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(),
                                                         Eigen::Vector3d::UnitY());
  ground.mass = 0;
  ground.restitution = restitution;
  world.AddBody(ground);
}

BodyDefinition Ball(double height, double restitution) {
  BodyDefinition ball;
  ball.shape = Sphere{0.1};
  ball.restitution = restitution;
  ball.friction = 0;
  ball.state.p_WB = {0.17, 0.1 + height, -0.31};
  return ball;
}

/** Returns the height above the floor of a ball that falls from `height` and bounces
 without loss: a fall of T = √(2 height / g), then flights of 2 T. */
double HeightOfBouncingBall(double height, double time) {
  const double fall = std::sqrt(2 * height / kGravity);
  const double since_apex = std::remainder(time, 2 * fall);
  return height - kGravity / 2 * since_apex * since_apex;
}

TEST(ImpactSolver, ABouncingBallIsAtTheClosedFormPositionForAnyTimeStep) {
  for (const double h : {1e-3, 7e-3, 4e-2}) {
    World world(OnEarth());
    AddFloor(1, world);
    const int ball = world.AddBody(Ball(1.3, 1));
    for (int k = 1; k * h < 5; ++k) {
      world.Step(h);
      // The position of an impact is off by at most 1e-10 of the radius, and errors add
      // up.
      EXPECT_NEAR(world.state(ball).p_WB[1] - 0.1, HeightOfBouncingBall(1.3, k * h), 1e-9)
          << h << " " << k;
    }
  }
}

TEST(ImpactSolver, ABallBouncesMoreThanOnceInAStep) {
  Settings settings;
  settings.gravity_W.setZero();
  World world(settings);
  BodyDefinition wall;
  wall.shape = Box{{1, 5, 5}};
  wall.mass = 0;
  wall.restitution = 1;
  for (const double x : {-1.0, 1.5}) {
    wall.state.p_WB = {x, 0, 0};
    world.AddBody(wall);
  }
  BodyDefinition ball = Ball(0, 1);
  ball.state.p_WB = {0.2, 0.4, -0.3};
  ball.state.v_WB = {100, 3, 0};
  const int body = world.AddBody(ball);
  world.Step(1e-2);
  // The centre can move by 0.3 m between the walls, and moves by 1 m: from 0.2 to 0.4,
  // back to 0.1, to 0.4, and back to 0.2.
  EXPECT_NEAR(world.state(body).p_WB[0], 0.2, 1e-9);
  EXPECT_NEAR(world.state(body).p_WB[1], 0.43, 1e-12);
  EXPECT_NEAR(world.state(body).v_WB[0], -100, 1e-9);
}

TEST(ImpactSolver, ABallDoesNotLeaveASlotThatItCrossesAThousandTimesAStep) {
  Settings settings;
  settings.gravity_W.setZero();
  World world(settings);
  BodyDefinition wall;
  wall.shape = Box{{1, 5, 5}};
  wall.mass = 0;
  wall.restitution = 1;
  for (const double x : {-1.0, 1.201}) {
    wall.state.p_WB = {x, 0, 0};
    world.AddBody(wall);
  }
  BodyDefinition ball = Ball(0, 1);
  ball.state.p_WB = {0.1003, 0.4, -0.3};
  ball.state.v_WB = {100, 0, 0};
  const int body = world.AddBody(ball);
  for (int k = 0; k < 20; ++k) {
    world.Step(1e-2);
    EXPECT_GE(world.state(body).p_WB[0], 0.1 - 1e-9);
    EXPECT_LE(world.state(body).p_WB[0], 0.101 + 1e-9);
    EXPECT_NEAR(std::abs(world.state(body).v_WB[0]), 100, 1e-9);
  }
}

// Elastic impacts keep the energy, and blocks that close at equal speeds leave with them.
TEST(ImpactSolver, ALightBallTurnsHeavyBlocksRound) {
  Settings settings;
  settings.gravity_W.setZero();
  World world(settings);
  BodyDefinition block;
  block.shape = Box{{0.5, 1, 1}};
  block.mass = 1000;
  block.restitution = 1;
  block.friction = 0;
  block.state.p_WB = {-2, 0, 0};
  block.state.v_WB = {3, 0, 0};
  const int left = world.AddBody(block);
  block.state.p_WB = {2, 0, 0};
  block.state.v_WB = {-3, 0, 0};
  const int right = world.AddBody(block);
  BodyDefinition ball = Ball(0, 1);
  ball.mass = 0.1;
  ball.state.p_WB = {0.3, 0, 0};
  const int light = world.AddBody(ball);
  for (int k = 0; k < 60; ++k) world.Step(1.0 / 60);
  const double left_speed = world.state(left).v_WB[0];
  const double right_speed = world.state(right).v_WB[0];
  const double ball_speed = world.state(light).v_WB[0];
  EXPECT_LT(left_speed, -2.9);
  EXPECT_GT(right_speed, 2.9);
  EXPECT_LT(world.state(left).p_WB[0] + 0.5, world.state(light).p_WB[0]);
  EXPECT_GT(world.state(right).p_WB[0] - 0.5, world.state(light).p_WB[0]);
  EXPECT_NEAR(500 * (left_speed * left_speed + right_speed * right_speed) +
                  0.05 * ball_speed * ball_speed,
              9000, 1e-8);
}

// A heavy ball knocks a leaning plank at a wall. One end of the plank touches the wall
// while the other swings at it, by 6 cm a step.
TEST(ImpactSolver, APlankThatIsKnockedFlatAtAWallDoesNotSinkIn) {
  World world(OnEarth());
  AddGround(0.3, world);
  BodyDefinition wall;
  wall.shape = Box{{0.2, 2, 2}};
  wall.mass = 0;
  wall.restitution = 0.3;
  wall.friction = 0.6;
  wall.state.p_WB = {1, 2, 0};
  world.AddBody(wall);
  BodyDefinition plank = wall;
  plank.shape = Box{{0.05, 0.8, 0.3}};
  plank.mass = 2;
  plank.state.p_WB = {0.52, 0.8, 0};
  plank.state.q_WB = Eigen::AngleAxisd(std::numbers::pi / -12, Eigen::Vector3d::UnitZ());
  const int knocked = world.AddBody(plank);
  BodyDefinition ball = wall;
  ball.shape = Sphere{0.3};
  ball.mass = 40;
  ball.state.p_WB = {-1, 0.3, 0};
  ball.state.v_WB = {6, 0, 0};
  world.AddBody(ball);
  double deepest = 0;
  for (int k = 0; k < 60; ++k) {
    world.Step(1.0 / 120);
    const BodyState& state = world.state(knocked);
    const Eigen::Vector3d across = state.q_WB * Eigen::Vector3d(0.05, 0, 0);
    const Eigen::Vector3d along = state.q_WB * Eigen::Vector3d(0, 0.8, 0);
    const double reach = std::abs(across.x()) + std::abs(along.x());
    deepest = std::max(deepest, state.p_WB.x() + reach - 0.8);
  }
  EXPECT_GT(deepest, -0.01);
  EXPECT_LT(deepest, 0.005);  // A twentieth of its thickness.
}

// The box bears a load, so it is followed from the end of the step. The force pulls it
// along the plane before the impact and after it.
TEST(ImpactSolver, ABoxThatSlidesDownAndBouncesOffAHeavyBallKeepsItsEnergy) {
  constexpr double kH = 1.0 / 60;
  const Eigen::Vector3d force_W(kGravity / 2, -std::sqrt(0.75) * kGravity, 0);
  for (int phase = 0; phase < 20; ++phase) {
    Settings settings;
    settings.gravity_W.setZero();
    World world(settings);
    AddFloor(1, world);
    BodyDefinition box;
    box.shape = Box{{0.2, 0.2, 0.2}};
    box.mass = 1;
    box.restitution = 1;
    box.friction = 0;
    box.force_W = force_W;
    box.state.p_WB = {0, 0.2, 0};
    box.state.v_WB = {2, 0, 0};
    const int body = world.AddBody(box);
    BodyDefinition heavy = Ball(0, 1);
    heavy.mass = 1000;
    heavy.state.p_WB = {0.5 + 0.002 * phase, 0.2, 0};
    const int ball = world.AddBody(heavy);
    const auto energy = [&] {
      const BodyState& state = world.state(body);
      return state.v_WB.squaredNorm() / 2 - force_W.dot(state.p_WB) +
             500 * world.state(ball).v_WB.squaredNorm();
    };
    const double start = energy();
    for (int k = 0; k < 12; ++k) world.Step(kH);
    EXPECT_LT(world.state(body).v_WB.x(), 0) << phase;
    EXPECT_NEAR(energy(), start, 1e-9) << phase;
  }
}

TEST(ImpactSolver, ABoxDoesNotTunnelThroughAPlateThinnerThanItsTravelInAStep) {
  Settings settings;
  settings.gravity_W.setZero();
  World world(settings);
  BodyDefinition plate;
  plate.shape = Box{{0.001, 2, 2}};
  plate.mass = 0;
  plate.restitution = 1;
  world.AddBody(plate);
  BodyDefinition box;
  box.shape = Box{{0.1, 0.07, 0.05}};
  box.restitution = 0.5;
  box.friction = 0;
  box.state.p_WB = {-0.6, 0.1, 0.2};
  box.state.v_WB = {200, 0, 0};
  const int body = world.AddBody(box);
  world.Step(1e-2);
  // 0.499 m at 200 m/s, then the rest of the step at half that speed.
  EXPECT_NEAR(world.state(body).p_WB[0], -0.101 - 100 * (1e-2 - 0.499 / 200), 1e-9);
}

/** Steps once a world in which a ball moves freely towards a plate, and a pendulum far
 away hangs from the world or from the plate. Returns the state of the ball. */
BodyState StateOfABallAtAPlate(bool plate_holds_pendulum) {
  Settings settings;
  settings.gravity_W.setZero();
  World world(settings);
  BodyDefinition plate;
  plate.shape = Box{{0.001, 2, 2}};
  plate.mass = 0;
  plate.restitution = 1;
  const int holds = world.AddBody(plate);
  BodyDefinition ball = Ball(0, 1);
  ball.state.p_WB = {-0.6, 0.1, 0.2};
  ball.state.v_WB = {200, 0, 0};
  const int body = world.AddBody(ball);
  ball.state.p_WB = {100, 0, 0};
  ball.state.v_WB = {0, 1, 0};
  const int bob = world.AddBody(ball);
  world.AddJoint({{plate_holds_pendulum ? holds : -1, {100, 0, 3}}, {bob, {0, 0, 0}}, 3});
  world.Step(1e-2);
  return world.state(body);
}

// The ball moves by two thirds of its rod in a step. It reaches the plate, 1 cm thick,
// when the rod has turned by 1.47 rad, in the third step, and swings back.
TEST(ImpactSolver, ABallOnARodDoesNotTunnel) {
  Settings settings;
  settings.gravity_W.setZero();
  World world(settings);
  BodyDefinition plate;
  plate.shape = Box{{0.005, 0.5, 0.5}};
  plate.state.p_WB = {0, -1, 0};
  plate.mass = 0;
  plate.restitution = 1;
  world.AddBody(plate);
  BodyDefinition ball = Ball(0, 1);
  ball.state.p_WB = {1, 0, 0};
  ball.state.v_WB = {0, -40, 0};
  const int body = world.AddBody(ball);
  world.AddJoint({{-1, {0, 0, 0}}, {body, {0, 0, 0}}, 1});
  for (int k = 0; k < 3; ++k) world.Step(1.0 / 60);
  const BodyState& end = world.state(body);
  // The impact is found in a 64th of a step, which turns the rod by 0.01 rad.
  const double turned = 2 * std::acos(0.105) - 3.0 * 40 / 60;
  EXPECT_NEAR(end.p_WB[0], std::cos(turned), 0.02);
  EXPECT_NEAR(end.p_WB[1], -std::sin(turned), 0.02);
  EXPECT_NEAR(end.v_WB.norm(), 40, 1e-9);
  EXPECT_GT(end.v_WB[1], 0);
}

// A world with joints takes a fourth-order step if no impact is possible.
TEST(ImpactSolver, ABallDoesNotTunnelWhileAPendulumSwingsElsewhere) {
  for (const bool plate_holds_pendulum : {false, true}) {
    const BodyState ball = StateOfABallAtAPlate(plate_holds_pendulum);
    // 0.499 m to the plate and 1.501 m back.
    EXPECT_NEAR(ball.p_WB[0], -0.101 - 1.501, 1e-9) << plate_holds_pendulum;
    EXPECT_NEAR(ball.v_WB[0], -200, 1e-9) << plate_holds_pendulum;
  }
}

TEST(ImpactSolver, ABallBouncesOnAFloorThatAPendulumIsAttachedTo) {
  World world(OnEarth());
  AddFloor(1, world);
  BodyDefinition ball = Ball(2, 1);
  const int body = world.AddBody(ball);
  ball.state.p_WB = {8, 2, 0};
  const int bob = world.AddBody(ball);
  world.AddJoint({{0, {7.7, 4, -0.2}}, {bob, {0, 0, 0}}, 1});  // The point (8, 3, 0).
  const auto energy = [&] {
    const BodyState& state = world.state(body);
    return 0.5 * state.v_WB.squaredNorm() + kGravity * state.p_WB[1];
  };
  const double before = energy();
  for (int k = 0; k < 1200; ++k) world.Step(1.0 / 120);
  EXPECT_NEAR(energy(), before, 1e-9 * before);
  EXPECT_GT(world.state(body).p_WB[1], 0.49);
}

TEST(ImpactSolver, ABallThatAForceAcceleratesDoesNotTunnel) {
  Settings settings;
  settings.gravity_W.setZero();
  World world(settings);
  BodyDefinition plate;
  plate.shape = Box{{0.001, 2, 2}};
  plate.mass = 0;
  plate.restitution = 1;
  plate.state.p_WB = {0.351, 0, 0};
  world.AddBody(plate);
  BodyDefinition ball;
  ball.shape = Sphere{0.05};
  ball.restitution = 1;
  ball.friction = 0;
  ball.force_W = {2e4, 0, 0};
  ball.state.v_WB = {60, 0, 0};
  const int body = world.AddBody(ball);
  const double h = 1.0 / 240;
  world.Step(h);
  // The plate is 0.3 m away, farther than the 0.25 m that the initial speed covers.
  const double impact_speed = std::sqrt(60 * 60 + 2 * 2e4 * 0.3);
  const double left = h - (impact_speed - 60) / 2e4;
  EXPECT_NEAR(world.state(body).p_WB[0], 0.3 - impact_speed * left + 1e4 * left * left,
              1e-9);
  EXPECT_NEAR(world.state(body).v_WB[0], 2e4 * left - impact_speed, 1e-9);
}

// Each ball is at rest at the start of the step and is hit during it.
TEST(ImpactSolver, ImpactsPropagateThroughARowOfBallsInOneStep) {
  Settings settings;
  settings.gravity_W.setZero();
  World world(settings);
  BodyDefinition ball;
  ball.shape = Sphere{0.02};
  ball.restitution = 1;
  ball.friction = 0;
  for (int i = 0; i < 4; ++i) {
    ball.state.p_WB = {0.07 * i, 0, 0};
    ball.state.v_WB = {i == 0 ? 6.0 : 0.0, 0, 0};
    world.AddBody(ball);
  }
  for (int k = 0; k < 10; ++k) world.Step(1.0 / 60);
  // Each ball moves 3 cm to the next one and stays there; the last one moves the rest of
  // 1 m.
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(world.state(i).p_WB[0], 0.07 * i + 0.03, 1e-9) << i;
    EXPECT_NEAR(world.state(i).v_WB[0], 0, 1e-9) << i;
  }
  EXPECT_NEAR(world.state(3).p_WB[0], 0.21 + 1 - 0.09, 1e-9);
  EXPECT_NEAR(world.state(3).v_WB[0], 6, 1e-9);
}

TEST(ImpactSolver, ABallThatIsHitDoesNotTunnelThroughADistantPlate) {
  Settings settings;
  settings.gravity_W.setZero();
  World world(settings);
  BodyDefinition ball;
  ball.shape = Sphere{0.1};
  ball.restitution = 1;
  ball.friction = 0;
  ball.mass = 100;
  ball.state.p_WB = {-0.25, 0, 0};
  ball.state.v_WB = {60, 0, 0};
  world.AddBody(ball);
  ball.shape = Sphere{0.05};
  ball.mass = 0.1;
  ball.state = {};
  const int light = world.AddBody(ball);
  BodyDefinition plate;
  plate.shape = Box{{0.005, 2, 2}};
  plate.mass = 0;
  plate.restitution = 1;
  plate.state.p_WB = {0.3, 0, 0};
  world.AddBody(plate);
  world.Step(1.0 / 240);
  // Hit after 0.1 m at 60 m/s, it leaves with 2 · 60 · 100/100.1 m/s and bounces off the
  // plate after 0.245 m. The heavy ball does not reach it again within the step.
  const double v = 120 * 100 / 100.1;
  const double way = v * (1.0 / 240 - 0.1 / 60);
  EXPECT_NEAR(world.state(light).p_WB[0], 2 * 0.245 - way, 1e-9);
  EXPECT_NEAR(world.state(light).v_WB[0], -v, 1e-9);
}

TEST(ImpactSolver, ASpinningBoxHitsWithItsFirstCorner) {
  World world(OnEarth());
  AddFloor(1, world);
  BodyDefinition box;
  box.shape = Box{{0.3, 0.2, 0.1}};
  box.restitution = 0.6;
  box.state.p_WB = {0.1, 1.7, 0};
  box.state.q_WB = Eigen::Quaterniond(0.9, 0.1, -0.3, 0.2).normalized();
  box.state.w_WB = {5, -7, 3};
  const int body = world.AddBody(box);
  const auto lowest = [&] {
    const BodyState& state = world.state(body);
    const Eigen::Vector3d up_B = state.q_WB.conjugate() * Eigen::Vector3d::UnitY();
    return state.p_WB[1] - up_B.cwiseAbs().dot(Eigen::Vector3d(0.3, 0.2, 0.1));
  };
  const double h = 1e-2;
  bool rose = false;
  for (int k = 0; k < 60; ++k) {
    world.Step(h);
    // The impact of a second corner is detected up to a quarter of a step late, and the
    // corner is no faster than the fall and the spin together.
    EXPECT_GT(lowest(), -h / 4 * (6 + 0.4 * 20));
    rose = rose || world.state(body).v_WB[1] > 0;
  }
  EXPECT_TRUE(rose);
}

// Plates and bars of up to 1 : 50 that turn by up to four radians in a step.
TEST(ImpactSolver, ASpinningPlateOrBarDoesNotTunnelThroughAWall) {
  std::mt19937_64 bits(1);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(bits() >> 11) * 0x1p-53;
  };
  const auto vector = [&] {
    return Eigen::Vector3d(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1));
  };
  constexpr double h = 1.0 / 60;
  for (int k = 0; k < 1000; ++k) {
    Settings settings;
    settings.gravity_W.setZero();
    World world(settings);
    BodyDefinition wall;
    wall.shape = Box{{0.25, 20, 20}};
    wall.state.p_WB.x() = 2.25;
    wall.mass = 0;
    wall.restitution = uniform(0, 1);
    world.AddBody(wall);
    BodyDefinition body;
    const double thin = 0.5 * std::exp(uniform(std::log(0.02), std::log(0.5)));
    body.shape = Box{{0.5, k % 2 == 0 ? 0.5 : thin, thin}};
    body.state.q_WB = Eigen::Quaterniond(Eigen::AngleAxisd(3, vector().normalized()));
    body.state.v_WB.x() = uniform(1, 100);
    body.state.w_WB = 4 / h / std::sqrt(3) * vector();
    body.restitution = 1;
    world.AddBody(body);
    for (int step = 0; step < 40; ++step) {
      world.Step(h);
      ASSERT_LT(world.state(1).p_WB.x(), 2.25) << k << " " << step;
    }
  }
}

// A bar that hits a wall with its tip spins by many radians in a step, beside a wall that
// is as thin as the bar.
TEST(ImpactSolver, ABarThatTheImpactSpinsDoesNotTunnelThroughAThinWall) {
  std::mt19937_64 bits(1);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(bits() >> 11) * 0x1p-53;
  };
  constexpr double h = 1.0 / 60;
  for (int k = 0; k < 40; ++k) {
    Settings settings;
    settings.gravity_W.setZero();
    World world(settings);
    BodyDefinition wall;
    wall.shape = Box{{0.005, 40, 40}};
    wall.state.p_WB.x() = 2.6;
    wall.mass = 0;
    wall.restitution = 0.3;
    world.AddBody(wall);
    BodyDefinition bar;
    bar.shape = Box{{0.5, 0.005, 0.005}};
    bar.state.q_WB =
        Eigen::Quaterniond(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1), uniform(-1, 1))
            .normalized();
    bar.state.v_WB.x() = uniform(20, 50);
    bar.state.w_WB = {uniform(-10, 10), uniform(-10, 10), uniform(-10, 10)};
    bar.restitution = 0.3;
    world.AddBody(bar);
    for (int step = 0; step < 20; ++step) {
      world.Step(h);
      ASSERT_LT(world.state(1).p_WB.x(), 2.6) << k << " " << step;
    }
  }
}

TEST(ImpactSolver, AnInelasticBallStaysWhereItLands) {
  for (const double h : {1e-3, 7e-3, 4e-2}) {
    World world(OnEarth());
    AddFloor(1, world);
    const int ball = world.AddBody(Ball(1.3, 0));
    for (int k = 0; k * h < 1; ++k) world.Step(h);
    EXPECT_NEAR(world.state(ball).p_WB[1], 0.1, 1e-9) << h;
    EXPECT_LT(world.state(ball).v_WB.norm(), 1e-9) << h;
  }
}

TEST(ImpactSolver, AnImpactFromWithinTheSpeculativeMarginStopsAtTheSurface) {
  // A ball hits a resting one from within the speculative margin. If it were treated as a
  // contact, it would move with the mean of its velocities, by 0.4 mm, before it stops.
  World world(OnEarth());
  AddFloor(0, world);
  const int lower = world.AddBody(Ball(0, 0.5));
  const double h = 1.0 / 240;
  for (int k = 0; k < 5; ++k) world.Step(h);
  BodyDefinition ball = Ball(0.2 + 5e-5, 0.5);
  ball.state.v_WB[1] = -0.19;
  const int upper = world.AddBody(ball);
  for (int k = 0; k < 5; ++k) {
    world.Step(h);
    // The displacement by gravity in a step may remain as penetration.
    EXPECT_GT(world.state(upper).p_WB[1] - world.state(lower).p_WB[1],
              0.2 - 0.5 * kGravity * h * h)
        << k;
  }
}

TEST(ImpactSolver, AnImpactOnALargeIslandOrAPendulumFromWithinTheMarginDoesNotPenetrate) {
  // Neither takes part in impacts.
  const double h = 1.0 / 240;
  for (const bool pendulum : {false, true}) {
    World world(OnEarth());
    AddFloor(0, world);
    int top = 0;
    const int balls = pendulum ? 1 : 40;
    // A row of touching balls. The one that is hit comes last.
    for (int k = balls - 1; k >= 0; --k) {
      BodyDefinition ball = Ball(pendulum ? 1 : 0, 0);
      ball.state.p_WB[0] += 0.2 * k;
      top = world.AddBody(ball);
    }
    if (pendulum) {
      const Eigen::Vector3d p_WB = world.state(top).p_WB;
      world.AddJoint({{top, {0, 0, 0}}, {-1, p_WB + Eigen::Vector3d::UnitY()}, 1});
    }
    for (int k = 0; k < 5; ++k) world.Step(h);
    BodyDefinition ball = Ball(0, 0);
    ball.state.p_WB = world.state(top).p_WB + Eigen::Vector3d(0, 0.2 + 5e-5, 0);
    ball.state.v_WB[1] = -0.19;
    const int projectile = world.AddBody(ball);
    for (int k = 0; k < 20; ++k) {
      world.Step(h);
      EXPECT_GT((world.state(projectile).p_WB - world.state(top).p_WB).norm(), 0.2 - 1e-3)
          << pendulum << " " << k;
    }
  }
}

TEST(ImpactSolver, AnImpactJustAboveTheRestingSpeedDoesNotPenetrate) {
  // One to two times the velocity that gravity adds in a step: an impact for a body in
  // free flight, but not for a constrained one.
  const double h = 1.0 / 240;
  for (const double fast : {1.05, 1.1, 1.25, 1.5, 1.9}) {
    World world(OnEarth());
    AddFloor(0, world);
    const int lower = world.AddBody(Ball(0, 0));
    for (int k = 0; k < 5; ++k) world.Step(h);
    BodyDefinition ball = Ball(0.2 + 1e-6, 0);
    ball.state.v_WB[1] = -fast * kGravity * h;
    const int upper = world.AddBody(ball);
    for (int k = 0; k < 60; ++k) {
      world.Step(h);
      EXPECT_GT(world.state(upper).p_WB[1] - world.state(lower).p_WB[1],
                0.2 - 3 * kGravity * h * h)
          << fast << " " << k;
    }
  }
}

TEST(ImpactSolver, AnImpactOnARestingBoxInvolvesItsIsland) {
  World world(OnEarth());
  AddFloor(0, world);
  BodyDefinition box;
  box.shape = Box{{0.5, 0.3, 0.4}};
  box.restitution = 0;
  box.state.p_WB = {0.17, 0.3, -0.31};
  const int lower = world.AddBody(box);
  box.state.p_WB[1] = 0.9;
  const int upper = world.AddBody(box);
  const int ball = world.AddBody(Ball(1.2 + 0.8, 0));
  const double start = kGravity * (0.3 + 0.9 + 2.1);
  double least = start;
  for (int k = 0; k < 200; ++k) {
    world.Step(1e-2);
    double energy = 0;
    for (const int i : {lower, upper, ball}) {
      energy += kGravity * world.state(i).p_WB[1] + world.state(i).v_WB.squaredNorm() / 2;
    }
    EXPECT_LT(energy, least + 1e-9 * start) << k;
    least = std::min(least, energy);
    // The displacement by gravity in a step may remain as penetration.
    EXPECT_GT(world.state(ball).p_WB[1] - world.state(upper).p_WB[1], 0.4 - 2e-3) << k;
  }
  EXPECT_NEAR(world.state(ball).p_WB[1], 1.3, 4e-3);
  EXPECT_NEAR(world.state(lower).p_WB[1], 0.3, 2e-3);
}

TEST(ImpactSolver, ReportedImpulsesSumToTheChangeOfMomentum) {
  for (const double e : {0.0, 0.7}) {
    World world(OnEarth());
    AddFloor(e, world);
    const int ball = world.AddBody(Ball(0.5, e));
    const double h = 1.3e-2;
    std::vector<ContactImpulse> impulses;
    bool hit = false;
    for (int k = 0; k < 100; ++k) {
      const Eigen::Vector3d before = world.state(ball).v_WB;
      world.Step(h);
      impulses.clear();
      world.AppendContactImpulses(impulses);
      Eigen::Vector3d given(0, -kGravity * h, 0);
      for (const ContactImpulse& impulse : impulses) {
        given += impulse.B == ball ? impulse.J_B_W : -impulse.J_B_W;
        hit = hit || impulse.J_B_W.norm() > 1;
      }
      EXPECT_LT((world.state(ball).v_WB - before - given).norm(), 1e-12) << k;
    }
    EXPECT_TRUE(hit);
  }
}

TEST(ImpactSolver, WithoutContinuousCollisionABallPenetratesBeforeItBounces) {
  Settings settings = OnEarth();
  settings.continuous_collision = false;
  World world(settings);
  AddGround(1, world);
  const int ball = world.AddBody(Ball(0.5, 1));
  double deepest = 0;
  for (int k = 0; k < 100; ++k) {
    world.Step(1e-2);
    deepest = std::min(deepest, world.state(ball).p_WB[1] - 0.1);
  }
  EXPECT_LT(deepest, -1e-3);
}

/** Returns how far a ball moves that hits a stack of `plates` at 60 m/s, 1 m per step, in
 a world with `others` boxes at rest elsewhere. [m] */
double DistanceIntoPlates(int plates, int others) {
  World world(OnEarth());
  AddGround(0, world);
  BodyDefinition box;
  box.shape = Box{{0.5, 0.5, 0.5}};
  for (int k = 0; k < others; ++k) {
    box.state.p_WB = {1000 + 3.0 * (k % 20), 0.5, 3.0 * std::floor(k / 20.0)};
    world.AddBody(box);
  }
  box.shape = Box{{0.02, 0.2, 1}};
  box.mass = 5;
  for (int k = 0; k < plates; ++k) {
    box.state.p_WB = {0, 0.2 + 0.4 * k, 0};
    world.AddBody(box);
  }
  for (int k = 0; k < 10; ++k) world.Step(1.0 / 60);
  BodyDefinition ball = Ball(0, 0.5);
  ball.mass = 0.2;
  ball.state.p_WB = {-1, 0.2, 0.1};
  ball.state.v_WB = {60, 0, 0};
  const int thrown = world.AddBody(ball);
  for (int k = 0; k < 6; ++k) world.Step(1.0 / 60);
  return world.state(thrown).p_WB.x() + 1;
}

TEST(ImpactSolver, ABallDoesNotTunnelThroughAStackInAnyNumberOfBodies) {
  for (const int others : {0, 120})
    EXPECT_LT(DistanceIntoPlates(10, others), 1.5) << others;
}

// An iteration of projected Gauss-Seidel passes the momentum of the ball on through a
// plate by a share of about the mass ratio, 1 : 100. The small budgets, with which a step
// may take 31 times as many iterations × contacts, need IterationAcceleration.
TEST(ImpactSolver, AHeavyBallIsStoppedByLightPlatesInOneStep) {
  for (const auto& [plates, budget] : {std::pair(1, 100), std::pair(4, 1500)}) {
    Settings settings = OnEarth();
    settings.iteration_budget = budget;
    World world(settings);
    AddGround(0, world);
    BodyDefinition plate;
    plate.shape = Box{{0.3, 0.01, 0.3}};
    plate.mass = 0.5;
    plate.restitution = 0;
    for (int k = 0; k < plates; ++k) {
      plate.state.p_WB = {0.01 * k, 0.01 + 0.02 * k, -0.013 * k};
      world.AddBody(plate);
    }
    BodyDefinition ball = Ball(0.02 * plates + 0.3, 0);
    ball.mass = 50;
    ball.state.p_WB.x() = 0.04;
    ball.state.p_WB.z() = 0.03;
    const int fallen = world.AddBody(ball);
    const double h = 1.0 / 480;
    // It falls at 2.43 m/s in the step of the impact.
    double before = 0;
    for (int k = 0; k < 480 && world.state(fallen).v_WB.y() <= before; ++k) {
      before = world.state(fallen).v_WB.y();
      world.Step(h);
    }
    ASSERT_LT(before, -2.3);
    for (int i = 1; i < world.body_count(); ++i) {
      // Gravity after the impact may add g h.
      EXPECT_GT(world.state(i).v_WB.y(), -kGravity * h * (1 + 1e-6))
          << plates << ' ' << i;
    }
  }
}

TEST(ImpactSolver, AThinBarThatTurnsIntoAWallStaysInItsPlane) {
  for (const double restitution : {0.5, 1.0}) {
    for (const double x : {-0.35, -0.4}) {
      Settings settings;
      settings.gravity_W.setZero();
      World world(settings);
      BodyDefinition wall;
      wall.shape = Box{{0.1, 2, 2}};
      wall.state.p_WB = {0.1, 0, 0};
      wall.mass = 0;
      wall.restitution = restitution;
      world.AddBody(wall);
      BodyDefinition bar;
      bar.shape = Box{{0.5, 0.01, 0.01}};
      bar.state.p_WB = {x, 0, 0};
      bar.state.q_WB = Eigen::AngleAxisd(std::numbers::pi / 2, Eigen::Vector3d::UnitZ());
      bar.state.w_WB = {0, 0, 10};
      bar.restitution = restitution;
      const int turning = world.AddBody(bar);
      for (int k = 0; k < 120; ++k) world.Step(1.0 / 240);
      const BodyState& end = world.state(turning);
      EXPECT_GT(std::abs(end.v_WB.x()), 0.1);
      EXPECT_LT(std::abs(end.v_WB.z()), 1e-9) << restitution << ' ' << x;
      EXPECT_LT(end.w_WB.head<2>().norm(), 1e-9) << restitution << ' ' << x;
    }
  }
}

}  // namespace
}  // namespace cookbook
