#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "engine/dynamics/world/world.h"

namespace cookbook {
namespace {

constexpr int kBoxes = 5;
constexpr int kSteps = 160;

void Build(World& world, const Eigen::Vector3d& place) {
  BodyDefinition floor;
  floor.shape = Box{{10, 1, 10}};
  floor.state.p_WB = place + Eigen::Vector3d(0, -1, 0);
  floor.mass = 0;
  world.AddBody(floor);
  for (int i = 0; i < kBoxes; ++i) {
    BodyDefinition box;
    box.shape = Box{{0.5, 0.5, 0.5}};
    box.restitution = 0;
    box.friction = 0.3;
    box.state.p_WB = place + Eigen::Vector3d(0.1, 0.5 + i, -0.2);
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

/** Expects `body` to rest for eight steps, but for a share of what gravity adds in one.
 */
void ExpectToRest(World& world, int body, double share) {
  for (int k = 0; k < 8; ++k) {
    world.Step(1.0 / 240);
    EXPECT_LT(world.state(body).v_WB.norm(), share * 9.82 / 240) << k;
  }
}

// A first step has no impulses to start from; what it leaves moving would stay so for
// some steps. Sweeps leave ρ of the error of a heavy box on a light one, ρ near 1.
TEST(Stack, AHeavyBoxOnALightOneRestsFromTheFirstStep) {
  Settings settings;
  settings.iteration_budget = 40000;
  World world(settings);
  AddFloor(world);
  const int heavy = AddHeavyOnLight(world, 0.1, 100);
  ExpectToRest(world, heavy, 1e-12);
}

TEST(Stack, AHeavyBoxThatComesLaterRestsFromItsFirstStepToo) {
  World world{Settings()};
  AddFloor(world);
  const int early = AddHeavyOnLight(world, 50, 30);
  ExpectToRest(world, early, 1e-11);
  for (int k = 0; k < 100; ++k) world.Step(1.0 / 240);
  const int late = AddHeavyOnLight(world, 0.1, 30);
  ExpectToRest(world, late, 1e-11);
}

// What a spring or a rod needs elsewhere is little, and no reason for contacts to be
// solved less.
TEST(Stack, AHeavyBoxOnALightOneRestsAlsoWhereARodOrASpringHoldsSomethingElse) {
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

// Four contacts can load against each other across a face, which nobody sees: until one
// of them needs for the load what it spends on that.
TEST(Stack, AFaceThatHoldsPullsAtNothingAcrossIt) {
  World world{Settings()};
  AddFloor(world);
  AddHeavyOnLight(world, 0.1, 30);
  for (int k = 0; k < 2; ++k) world.Step(1.0 / 240);
  std::vector<ContactImpulse> impulses;
  world.ReadImpulses(impulses);
  ASSERT_EQ(impulses.size(), 8u);
  for (const ContactImpulse& contact : impulses) {
    const double load = contact.J_B_W.dot(contact.n_AB_W);
    const Eigen::Vector3d across = contact.J_B_W - load * contact.n_AB_W;
    EXPECT_LT(across.norm(), 1e-11 * load);
  }
}

// Faces that lie flush keep their four contacts, whichever way rounding moves their
// corners: else a stack would sway by as much as one contact more or less makes of it.
TEST(Stack, StandsTheSameWhereverItIsPut) {
  Settings settings;
  settings.iteration_budget = 40000;  // Solved to rounding.
  World here(settings);
  Build(here, Eigen::Vector3d::Zero());
  for (int k = 0; k < kSteps; ++k) here.Step(1.0 / 240);
  // A step rounds each coordinate, of at most 12 m, a few times.
  const double bound = 64 * kSteps * 12 * 0x1p-53;
  for (const double way : {1.0, 3.7, -2.3, 5.5, 0.123}) {
    const Eigen::Vector3d place = way * Eigen::Vector3d(1, 0.3, -0.6);
    World there(settings);
    Build(there, place);
    for (int k = 0; k < kSteps; ++k) there.Step(1.0 / 240);
    double worst = 0;
    for (int i = 1; i <= kBoxes; ++i) {
      const Eigen::Vector3d moved = there.state(i).p_WB - place - here.state(i).p_WB;
      worst = std::max(worst, moved.norm());
    }
    EXPECT_LT(worst, bound) << way;
  }
}

}  // namespace
}  // namespace cookbook
