#include "reports/worlds/law_support/allowed_motion.h"

#include <cmath>

#include <gtest/gtest.h>

#include "reports/worlds/truth/mechanics.h"
#include "tests/reports/worlds/motions.h"

namespace touchstone {
namespace {

/** A slim bar that spins fast. Its first-order gyroscopic drift is larger than its energy
 after a few steps. */
World SpinningBar() {
  World world;
  RigidBody bar = BodyOf("bar", Box{{0.5, 0.02, 0.02}}, 1, {0, 0, 0});
  bar.v_WB = {5, 0, 0};
  bar.w_WB = {36, 38, 25};
  bar.restitution = 0.3;
  bar.friction = 0;
  world.bodies = {bar};
  world.gravity_W.setZero();
  world.dt = 1.0 / 60;
  world.steps = 60;
  return world;
}

double KineticEnergy(const World& world, const WorldState& state) {
  return EnergyOf(world, state, {{0}, {}, {}}).kinetic;
}

/** The bar keeps its energy until half of the motion and then has `gain` times as much.
 */
Trajectory Exploding(const World& world, double gain) {
  return Sampled(world, [&](double t) {
    WorldState state = StateAtStart(world);
    BodyState& is = state.bodies[0];
    const double faster = t < world.steps * world.dt / 2 ? 1 : std::sqrt(gain);
    is.v_WB *= faster;
    is.w_WB *= faster;
    is.p_WB += t * is.v_WB;
    return state;
  });
}

TEST(AllowedMotion, SlowsOnlyWhatIsFasterThanTheTruthAllows) {
  const World world = SpinningBar();
  const double E = KineticEnergy(world, StateAtStart(world));
  for (const double gain : {1.0, 1.9, 4.0, 1e6}) {
    const Trajectory motion = Exploding(world, gain);
    const AllowedMotion allowed({world, DoubleEngine(), motion});
    const std::size_t last = motion.samples.size() - 1;
    EXPECT_NEAR(KineticEnergy(world, allowed.At(last)) / E, std::min(gain, 2.0), 1e-9);
    EXPECT_NEAR(allowed.KineticEnergy(last) / E, 1, 1e-9);
  }
}

TEST(AllowedMotion, KnowsTheWorkOfLoadsSpringsAndPushes) {
  // A mass is pulled by gravity, a force and a stretched spring, and is pushed. The truth
  // by small steps is never slowed, and reaches more than half of the bound.
  World world;
  RigidBody ball = BodyOf("ball", Sphere{0.1}, 2, {0, 0, 0});
  ball.force_W = {0, -6, 0};
  world.bodies = {ball};
  world.springs = {{{AnchorKind::kBody, 0, {0, 0, 0}},
                    {AnchorKind::kWorld, -1, {0, -3, 0}},
                    5,
                    0,
                    0.5}};
  world.dt = 1e-4;
  world.steps = 5000;
  world.pushes = {{0, 0.2, {0, 0, 0}, {0, -4, 0}}};
  int step = 0;
  const Trajectory fell = Stepped(world, [&](WorldState& state) {
    BodyState& is = state.bodies[0];
    if (step++ == 2000) is.v_WB += world.pushes[0].J_W / 2;
    const double pull = 5 * (3 + is.p_WB.y() - 0.5);
    is.v_WB.y() -= world.dt * (9.82 + 3 + pull / 2);
    is.p_WB += world.dt * is.v_WB;
  });
  const AllowedMotion allowed({world, DoubleEngine(), fell});
  const std::size_t last = fell.samples.size() - 1;
  const double K = KineticEnergy(world, fell.samples[last]);
  EXPECT_EQ(KineticEnergy(world, allowed.At(last)), K);
  EXPECT_LE(K, allowed.KineticEnergy(last));
  EXPECT_GE(K, allowed.KineticEnergy(last) / 2);
}

// A scheme that updates positions first has a velocity before the spring has moved.
TEST(AllowedMotion, LetsVelocitiesBeAStepAheadOfASpringAndNoMore) {
  World world;
  world.gravity_W.setZero();
  world.bodies = {BodyOf("ball", Sphere{0.1}, 2, {0, 0, 0})};
  world.springs = {{{AnchorKind::kBody, 0, {0, 0, 0}},
                    {AnchorKind::kWorld, -1, {0, -1, 0}},
                    5,
                    0,
                    0.5}};
  world.steps = 1;
  const double gained = world.dt * 5 * 0.5 / 2;  // h F/m
  const auto speed = [&](double steps) {
    const Trajectory motion = Stepped(
        world, [&](WorldState& state) { state.bodies[0].v_WB.y() = -steps * gained; });
    return AllowedMotion({world, DoubleEngine(), motion}).At(1).bodies[0].v_WB.norm();
  };
  EXPECT_NEAR(speed(1), gained, 1e-12);
  EXPECT_LT(speed(10), 7 * gained);
}

TEST(EnergyNeverRises, FindsAnExplosionOfAFastSpin) {
  const World world = SpinningBar();
  for (const double gain : {2.2, 7.0, 1e6}) {
    EXPECT_TRUE(Finds(Judge(world, Exploding(world, gain), ClaimOf("energy_never_rises")),
                      MeasureKind::kEnergyDrift))
        << gain;
  }
}

TEST(EnergyNeverRises, HoldsAnEngineToTheRotationErrorThatItDocuments) {
  const World world = SpinningBar();
  OracleInfo exact = DoubleEngine();
  exact.documented_rotation_error = 1e-6;
  const Claim claim = ClaimOf("energy_never_rises");
  EXPECT_TRUE(Finds(Judge(world, Exploding(world, 1.00001), claim, exact),
                    MeasureKind::kEnergyDrift));
  EXPECT_TRUE(Passes(Judge(world, Exploding(world, 1.0000005), claim, exact)));
  EXPECT_TRUE(Passes(Judge(world, Exploding(world, 1.00001), claim)));
}

TEST(EnergyNeverRises, GrantsAJumpNothingForASlowDrift) {
  // A first-order scheme may gain 1 % in these ten seconds, but not at once.
  World world = SpinningBar();
  world.bodies[0].w_WB = {0.5, 1, 0.7};
  world.dt = 1e-3;
  world.steps = 10000;
  const double gain = 1.0001;
  EXPECT_TRUE(Finds(Judge(world, Exploding(world, gain), ClaimOf("energy_never_rises")),
                    MeasureKind::kEnergyDrift));
  const Trajectory drifting = Sampled(world, [&](double t) {
    WorldState state = StateAtStart(world);
    state.bodies[0].w_WB *= std::sqrt(1 + (gain - 1) * t / 10);
    state.bodies[0].p_WB += t * state.bodies[0].v_WB;
    return state;
  });
  EXPECT_TRUE(Passes(Judge(world, drifting, ClaimOf("energy_never_rises"))));
}

}  // namespace
}  // namespace touchstone
