#include "engine/dynamics/contacts/seams.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "engine/dynamics/world/world.h"

namespace cookbook {
namespace {

constexpr int kCubes = 6;

/** Puts up a floor of static cubes of 1 m in rows along x and z, with its top at y = 0.
 */
void AddFloor(World& world, int rows = 1) {
  for (int i = 0; i < kCubes; ++i) {
    for (int k = 0; k < rows; ++k) {
      BodyDefinition cube;
      cube.shape = Box{{0.5, 0.5, 0.5}};
      cube.mass = 0;
      cube.restitution = 0;
      cube.friction = 1;
      cube.state.p_WB = {i + 0.5, -0.5, k + 0.5};
      world.AddBody(cube);
    }
  }
}

/** How a body has moved over the floor. */
struct Ride {
  double lift = 0;  ///< Greatest change of height. [m]
  double loss = 0;  ///< Greatest change of speed, as a fraction.
};

/** Moves `body` over most of the floor, from x = 1 m at `speed`. */
Ride RideOf(World& world, int body, double speed, double h) {
  Ride ride;
  const double height = world.state(body).p_WB.y();
  while (world.state(body).p_WB.x() < kCubes - 1.5) {
    const double before = world.state(body).p_WB.x();
    world.Step(h);
    const BodyState& now = world.state(body);
    ride.lift = std::max(ride.lift, std::abs(now.p_WB.y() - height));
    ride.loss = std::max(ride.loss, std::abs(now.v_WB.x() - speed) / speed);
    if (now.p_WB.x() <= before) {
      ADD_FAILURE() << "stopped at x = " << before << " m";
      break;
    }
  }
  return ride;
}

/** A time step and a speed at which bodies move over the floor. */
struct Case {
  double h;      ///< [s]
  double speed;  ///< [m/s]
};

constexpr std::array<Case, 6> kCases = {{{1.0 / 60, 0.7},
                                         {1.0 / 60, 2},
                                         {1.0 / 60, 9},
                                         {1.0 / 240, 2},
                                         {1.0 / 240, 9},
                                         {1e-3, 9}}};

TEST(Seams, DoNotLiftABallThatRolls) {
  for (const auto& [h, speed] : kCases) {
    for (const double z : {0.5, 1.0, 0.93}) {
      World world{Settings()};
      AddFloor(world, 2);
      BodyDefinition ball;
      ball.shape = Sphere{0.3};
      ball.restitution = 0;
      ball.friction = 1;
      ball.state.p_WB = {1, 0.3, z};
      ball.state.v_WB = {speed, 0, 0};
      ball.state.w_WB = {0, 0, -speed / 0.3};
      const Ride ride = RideOf(world, world.AddBody(ball), speed, h);
      EXPECT_LE(ride.lift, 1e-4 * 0.3) << h << ' ' << speed << ' ' << z;
      EXPECT_LE(ride.loss, 1e-4) << h << ' ' << speed << ' ' << z;
    }
  }
}

// Springs of contacts let a box sink as its load moves from cube to cube, at most by the
// depth that position correction leaves, 2 g h². Its normals then are tilted by as
// little.
TEST(Seams, DoNotStopABoxThatSlides) {
  for (const auto& [h, speed] : kCases) {
    for (const double yaw : {0.0, 0.4}) {
      World world{Settings()};
      AddFloor(world, 2);
      BodyDefinition box;
      box.shape = Box{{0.3, 0.1, 0.2}};
      box.restitution = 0;
      box.friction = 0;
      box.state.p_WB = {1, 0.1, 0.95};
      box.state.q_WB = Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitY());
      box.state.v_WB = {speed, 0, 0};
      const Ride ride = RideOf(world, world.AddBody(box), speed, h);
      EXPECT_LE(ride.lift, std::max(1e-4 * 0.6, 2 * 9.82 * h * h)) << h << ' ' << speed;
      EXPECT_LE(ride.loss, 5e-4) << h << ' ' << speed << ' ' << yaw;
    }
  }
}

TEST(Seams, DoNotLiftARowOfBallsOnRods) {
  for (const auto& [h, speed] : kCases) {
    World world{Settings()};
    AddFloor(world);
    std::vector<int> balls;
    for (int i = 0; i < 3; ++i) {
      BodyDefinition ball;
      ball.shape = Sphere{0.1};
      ball.restitution = 0;
      ball.friction = 0;
      ball.state.p_WB = {1 + 0.2 * i, 0.1, 0.5};
      ball.state.v_WB = {speed, 0, 0};
      balls.push_back(world.AddBody(ball));
    }
    for (const auto& [a, b] : {std::pair(0, 1), {1, 2}}) {
      DistanceJoint rod;
      rod.A.body = balls[static_cast<std::size_t>(a)];
      rod.B.body = balls[static_cast<std::size_t>(b)];
      rod.length = 0.2;
      world.AddJoint(rod);
    }
    const Ride ride = RideOf(world, balls[1], speed, h);
    EXPECT_LE(ride.lift, 1e-4 * 0.1) << h << ' ' << speed;
    EXPECT_LE(ride.loss, 1e-4) << h << ' ' << speed;
  }
}

// The upper cube of a step is no seam, and neither is the wall that a floor meets.
TEST(Seams, AreNoStepsAndNoWalls) {
  for (const double rise : {1e-3, 0.05, 1.0}) {
    World world{Settings()};
    AddFloor(world);
    BodyDefinition step;
    step.shape = Box{{0.5, 0.5, 0.5}};
    step.mass = 0;
    step.restitution = 0;
    step.state.p_WB = {0.5 * kCubes + 0.5, rise - 0.5, 0.5};
    world.AddBody(step);
    BodyDefinition box;
    box.shape = Box{{0.3, 0.1, 0.2}};
    box.restitution = 0;
    box.friction = 0;
    box.state.p_WB = {0.5 * kCubes - 1, 0.1, 0.5};
    box.state.v_WB = {1, 0, 0};
    const int sliding = world.AddBody(box);
    for (int i = 0; i < 240; ++i) world.Step(1.0 / 120);
    EXPECT_LE(world.state(sliding).p_WB.x() + 0.3, 0.5 * kCubes + 1e-3) << rise;
  }
}

BodyDefinition StaticBox(const Eigen::Vector3d& half, const Eigen::Vector3d& p_W) {
  BodyDefinition box;
  box.shape = Box{half};
  box.mass = 0;
  box.state.p_WB = p_W;
  return box;
}

// The ball lies in the floor, and its contact with the wall too. But the wall goes on
// above the floor, which alone would not keep the ball out of it.
TEST(Seams, AreNoWallsThatAreSunkIntoAFloor) {
  BodyDefinition ball;
  ball.shape = Sphere{0.3};
  ball.state.p_WB = {0.2, -0.05, 0};
  const std::vector<RigidBody> bodies = {
      MakeRigidBody(StaticBox({5, 0.5, 5}, {0, -0.5, 0})),  // The floor, up to y = 0.
      MakeRigidBody(StaticBox({0.5, 2, 5}, {-0.5, 0, 0})),  // The wall, up to x = 0.
      MakeRigidBody(ball)};
  ContactCache cache;
  for (const RigidBody& body : bodies) cache.Add(body);
  ThreadPool pool(1);
  cache.Update(bodies, {0.001, true}, 0, pool);
  Seams seams;
  seams.RemoveContacts(bodies, cache);
  ASSERT_EQ(cache.summaries().size(), 2U);
  for (const PairSummary& pair : cache.summaries()) EXPECT_EQ(pair.count, 1);
}

// Inside a corner of two boxes that reach into each other, each holds the ball.
TEST(Seams, AreNoCornersOfBoxesThatOverlap) {
  World world{Settings()};
  for (const Eigen::Vector3d& half :
       {Eigen::Vector3d(3, 0.5, 3), Eigen::Vector3d(0.5, 3, 3)}) {
    BodyDefinition box;
    box.shape = Box{half};
    box.mass = 0;
    box.restitution = 0;
    world.AddBody(box);
  }
  BodyDefinition ball;
  ball.shape = Sphere{0.3};
  ball.restitution = 0;
  ball.friction = 0;
  ball.state.p_WB = {2, 1, 0};
  ball.state.v_WB = {-3, 0, 0};
  const int rolling = world.AddBody(ball);
  for (int i = 0; i < 240; ++i) world.Step(1.0 / 120);
  EXPECT_NEAR(world.state(rolling).p_WB.x(), 0.8, 1e-3);
  EXPECT_NEAR(world.state(rolling).p_WB.y(), 0.8, 1e-3);
}

}  // namespace
}  // namespace cookbook
