#include <algorithm>

#include <gtest/gtest.h>

#include "engine/dynamics/world.h"

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

// A first step has no impulses to start from; what it leaves moving would stay so for
// some steps. Sweeps leave ρ of the error of a heavy box on a light one, ρ near 1.
TEST(Stack, AHeavyBoxOnALightOneRestsFromTheFirstStep) {
  Settings settings;
  settings.patience = 40000;
  World world(settings);
  BodyDefinition floor;
  floor.shape = HalfSpace{};
  floor.state.q_WB = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(),
                                                        Eigen::Vector3d::UnitY());
  floor.mass = 0;
  world.AddBody(floor);
  BodyDefinition box;
  box.shape = Box{{0.5, 0.5, 0.5}};
  box.restitution = 0;
  for (const double mass : {1.0, 100.0}) {
    box.mass = mass;
    box.state.p_WB = {0.1, 0.5 + (mass > 1), -0.2};
    world.AddBody(box);
  }
  for (int k = 0; k < 8; ++k) {
    world.Step(1.0 / 240);
    // What gravity adds in a step, solved to rounding.
    EXPECT_LT(world.state(2).v_WB.norm(), 1e-12 * 9.82 / 240) << k;
  }
}

// Faces that lie flush keep their four contacts, whichever way rounding moves their
// corners: else a stack would sway by as much as one contact more or less makes of it.
TEST(Stack, StandsTheSameWhereverItIsPut) {
  Settings settings;
  settings.patience = 40000;  // Solved to rounding.
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
