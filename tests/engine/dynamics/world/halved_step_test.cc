// Steps of a world with an impact of a linkage are halved. What else there is in the
// world does not notice.

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "engine/dynamics/world/world.h"

namespace cookbook {
namespace {

using Eigen::Vector3d;

constexpr double kG = 9.82;
constexpr double kH = 1.0 / 60;

int AddBody(World& world, const BodyShape& shape, const Vector3d& p_WB, double mass) {
  BodyDefinition body;
  body.shape = shape;
  body.state.p_WB = p_WB;
  body.mass = mass;
  body.restitution = 0;
  body.friction = 0.6;
  return world.AddBody(body);
}

/** A world with a floor at y = 0 and two balls on a rod above it, 100 m away. */
struct Landing {
  explicit Landing(const Settings& settings = Settings()) : world(settings) {
    floor = AddBody(world, Box{{200, 1, 200}}, {0, -1, 0}, 0);
  }

  /** Adds the linkage. It reaches the floor with 30 m/s, half a metre in a step, after
   `steps`. */
  void AddLinkage(int steps) {
    const double height = 0.05 + 30 * (steps + 0.5) * kH;
    std::vector<int> balls;
    for (const double x : {100.0, 101.0}) {
      BodyDefinition ball;
      ball.shape = Sphere{0.05};
      ball.restitution = 0.5;
      ball.state.p_WB = {x, height, 0};
      ball.state.v_WB = {0, -30 + 0.5 * kG * steps * kH, 0};
      balls.push_back(world.AddBody(ball));
    }
    world.AddJoint({{balls[0], {0, 0, 0}}, {balls[1], {0, 0, 0}}, 1});
  }

  /** Takes a step. Returns whether it was halved: the contacts of `resting` with the
   floor then are reported for each of its parts. */
  bool StepIsHalved(int resting) {
    world.Step(kH);
    std::vector<ContactImpulse> impulses;
    world.AppendContactImpulses(impulses);
    int contacts = 0;
    for (const ContactImpulse& contact : impulses)
      contacts +=
          std::minmax(contact.A, contact.B) == std::minmax(floor, resting) ? 1 : 0;
    return contacts > 4;
  }

  World world;
  int floor = 0;
};

// The impulses of the last step are twice those of half a step, and so are the mean loads
// to which contacts do not yield. Iterations alone would need many steps to find them
// again.
TEST(HalvedStep, LeavesAStackAtRestWhereItIs) {
  constexpr int kSteps = 60;
  Settings settings;
  settings.static_equilibrium = false;
  Landing landing(settings);
  std::vector<int> boxes;
  boxes.reserve(3);
  for (int i = 0; i < 3; ++i) {
    boxes.push_back(
        AddBody(landing.world, Box{{0.3, 0.2, 0.4}}, {0.02 * i, 0.2 + 0.4 * i, 0}, 3));
  }
  landing.AddLinkage(kSteps);
  int halved = 0;
  double before = 0;
  for (int step = 0; step < kSteps + 10; ++step) {
    double fastest = 0;
    const bool is_halved = landing.StepIsHalved(boxes[0]);
    for (const int box : boxes)
      fastest = std::max(fastest, landing.world.state(box).v_WB.norm());
    // The iterations leave as much in the steps before it.
    if (is_halved) {
      EXPECT_LT(fastest, 2 * before + 1e-12 * kG * kH) << step;
    }
    before = fastest;
    halved += is_halved ? 1 : 0;
  }
  EXPECT_GT(halved, 0);
}

// The slop of a step of h is 2 g h² and more. In a part of it, that of the part would be
// less than the depth, and the box would be lifted.
TEST(HalvedStep, KeepsTheSlopOfTheWholeStep) {
  constexpr int kSteps = 30;
  Landing landing;
  const double depth = 0.9 * 2 * kG * kH * kH;
  const int box = AddBody(landing.world, Box{{0.3, 0.2, 0.4}}, {0, 0.2 - depth, 0}, 3);
  landing.AddLinkage(kSteps);
  int halved = 0;
  for (int step = 0; step < kSteps + 10; ++step) {
    halved += landing.StepIsHalved(box) ? 1 : 0;
    EXPECT_NEAR(landing.world.state(box).p_WB.y(), 0.2 - depth, 1e-14) << step;
  }
  EXPECT_GT(halved, 0);
}

// A spring conserves energy in steps of any length.
TEST(HalvedStep, ASpringKeepsItsEnergy) {
  constexpr int kSteps = 30;
  Landing landing;
  const int box = AddBody(landing.world, Box{{0.3, 0.2, 0.4}}, {0, 0.2, 0}, 3);
  constexpr double kStiffness = 200;
  constexpr double kRestLength = 0.5;
  const int A = AddBody(landing.world, Sphere{0.1}, {-50, 500, 0}, 1);
  const int B = AddBody(landing.world, Sphere{0.1}, {-50, 500, 0.8}, 2);
  landing.world.AddSpring({{A, {0, 0, 0}}, {B, {0, 0, 0}}, kStiffness, 0, kRestLength});
  landing.AddLinkage(kSteps);
  // Kinetic and elastic energy, without the motion of the centre, which falls.
  const auto energy = [&] {
    const BodyState& a = landing.world.state(A);
    const BodyState& b = landing.world.state(B);
    const double stretch = (b.p_WB - a.p_WB).norm() - kRestLength;
    return (b.v_WB - a.v_WB).squaredNorm() / 3 + kStiffness / 2 * stretch * stretch;
  };
  const double start = energy();
  int halved = 0;
  for (int step = 0; step < kSteps + 10; ++step) {
    halved += landing.StepIsHalved(box) ? 1 : 0;
    // The rounding of a coordinate of 500 m changes the stretch of 0.3 m by 1e-13 m.
    EXPECT_NEAR(energy(), start, 1e-11 * start) << step;
  }
  EXPECT_GT(halved, 0);
}

}  // namespace
}  // namespace cookbook
