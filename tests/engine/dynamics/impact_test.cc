#include <cmath>

#include <gtest/gtest.h>

#include "engine/dynamics/world.h"

namespace cookbook {
namespace {

BodyDefinition Floor() {
  BodyDefinition floor;
  floor.shape = Box{{20, 1, 20}};
  floor.state.p_WB = {0, -1, 0};
  floor.mass = 0;
  floor.restitution = 1;
  return floor;
}

TEST(Impact, ABallThatBouncesPerfectlyKeepsItsEnergyAtAnyStep) {
  for (const double h : {1e-4, 1e-3, 4e-3, 1e-2, 4e-2}) {
    Settings settings;
    settings.gravity_W = {0, -9.81, 0};
    World world(settings);
    world.AddBody(Floor());
    BodyDefinition ball;
    ball.shape = Sphere{0.1};
    ball.mass = 10;
    ball.restitution = 1;
    ball.friction = 0;
    ball.state.p_WB = {0, 5, 0};
    const int body = world.AddBody(ball);
    const double start = 10 * 9.81 * 5;
    double worst = 0;
    const int steps = static_cast<int>(20 / h);
    for (int k = 0; k < steps; ++k) {
      world.Step(h);
      const BodyState& state = world.state(body);
      const double energy = 10 * (9.81 * state.p_WB[1] + state.v_WB.squaredNorm() / 2);
      worst = std::max(worst, std::abs(energy - start));
    }
    EXPECT_LT(worst, 16 * steps * start * 0x1p-53) << h;
  }
}

TEST(Impact, ABoxThatLandsFlatBouncesByItsRestitution) {
  World world;
  world.AddBody(Floor());
  BodyDefinition box;
  box.shape = Box{{0.5, 0.3, 0.4}};
  box.restitution = 0.5;
  box.state.p_WB = {0, 0.3, 0};
  box.state.v_WB = {0, -4, 0};
  const int body = world.AddBody(box);
  const double h = 1e-3;
  world.Step(h);
  EXPECT_NEAR(world.state(body).v_WB[1], 2 - 9.82 * h, 1e-12);
  EXPECT_LT(world.state(body).w_WB.norm(), 1e-12);
}

}  // namespace
}  // namespace cookbook
