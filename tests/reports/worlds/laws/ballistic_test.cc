#include <gtest/gtest.h>

#include "tests/reports/worlds/motions.h"

namespace touchstone {
namespace {

World FlyingBox() {
  World world;
  RigidBody box = BodyOf("box", Box{{0.1, 0.2, 0.3}}, 2.5, {0.3, 1.7, -0.4});
  box.v_WB = {1.3, 4.1, -0.7};
  box.force_W = {0.9, 0, -2.3};
  world.bodies = {box};
  world.particles = {{"drop", {-1.1, 3.3, 0.2}, {0.4, 0, 0.1}, 0.2}};
  world.steps = 480;
  return world;
}

/** Free flight by a scheme that moves by a fraction `early` of the new velocity and the
 rest of the old: 1 is semi-implicit Euler, 0 explicit Euler. */
Trajectory Flown(const World& world, double early, double g_scale = 1) {
  return Stepped(world, [&, early, g_scale](WorldState& state) {
    const auto fly = [&](Eigen::Vector3d& p, Eigen::Vector3d& v,
                         const Eigen::Vector3d& a) {
      const Eigen::Vector3d next = v + world.dt * g_scale * a;
      p += world.dt * (early * next + (1 - early) * v);
      v = next;
    };
    const RigidBody& body = world.bodies[0];
    fly(state.bodies[0].p_WB, state.bodies[0].v_WB,
        world.gravity_W + body.force_W / body.mass);
    fly(state.particles[0].p_W, state.particles[0].v_W, world.gravity_W);
  });
}

const Claim kClaim = ClaimOf("ballistic");

TEST(Ballistic, AllFirstOrderSchemesAndTheMidpointPass) {
  const World world = FlyingBox();
  for (const double early : {0.0, 0.5, 1.0})
    EXPECT_TRUE(Passes(Judge(world, Flown(world, early), kClaim)));
}

TEST(Ballistic, SemiImplicitEulerIsOffByHalfAHT) {
  const World world = FlyingBox();
  const LawFinding position =
      Of(Judge(world, Flown(world, 1), kClaim), MeasureKind::kPositionError);
  EXPECT_NEAR(position.value / position.tolerance.value, 1 / 1.5, 1e-6);
}

TEST(Ballistic, KnowsHowFarAMotionIsFromSemiImplicitEuler) {
  const World world = FlyingBox();
  const auto position = [&](double early) {
    return Of(Judge(world, Flown(world, early), kClaim), MeasureKind::kPositionError);
  };
  // The midpoint is ½ a h t away, explicit Euler twice as far.
  const double error = position(0.5).scheme.error;
  EXPECT_EQ(position(1).scheme.name, "semi-implicit Euler");
  EXPECT_LE(position(1).scheme.error, 1e-10 * error);
  EXPECT_NEAR(position(0.9).scheme.error, 0.2 * error, 1e-3 * error);
  EXPECT_NEAR(position(0).scheme.error, 2 * error, 1e-3 * error);
}

TEST(Ballistic, TheMidpointIsTheTruthItself) {
  const World world = FlyingBox();
  EXPECT_LE(
      Of(Judge(world, Flown(world, 0.5), kClaim), MeasureKind::kPositionError).value,
      1e-12);
}

TEST(Ballistic, FindsGravityOffByAThousandth) {
  const World world = FlyingBox();
  EXPECT_TRUE(
      Finds(Judge(world, Flown(world, 1, 1.001), kClaim), MeasureKind::kVelocityError));
}

TEST(Ballistic, FindsVelocityDampedEachStep) {
  World world = FlyingBox();
  const Trajectory damped = Stepped(world, [&](WorldState& state) {
    BodyState& body = state.bodies[0];
    body.v_WB =
        0.98 * (body.v_WB + world.dt * (world.gravity_W + world.bodies[0].force_W / 2.5));
    body.p_WB += world.dt * body.v_WB;
  });
  const std::vector<LawFinding> findings =
      Judge(world, damped, ClaimOf("ballistic", {"box"}));
  EXPECT_TRUE(Finds(findings, MeasureKind::kVelocityError));
  EXPECT_TRUE(Finds(findings, MeasureKind::kPositionError));
}

TEST(Ballistic, APushAddsItsImpulseOverTheMass) {
  World world = FlyingBox();
  world.pushes = {{0, 0.5, Eigen::Vector3d::Zero(), {1.5, -0.5, 2}}};
  int step = 0;
  const auto pushed = [&](double inverse_mass) {
    step = 0;
    return Stepped(world, [&, inverse_mass](WorldState& state) {
      BodyState& body = state.bodies[0];
      if (step++ == 120) body.v_WB += inverse_mass * world.pushes[0].J_W;
      body.v_WB += world.dt * (world.gravity_W + world.bodies[0].force_W / 2.5);
      body.p_WB += world.dt * body.v_WB;
    });
  };
  const Claim claim = ClaimOf("ballistic", {"box"});
  EXPECT_TRUE(Passes(Judge(world, pushed(1 / 2.5), claim)));
  // Wrong: the impulse is not divided by the mass.
  EXPECT_TRUE(Finds(Judge(world, pushed(1), claim), MeasureKind::kVelocityError));
}

TEST(Ballistic, RoundingIsThatOfTheEngine) {
  const World world = FlyingBox();
  const Trajectory rounded = Stepped(world, [&](WorldState& state) {
    BodyState& body = state.bodies[0];
    body.v_WB += world.dt * (world.gravity_W + world.bodies[0].force_W / 2.5);
    body.v_WB = body.v_WB.cast<float>().cast<double>();
    body.p_WB += world.dt * body.v_WB;
  });
  const Claim claim = ClaimOf("ballistic", {"box"});
  EXPECT_TRUE(Passes(Judge(world, rounded, claim, FloatEngine())));
  EXPECT_TRUE(Finds(Judge(world, rounded, claim), MeasureKind::kVelocityError));
}

TEST(Ballistic, RefusesHeldUnknownAndStaticSubjects) {
  World world = FlyingBox();
  world.bodies.push_back(GroundOf());
  EXPECT_EQ(FaultsOf(world, ClaimOf("ballistic", {"ground"})).size(), 1U);
  EXPECT_EQ(FaultsOf(world, ClaimOf("ballistic", {"nobody"})).size(), 1U);
  EXPECT_TRUE(FaultsOf(world, kClaim).empty());
  world.joints = {
      {{AnchorKind::kBody, 0, {0, 0, 0}}, {AnchorKind::kWorld, -1, {0, 0, 0}}, 1}};
  const std::vector<Fault> faults = FaultsOf(world, ClaimOf("ballistic", {"box"}));
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_EQ(faults.front().where, "about[0]");
}

TEST(Ballistic, RefusesNumbersItDoesNotKnow) {
  EXPECT_EQ(FaultsOf(FlyingBox(), ClaimOf("ballistic", {}, {{"expected_range", 3}}))
                .front()
                .where,
            "numbers.expected_range");
}

TEST(TurnsOnce, ballistic) {
  const World world = FlyingBox();
  EXPECT_TRUE(TurnsOnce(world, Flown(world, 0.5), kClaim));
}

}  // namespace
}  // namespace touchstone
