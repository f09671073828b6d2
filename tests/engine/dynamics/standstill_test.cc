// Heaps that come to rest at once, where each body stands on one other.

#include "engine/dynamics/standstill.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "engine/dynamics/world.h"

namespace cookbook {
namespace {

constexpr double kG = 9.82;
constexpr double kH = 1.0 / 240;

/** Rounding of what a step of gravity makes, of loads of some hundred times a body's. */
constexpr double kRest = 1e-12 * kG * kH;

void AddFloor(World& world) {
  BodyDefinition floor;
  floor.shape = Box{{10, 1, 10}};
  floor.state.p_WB = {0, -1, 0};
  floor.mass = 0;
  floor.friction = 0.6;
  world.AddBody(floor);
}

int AddBox(World& world, const Eigen::Vector3d& p_WB, double mass = 1,
           const Eigen::Vector3d& half_extents = {0.5, 0.5, 0.5}) {
  BodyDefinition box;
  box.shape = Box{half_extents};
  box.restitution = 0;
  box.friction = 0.6;
  box.mass = mass;
  box.state.p_WB = p_WB;
  return world.AddBody(box);
}

double Fastest(const World& world) {
  double fastest = 0;
  for (int i = 1; i < world.body_count(); ++i) {
    fastest = std::max(fastest, world.state(i).v_WB.norm() + world.state(i).w_WB.norm());
  }
  return fastest;
}

void ExpectToRest(World& world, int steps) {
  for (int k = 0; k < steps && !testing::Test::HasFailure(); ++k) {
    world.Step(kH);
    EXPECT_LT(Fastest(world), kRest) << k;
  }
}

/** Impulse and its moment about the centre that the contacts give to a body in a step. */
struct Received {
  Eigen::Vector3d force = Eigen::Vector3d::Zero();
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
};

Received ReceivedBy(const World& world, int body) {
  std::vector<ContactImpulse> impulses;
  world.ReadImpulses(impulses);
  Received received;
  for (const ContactImpulse& contact : impulses) {
    if (contact.A != body && contact.B != body) continue;
    const Eigen::Vector3d J_W = contact.B == body ? contact.J_B_W : -contact.J_B_W;
    received.force += J_W;
    received.moment += (contact.p_WC - world.state(body).p_WB).cross(J_W);
  }
  return received;
}

TEST(Standstill, AStackOfTwentyStandsThoughSweepsWouldNotHoldIt) {
  World world{Settings()};
  AddFloor(world);
  for (int i = 0; i < 20; ++i) {
    AddBox(world, {1e-6 * std::sin(i), 0.5 + i, 1e-6 * std::cos(3.0 * i)});
  }
  ExpectToRest(world, 240);
  for (int i = 1; i <= 20; ++i) {
    EXPECT_NEAR(world.state(i).p_WB.y(), i - 0.5, 1e-12) << i;
  }
}

TEST(Standstill, AThousandfoldLoadRestsFromTheFirstStep) {
  World world{Settings()};
  AddFloor(world);
  AddBox(world, {0, 0.5, 0});
  AddBox(world, {0.1, 1.5, -0.2}, 1000);
  ExpectToRest(world, 20);
}

TEST(Standstill, WhatBranchesRests) {
  World world{Settings()};
  AddFloor(world);
  AddBox(world, {0, 0.5, 0}, 0.1, {3, 0.5, 1});  // A plank with two stacks on it.
  for (int i = 0; i < 6; ++i) {
    AddBox(world, {-2, 1.5 + i, 0}, 1 + i);
    AddBox(world, {1.9, 1.5 + i, 0.1});
  }
  ExpectToRest(world, 20);
}

TEST(Standstill, BodiesReceiveJustWhatGravityTakes) {
  World world{Settings()};
  AddFloor(world);
  // Each a tenth further out, so that none bears its load in the middle.
  for (int i = 0; i < 6; ++i) AddBox(world, {0.05 * i, 0.5 + i, 0.02 * i}, 6 - i);
  ExpectToRest(world, 3);
  for (int i = 1; i <= 6; ++i) {
    const Received received = ReceivedBy(world, i);
    const double weight = (7 - i) * kG * kH;
    EXPECT_LT((received.force - Eigen::Vector3d(0, weight, 0)).norm(), 1e-12) << i;
    EXPECT_LT(received.moment.norm(), 1e-12) << i;
  }
}

TEST(Standstill, ASlopeHoldsWhatItsFrictionHoldsAndNoMore) {
  for (const double steepness : {0.95, 1.05}) {
    Settings settings;
    const double angle = std::atan(0.6 * steepness);
    settings.gravity_W = kG * Eigen::Vector3d(std::sin(angle), -std::cos(angle), 0);
    World world(settings);
    AddFloor(world);
    // A low one on another, that does not tip.
    AddBox(world, {0, 0.1, 0}, 1, {0.5, 0.1, 0.5});
    const int upper = AddBox(world, {0, 0.3, 0}, 1, {0.5, 0.1, 0.5});
    constexpr int kSteps = 48;
    for (int k = 0; k < kSteps; ++k) world.Step(kH);
    // Both slide on the floor, or the upper on the lower.
    const double slides =
        kSteps * kH * kG * std::max(0.0, std::sin(angle) - 0.6 * std::cos(angle));
    if (slides == 0) {
      EXPECT_LT(Fastest(world), kRest);
    } else {
      EXPECT_GT(world.state(upper).v_WB.x(), 0.999 * slides);
    }
  }
}

TEST(Standstill, WhatLeansOutTooFarFalls) {
  World world{Settings()};
  AddFloor(world);
  AddBox(world, {0, 0.5, 0});
  AddBox(world, {0.4, 1.5, 0});
  const int top = AddBox(world, {0.8, 2.5, 0});
  // The two upper ones together are 0.6 m out, a tenth beyond the edge.
  for (int k = 0; k < 240; ++k) world.Step(kH);
  EXPECT_LT(world.state(top).p_WB.y(), 2.4);
}

TEST(Standstill, WhatIsThrownUpIsNotHeld) {
  World world{Settings()};
  AddFloor(world);
  AddBox(world, {0, 0.5, 0});
  const int top = AddBox(world, {0, 1.5, 0});
  world.Step(kH);
  world.ApplyImpulse(top, {0, 1.5, 0}, {0, 1, 0});
  world.Step(kH);
  EXPECT_NEAR(world.state(top).v_WB.y(), 1 - kG * kH, 1e-12);
}

TEST(Standstill, WhatSlidesIsSlowedByItsFrictionAlone) {
  World world{Settings()};
  AddFloor(world);
  AddBox(world, {0, 0.1, 0}, 1, {0.5, 0.1, 0.5});
  const int upper = AddBox(world, {0, 0.3, 0}, 1, {0.5, 0.1, 0.5});
  world.Step(kH);
  world.ApplyImpulse(upper, {0, 0.3, 0}, {1, 0, 0});
  world.Step(kH);
  EXPECT_NEAR(world.state(upper).v_WB.x(), 1 - 0.6 * kG * kH, 1e-3 * kG * kH);
}

}  // namespace
}  // namespace cookbook
