#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "engine/dynamics/world/world.h"

namespace cookbook {
namespace {

constexpr int kBoxes = 5;
constexpr int kSteps = 160;

void BuildStack(World& world, const Eigen::Vector3d& origin) {
  BodyDefinition floor;
  floor.shape = Box{{10, 1, 10}};
  floor.state.p_WB = origin + Eigen::Vector3d(0, -1, 0);
  floor.mass = 0;
  world.AddBody(floor);
  for (int i = 0; i < kBoxes; ++i) {
    BodyDefinition box;
    box.shape = Box{{0.5, 0.5, 0.5}};
    box.restitution = 0;
    box.friction = 0.3;
    box.state.p_WB = origin + Eigen::Vector3d(0.1, 0.5 + i, -0.2);
    world.AddBody(box);
  }
}

void AddFloor(World& world) {
  BodyDefinition floor;
  floor.shape = HalfSpace{};
  floor.state.q_WB = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(),
                                                        Eigen::Vector3d::UnitY());
  floor.mass = 0;
  world.AddBody(floor);
}

/** Puts a box of 1 kg on the floor and one of `mass` on it; returns the upper one. */
int AddHeavyOnLight(World& world, double x, double mass) {
  BodyDefinition box;
  box.shape = Box{{0.5, 0.5, 0.5}};
  box.restitution = 0;
  box.state.p_WB = {x, 0.5, -0.2};
  world.AddBody(box);
  box.mass = mass;
  box.state.p_WB.y() = 1.5;
  return world.AddBody(box);
}

/** Expects `body` to be slower, during eight steps, than `fraction` of the speed that
 gravity adds in a step. */
void ExpectToRest(World& world, int body, double fraction) {
  for (int k = 0; k < 8; ++k) {
    world.Step(1.0 / 240);
    EXPECT_LT(world.state(body).v_WB.norm(), fraction * 9.82 / 240) << k;
  }
}

// The first step has no impulses for warm starting; a body that it leaves moving would
// move for some steps. Iterations reduce the error of a heavy box on a light one by a
// factor near 1.
TEST(Stack, AHeavyBoxOnALightOneRestsFromTheFirstStep) {
  Settings settings;
  settings.iteration_budget = 40000;
  World world(settings);
  AddFloor(world);
  const int heavy = AddHeavyOnLight(world, 0.1, 100);
  ExpectToRest(world, heavy, 1e-12);
}

TEST(Stack, AHeavyBoxAddedLaterRestsFromItsFirstStep) {
  World world{Settings()};
  AddFloor(world);
  const int early = AddHeavyOnLight(world, 50, 30);
  ExpectToRest(world, early, 1e-11);
  for (int k = 0; k < 100; ++k) world.Step(1.0 / 240);
  const int late = AddHeavyOnLight(world, 0.1, 30);
  ExpectToRest(world, late, 1e-11);
}

// A spring or rod elsewhere needs few iterations. The contacts must not be solved less
// accurately because of it.
TEST(Stack, AHeavyBoxOnALightOneRestsInAWorldWithARodOrASpring) {
  for (const bool rod : {false, true}) {
    World world{Settings()};
    AddFloor(world);
    const int heavy = AddHeavyOnLight(world, 0.1, 30);
    BodyDefinition bob;
    bob.shape = Point{};
    bob.state.p_WB = {20, 5, 0};
    const int hangs = world.AddBody(bob);
    const Anchor above{-1, {20, 6, 0}};
    if (rod) {
      world.AddJoint({above, {hangs, {0, 0, 0}}, 1});
    } else {
      world.AddSpring({above, {hangs, {0, 0, 0}}, 100, 0, 1});
    }
    ExpectToRest(world, heavy, 1e-11);
  }
}

// The friction impulses of four contacts can balance each other. That has no effect on
// the bodies until a contact needs its friction for the load.
TEST(Stack, AFaceThatSticksHasNoInternalFriction) {
  World world{Settings()};
  AddFloor(world);
  AddHeavyOnLight(world, 0.1, 30);
  for (int k = 0; k < 2; ++k) world.Step(1.0 / 240);
  std::vector<ContactImpulse> impulses;
  world.AppendContactImpulses(impulses);
  ASSERT_EQ(impulses.size(), 8u);
  for (const ContactImpulse& contact : impulses) {
    const double load = contact.J_B_W.dot(contact.n_AB_W);
    const Eigen::Vector3d friction = contact.J_B_W - load * contact.n_AB_W;
    EXPECT_LT(friction.norm(), 1e-11 * load);
  }
}

// Flush faces keep their four contacts, whichever way rounding moves their corners.
// Otherwise the sway of a stack would depend on which contacts rounding removes.
TEST(Stack, IsTranslationInvariant) {
  Settings settings;
  settings.iteration_budget = 40000;  // Solved to rounding.
  World here(settings);
  BuildStack(here, Eigen::Vector3d::Zero());
  for (int k = 0; k < kSteps; ++k) here.Step(1.0 / 240);
  // A step rounds each coordinate a few times; coordinates are at most 12 m.
  const double bound = 64 * kSteps * 12 * 0x1p-53;
  for (const double distance : {1.0, 3.7, -2.3, 5.5, 0.123}) {
    const Eigen::Vector3d origin = distance * Eigen::Vector3d(1, 0.3, -0.6);
    World there(settings);
    BuildStack(there, origin);
    for (int k = 0; k < kSteps; ++k) there.Step(1.0 / 240);
    double worst = 0;
    for (int i = 1; i <= kBoxes; ++i) {
      const Eigen::Vector3d moved = there.state(i).p_WB - origin - here.state(i).p_WB;
      worst = std::max(worst, moved.norm());
    }
    EXPECT_LT(worst, bound) << distance;
  }
}

}  // namespace
}  // namespace cookbook
