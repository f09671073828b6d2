#include "engine/dynamics/world/integrate.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "engine/dynamics/world/world.h"

namespace cookbook {
namespace {

constexpr double kH = 1.0 / 120;

BodyDefinition Cube(const Eigen::Vector3d& p_W) {
  BodyDefinition cube;
  cube.shape = Box{{0.5, 0.5, 0.5}};
  cube.state.p_WB = p_W;
  return cube;
}

void AddFloor(World& world) {
  BodyDefinition floor = Cube({0, -10, 0});
  floor.shape = Box{{1000, 10, 1000}};
  floor.mass = 0;
  world.AddBody(floor);
}

void ExpectNear(const BodyState& a, const BodyState& b, double within) {
  EXPECT_LT((a.p_WB - b.p_WB).norm(), within);
  EXPECT_LT((a.v_WB - b.v_WB).norm(), within);
  EXPECT_LT((a.w_WB - b.w_WB).norm(), within);
  EXPECT_LT((a.q_WB.coeffs() - b.q_WB.coeffs()).norm(), within);
}

/** Simulates the bodies that `add` adds to a world twice: as isotropic bodies, integrated
 four at once, and with moments of inertia that differ by a few roundings, integrated one
 by one. */
template <class Add>
void ExpectIsotropicLikeNearlyIsotropic(int steps, double within, const Add& add) {
  World round;
  World nearly;
  add(round, Eigen::Vector3d(1, 1, 1));
  add(nearly, Eigen::Vector3d(1, 1, 1 + 1e-15));
  for (int k = 0; k < steps; ++k) {
    round.Step(kH);
    nearly.Step(kH);
  }
  ASSERT_EQ(round.body_count(), nearly.body_count());
  for (int i = 0; i < round.body_count(); ++i) {
    SCOPED_TRACE(i);
    ExpectNear(round.state(i), nearly.state(i), within);
  }
}

// Slow rotations, and rotations beyond the series of the exponential map.
TEST(Integrate, IsotropicBodiesRotateLikeNearlyIsotropicOnes) {
  ExpectIsotropicLikeNearlyIsotropic(
      240, 1e-10, [](World& world, const Eigen::Vector3d& moments) {
        for (const double spin : {0.0, 0.3, 7.0, 40.0, 90.0, 2.0}) {
          BodyDefinition cube = Cube({3 * spin, 0, 0});
          cube.inertia = moments / 6;
          cube.state.v_WB = {1, 2, 0.1 * spin};
          cube.state.w_WB = spin * Eigen::Vector3d(0.6, -0.48, 0.64);
          world.AddBody(cube);
        }
      });
}

// Under a torque the axis of rotation changes.
TEST(Integrate, ForcesMoveIsotropicBodiesLikeNearlyIsotropicOnes) {
  World round;
  World nearly;
  for (World* world : {&round, &nearly}) {
    for (int k = 0; k < 5; ++k) {
      BodyDefinition cube = Cube({4.0 * k, 0, 0});
      cube.inertia = Eigen::Vector3d(1, 1, world == &round ? 1 : 1 + 1e-15) / 6;
      cube.state.w_WB = {3, 0.5 * k, 0};
      cube.force_W = {0, 0, 0.2 * k};
      world->AddBody(cube);
    }
  }
  for (int step = 0; step < 120; ++step) {
    for (World* world : {&round, &nearly}) {
      for (int k = 0; k < 5; k += 2) {
        const Eigen::Vector3d p_W = world->state(k).p_WB + Eigen::Vector3d(0, 0.5, 0);
        world->ApplyForce(k, p_W, {0, 0.1, 0.4});
      }
      world->Step(kH);
    }
  }
  for (int k = 0; k < 5; ++k) ExpectNear(round.state(k), nearly.state(k), 1e-10);
  // A force through the centre of mass does not rotate the body.
  EXPECT_EQ(round.state(1).w_WB, Eigen::Vector3d(3, 0.5, 0));
}

TEST(Integrate, AConstantForceRemainsAfterAForceForOneStep) {
  Settings settings;
  settings.gravity_W.setZero();
  World world(settings);
  BodyDefinition cube = Cube({0, 0, 0});
  cube.mass = 2;
  cube.force_W = {3, 0, 0};
  world.AddBody(cube);
  world.Step(kH);
  world.ApplyForce(0, world.state(0).p_WB, {0, 5, 0});
  for (int k = 0; k < 9; ++k) world.Step(kH);
  // v = F t / m, with the duration of each force.
  const Eigen::Vector3d v = kH / 2 * Eigen::Vector3d(10 * 3, 5, 0);
  EXPECT_LT((world.state(0).v_WB - v).norm(), 1e-15);
}

// One velocity exceeds the bound while all other numbers are still moderate.
TEST(Integrate, IsotropicBodiesThatAreTooFastHaveDiverged) {
  Settings settings;
  settings.gravity_W.setZero();
  for (const bool spins : {false, true}) {
    World world(settings);
    for (int k = 0; k < 5; ++k) world.AddBody(Cube({3.0 * k, 0, 0}));
    world.Step(kH);
    ASSERT_FALSE(world.diverged());
    const Eigen::Vector3d p_W = world.state(2).p_WB;
    const Eigen::Vector3d arm(0, 0.5, 0);
    world.ApplyImpulse(2, p_W + arm, {2e12, 0, 0});
    world.ApplyImpulse(2, p_W - arm, {spins ? -2e12 : 2e12, 0, 0});
    world.Step(kH);
    EXPECT_TRUE(world.diverged()) << spins;
  }
}

// Bodies land, slide to rest, and bounce.
TEST(Integrate, IsotropicBodiesLandAndSlideLikeNearlyIsotropicOnes) {
  ExpectIsotropicLikeNearlyIsotropic(
      90, 1e-8, [](World& world, const Eigen::Vector3d& moments) {
        AddFloor(world);
        for (int k = 0; k < 6; ++k) {
          BodyDefinition cube = Cube({4.0 * k, 0.5 + 0.02 * k, 0});
          cube.inertia = moments / 6;
          cube.restitution = 0.1 * k;
          cube.state.v_WB = {1, 0, 0.5};
          world.AddBody(cube);
        }
        BodyDefinition ball = Cube({0, 0.8, 9});
        ball.shape = Sphere{0.5};
        ball.inertia = 0.1 * moments;
        ball.state.v_WB = {2, 0, 0};
        ball.state.w_WB = {0, 3, 0};
        world.AddBody(ball);
      });
}

TEST(Integrate, ABodyMovesByTheSameBitsAloneAndInABatch) {
  const auto thrown = [](int k) {
    BodyDefinition cube = Cube({5.0 * k, 1, 0});
    cube.state.v_WB = {0.1 * k, 3, -1};
    cube.state.w_WB = {1, -0.7 * k, 2};
    return cube;
  };
  for (const int count : {2, 3, 4, 5, 9, 37}) {
    World among;
    for (int k = 0; k < count; ++k) among.AddBody(thrown(k));
    for (int step = 0; step < 60; ++step) among.Step(kH);
    for (const int k : {0, count - 1}) {
      World alone;
      alone.AddBody(thrown(k));
      for (int step = 0; step < 60; ++step) alone.Step(kH);
      ExpectNear(among.state(k), alone.state(0), 0x1p-1074);
    }
  }
}

RigidBody BodyAt(const Eigen::Vector3d& p_W, const BodyShape& shape) {
  BodyDefinition body;
  body.shape = shape;
  body.state.p_WB = p_W;
  return MakeRigidBody(body);
}

TEST(Integrate, PositionCorrectionsReturnTheTravel) {
  const Box plank{{0.2, 0.3, 1}};
  std::vector<RigidBody> bodies;
  std::vector<RigidBody> before;
  std::vector<Velocity> corrections;
  std::vector<int> corrected;
  for (int k = 0; k < 7; ++k) {
    bodies.push_back(k % 2 == 0 ? BodyAt({k + 0.5, 0, 0}, plank)
                                : BodyAt({k + 0.5, 0, 0}, Sphere{0.5}));
    const double angle_of_k =
        k == 6 ? 4 : 0.01 * k;  // Beyond a half turn the travel decreases.
    corrections.push_back({{0, 0.1 * k, 0}, angle_of_k * Eigen::Vector3d(0.6, 0, 0.8)});
    if (k != 3) corrected.push_back(k);
  }
  before = bodies;
  std::vector<double> travel(corrected.size());
  IntegratePositionCorrections(bodies, corrections, corrected, travel);
  for (std::size_t n = 0; n < corrected.size(); ++n) {
    const auto k = static_cast<std::size_t>(corrected[n]);
    SCOPED_TRACE(k);
    const RigidBody& body = bodies[k];
    EXPECT_LT((body.state.p_WB - before[k].state.p_WB - corrections[k].v).norm(), 1e-15);
    const double angle = corrections[k].w.norm();
    const Eigen::Quaterniond turned =
        Eigen::AngleAxisd(angle, Eigen::Vector3d(0.6, 0, 0.8)) * before[k].state.q_WB;
    EXPECT_LT((body.state.q_WB.coeffs() - turned.coeffs()).norm(), 1e-15);
    EXPECT_LT((body.R_WB - turned.toRotationMatrix()).norm(), 1e-15);
    EXPECT_GE(travel[n], Travel(before[k].state, body) - 1e-15);
    if (angle < 3) {
      EXPECT_NEAR(travel[n], Travel(before[k].state, body), 1e-4 * travel[n]);
    }
  }
  EXPECT_EQ(bodies[3].state.p_WB, before[3].state.p_WB);
}

}  // namespace
}  // namespace cookbook
