#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "engine/dynamics/world/world.h"

namespace cookbook {
namespace {

TEST(DistanceJoint, APendulumConvergesWithFourthOrderToItsEllipticFunction) {
  // 1 kg on 1 m, g = 9.81, from rest at 90°: θ = 2 asin(k sn(K − √(g/L) t)), IFToMM A01.
  const auto error = [](double h) {
    Settings settings;
    settings.gravity_W = {0, -9.81, 0};
    World world(settings);
    BodyDefinition bob;
    bob.shape = Point{};
    bob.state.p_WB = {1, 0, 0};
    const int body = world.AddBody(bob);
    world.AddJoint({{-1, {0, 0, 0}}, {body, {0, 0, 0}}, 1});
    const int steps = static_cast<int>(std::lround(5 / h));
    for (int k = 0; k < steps; ++k) world.Step(h);
    const Eigen::Vector3d truth(0.942305435044, -0.334754338414, 0);
    return (world.state(body).p_WB - truth).norm();
  };
  const double coarse = error(1e-2);
  EXPECT_LT(coarse, 1e-6);
  EXPECT_NEAR(std::log2(coarse / error(5e-3)), 4, 0.4);
}

TEST(DistanceJoint, AChainAtRestHasTheShapeOfItsDiscreteCatenary) {
  // n links of length L and n − 1 masses m over the span D: tan θᵢ = (i − (n−1)/2) m g/H
  // and Σ L cos θᵢ = D, which for these numbers gives H and the sag below.
  const int n = 10;
  const double sag = 0.365545036;
  Settings settings;
  settings.gravity_W = {0, -9.81, 0};
  World world(settings);
  // At the start the chain hangs from both ends in the shape of a V.
  const double half = 0.5 * n * 0.1;
  const double drop = std::sqrt(half * half - 0.3 * 0.3);
  int last = -1;
  Eigen::Vector3d last_point(0, 0, 0);
  for (int i = 1; i < n; ++i) {
    const double along = 0.1 * i;
    const double t = std::min(along, 2 * half - along) / half;
    BodyDefinition bead;
    bead.shape = Point{};
    bead.mass = 0.05;
    bead.drag = 4;
    bead.state.p_WB = {along < half ? 0.3 * t : 0.6 - 0.3 * t, -drop * t, 0};
    const int here = world.AddBody(bead);
    world.AddJoint({{last, last_point}, {here, {0, 0, 0}}, 0.1});
    last = here;
    last_point.setZero();
  }
  world.AddJoint({{last, {0, 0, 0}}, {-1, {0.6, 0, 0}}, 0.1});
  for (int k = 0; k < 2400; ++k) world.Step(1.0 / 240);
  // With an even number of links the lowest bead is in the middle. The reference value
  // has nine digits.
  EXPECT_NEAR(-world.state(n / 2 - 1).p_WB[1], sag, 1e-9);
}

TEST(DistanceJoint, ARodOffItsLengthIsRestoredWithoutVelocity) {
  World world({});
  BodyDefinition ball;
  ball.shape = Sphere{0.1};
  const int a = world.AddBody(ball);
  ball.state.p_WB = {1.02, 0, 0};
  const int b = world.AddBody(ball);
  world.AddJoint({{a, {0, 0, 0}}, {b, {0, 0, 0}}, 1});
  double fastest = 0;
  for (int k = 0; k < 100; ++k) {
    world.Step(0.01);
    fastest = std::max(fastest, world.state(b).v_WB.norm());
  }
  EXPECT_NEAR(world.state(b).p_WB.x() - world.state(a).p_WB.x(), 1, 1e-14);
  // Each step may leave the length off by a rounding, which the velocities see over h.
  EXPECT_LT(fastest, 1e-13);
}

TEST(DistanceJoint, APointAndABoxOnARodConserveMomentum) {
  Settings settings;
  settings.gravity_W.setZero();
  World world(settings);
  BodyDefinition light;
  light.shape = Point{};
  light.state.p_WB = {0.2, 0.1, -0.3};
  light.state.v_WB = {0, 3, 0};
  world.AddBody(light);
  BodyDefinition heavy;
  heavy.shape = Box{{0.1, 0.2, 0.1}};
  heavy.mass = 5;
  heavy.state.p_WB = {1.2, 0.1, -0.3};
  world.AddBody(heavy);
  world.AddJoint({{0, {0, 0, 0}}, {1, {-0.1, 0, 0}}, 0.9});
  for (int k = 0; k < 240; ++k) world.Step(1.0 / 240);
  const Eigen::Vector3d P = world.state(0).v_WB + 5 * world.state(1).v_WB;
  EXPECT_LT((P - Eigen::Vector3d(0, 3, 0)).norm(), 1e-12);
  const Eigen::Vector3d d = world.state(1).p_WB +
                            world.state(1).q_WB * Eigen::Vector3d(-0.1, 0, 0) -
                            world.state(0).p_WB;
  EXPECT_NEAR(d.norm(), 0.9, 1e-13);
}

}  // namespace
}  // namespace cookbook
