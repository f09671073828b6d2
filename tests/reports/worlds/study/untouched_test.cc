#include "reports/worlds/study/untouched.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "reports/worlds/truth/torque_free_rotation.h"
#include "tests/reports/worlds/fake_simulator.h"
#include "tests/reports/worlds/motions.h"

namespace touchstone {
namespace {

/** A plate that tumbles and falls, and a particle. */
World TumblingPlate() {
  World world;
  world.gravity_W = {0, -10, 0};
  world.bodies = {BodyOf("plate", Box{{0.5, 0.3, 0.05}}, 2, {0, 5, 0})};
  world.bodies[0].v_WB = {1, 0, 0};
  world.bodies[0].w_WB = {3, 0.5, 1};
  world.particles = {{"dust", {0, 1, 0}, {0, 0, 1}, 0.1}};
  world.dt = 0.01;
  world.steps = 50;
  return world;
}

bool PlateIsUntouched(const World& world,
                      const std::function<void(double t, BodyState&)>& change) {
  Trajectory motion = FreeFlight(world);
  for (std::size_t s = 0; s < motion.samples.size(); ++s)
    change(motion.times[s], motion.samples[s].bodies[0]);
  return IsUntouched({world, DoubleEngine(), motion}, "plate", 0.5);
}

TEST(IsUntouched, HoldsOfATorqueFreeRotation) {
  const World world = TumblingPlate();
  const RigidBody& plate = world.bodies[0];
  const TorqueFreeRotation rotation(InertiaOf(plate),
                                    {Eigen::Quaterniond::Identity(), plate.w_WB});
  double most = 0;
  EXPECT_TRUE(PlateIsUntouched(world, [&](double t, BodyState& state) {
    const Rotation is = rotation.At(std::vector{t}).front();
    state.q_WB = is.q_WB;
    state.w_WB = is.w_WB;
    most = std::max(most, (is.w_WB - plate.w_WB).norm());
  }));
  EXPECT_GT(most, 0.1 * plate.w_WB.norm());
}

TEST(IsUntouched, HoldsOfAConstantSpinToOnePerCent) {
  EXPECT_TRUE(PlateIsUntouched(TumblingPlate(), [](double t, BodyState& state) {
    if (t > 0.3) state.w_WB *= 1.005;
  }));
}

TEST(IsUntouched, FailsIfASpinOrAVelocityOrAPlaceChanges) {
  const World world = TumblingPlate();
  EXPECT_FALSE(PlateIsUntouched(world, [](double t, BodyState& state) {
    if (t > 0.3) state.w_WB *= 1.05;
  }));
  EXPECT_FALSE(PlateIsUntouched(world, [](double t, BodyState& state) {
    if (t > 0.3) state.v_WB.x() += 0.3;
  }));
  EXPECT_FALSE(PlateIsUntouched(world, [](double t, BodyState& state) {
    if (t > 0.3) state.p_WB.x() += 0.2;
  }));
}

// A body at rest has no motion of which a share could be granted.
TEST(IsUntouched, GrantsTheRoundingsOfTheEngine) {
  World world = TumblingPlate();
  world.gravity_W.setZero();
  world.bodies[0].v_WB.setZero();
  world.bodies[0].w_WB.setZero();
  Trajectory motion = FreeFlight(world);
  for (WorldState& state : motion.samples) {
    BodyState& plate = state.bodies[0];
    plate.p_WB.y() = std::nextafter(5.0F, 6.0F);
    plate.v_WB.y() = 5e-5;
    plate.w_WB.y() = 1e-5;
  }
  EXPECT_TRUE(IsUntouched({world, FloatEngine(), motion}, "plate", 0.5));
  EXPECT_FALSE(IsUntouched({world, DoubleEngine(), motion}, "plate", 0.5));
  motion.samples[20].bodies[0].w_WB.y() = 1e-3;
  EXPECT_FALSE(IsUntouched({world, FloatEngine(), motion}, "plate", 0.5));
}

TEST(IsUntouched, LooksNoFartherThanItIsAsked) {
  EXPECT_TRUE(PlateIsUntouched(TumblingPlate(), [](double t, BodyState& state) {
    if (t > 0.505) state.v_WB.x() += 3;
  }));
}

TEST(IsUntouched, FailsOfAParticleThatHangs) {
  const World world = TumblingPlate();
  Trajectory motion = FreeFlight(world);
  EXPECT_TRUE(IsUntouched({world, DoubleEngine(), motion}, "dust", 0.5));
  for (WorldState& state : motion.samples)
    state.particles[0] = {world.particles[0].p_W, Eigen::Vector3d::Zero()};
  EXPECT_FALSE(IsUntouched({world, DoubleEngine(), motion}, "dust", 0.5));
}

bool InFlight(const World& world, std::string_view name) {
  return MayBeTouched({world, DoubleEngine(), FreeFlight(world)}, name, 0.5);
}

TEST(MayBeTouched, AsksWhatIsFixedToAThingOrInItsWay) {
  World world = TumblingPlate();
  EXPECT_FALSE(InFlight(world, "plate"));
  World pushed = world;
  pushed.pushes = {{0, 0.1, Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitX()}};
  EXPECT_TRUE(InFlight(pushed, "plate"));
  World damped = world;
  damped.particles[0].damping = 1;
  EXPECT_TRUE(InFlight(damped, "dust"));
  EXPECT_FALSE(InFlight(damped, "plate"));
  // The plate falls by 1.25 m to 3.75 m, and its corners reach 0.59 m farther.
  world.bodies.push_back(BodyOf("floor", Box{{9, 1, 9}}, 0, {0, 1.5, 0}));
  EXPECT_FALSE(InFlight(world, "plate"));
  world.bodies[1].placed.X_WB.p_WB.y() = 2.7;
  EXPECT_TRUE(InFlight(world, "plate"));
}

}  // namespace
}  // namespace touchstone
