#include <cmath>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "reports/worlds/law_support/swept.h"
#include "reports/worlds/truth/mechanics.h"
#include "tests/reports/worlds/motions.h"

namespace touchstone {
namespace {

const Claim kClaim = ClaimOf("never_passes_through");

/** A ball of 1 cm flies at a wall of 1 cm that is 1 m wide and 1 m away. */
World BulletAndWall(double speed, int sample_every = 1) {
  World world;
  RigidBody wall = BodyOf("wall", Box{{0.005, 0.5, 0.5}}, 0, {1, 0, 0});
  RigidBody ball = BodyOf("ball", Sphere{0.01}, 0.01, {0, 0.013, 0.007});
  ball.v_WB = {speed, 0, 0};
  world.bodies = {wall, ball};
  world.gravity_W.setZero();
  world.steps = 24;
  world.sample_every = sample_every;
  return world;
}

/** Flies through, keeping `kept` of its speed beyond the wall. */
Trajectory Through(const World& world, double kept = 1) {
  const double speed = world.bodies[1].v_WB.x();
  return Sampled(world, [&](double t) {
    WorldState state = StateAtStart(world);
    const double x = speed * t;
    state.bodies[1].p_WB.x() = x < 1 ? x : 1 + kept * (x - 1);
    if (x >= 1) state.bodies[1].v_WB *= kept;
    return state;
  });
}

Trajectory Reflected(const World& world, double restitution) {
  const double speed = world.bodies[1].v_WB.x();
  return Sampled(world, [&](double t) {
    WorldState state = StateAtStart(world);
    const double surface = 1 - 0.005 - 0.01;
    const double x = speed * t;
    state.bodies[1].p_WB.x() = x < surface ? x : surface - restitution * (x - surface);
    if (x >= surface) state.bodies[1].v_WB *= -restitution;
    return state;
  });
}

TEST(NeverPassesThrough, FindsABulletAtAnySpeedAndSampling) {
  for (const double speed : {15.0, 100.0, 240.0, 500.0}) {
    for (const int sample_every : {1, 2, 3}) {
      const World world = BulletAndWall(speed, sample_every);
      for (const double kept : {1.0, 0.9}) {
        EXPECT_TRUE(
            Finds(Judge(world, Through(world, kept), kClaim), MeasureKind::kPassage))
            << speed << " " << sample_every << " " << kept;
      }
      for (const double e : {0.0, 0.5, 1.0}) {
        const std::vector<LawFinding> findings =
            Judge(world, Reflected(world, e), kClaim);
        EXPECT_TRUE(Passes(findings)) << speed << e;
      }
    }
  }
}

TEST(NeverPassesThrough, FindsABulletThatIsInsideTheWallAtASample) {
  // At 240 m/s it is at the middle of the wall after one step.
  const World world = BulletAndWall(240);
  const Trajectory through = Through(world);
  EXPECT_NEAR(through.samples[1].bodies[1].p_WB.x(), 1, 1e-12);
  EXPECT_TRUE(Finds(Judge(world, through, kClaim), MeasureKind::kPassage));
}

TEST(NeverPassesThrough, MeasuresHowFarItWouldHaveHadToTurnAside) {
  // The nearest way around the wall is over its upper edge: 0.5 − 0.013 + 0.01.
  const World world = BulletAndWall(500);
  EXPECT_NEAR(Of(Judge(world, Through(world), kClaim), MeasureKind::kPassage).value,
              0.5 - 0.013 + 0.01, 1e-9);
}

TEST(NeverPassesThrough, FindsTwoBodiesThatExchangeTheirPlaces) {
  World world;
  const Shape cube = Box{{0.5, 0.5, 0.5}};
  const Shape ball = Sphere{0.5};
  const Shape can = Cylinder{0.5, 0.5};
  const Shape cone = Cone{0.5, 0.5};
  const Shape pill = Capsule{0.3, 0.5};
  for (const Shape& A : {cube, ball, can, cone, pill}) {
    for (const Shape& B : {cube, ball, can, cone, pill}) {
      world.bodies = {BodyOf("left", A, 1, {-1.2, 0.1, 0}),
                      BodyOf("right", B, 1, {1.2, 0.1, 0})};
      for (RigidBody& body : world.bodies) {
        body.inertia = {1, 1, 1};
        body.v_WB.x() = -120 * body.placed.X_WB.p_WB.x();
      }
      world.gravity_W.setZero();
      world.dt = 1.0 / 60;
      world.steps = 1;
      for (const double turn : {0.0, 0.3, 3.0}) {
        world.bodies[0].w_WB = {0, 0, turn / world.dt};
        const Trajectory passed = Stepped(world, [&](WorldState& state) {
          for (BodyState& is : state.bodies) {
            is.p_WB += world.dt * is.v_WB;
            is.q_WB = Turned(is.q_WB, world.dt * is.w_WB);
          }
        });
        EXPECT_TRUE(Finds(Judge(world, passed, kClaim), MeasureKind::kPassage))
            << A.index() << " " << B.index() << " " << turn;
      }
    }
  }
}

TEST(NeverPassesThrough, LetsABallRoundACorner) {
  // A ball rolls along a table, over its edge and falls, with any distance of samples.
  for (const int sample_every : {1, 7, 40}) {
    World world;
    RigidBody table = BodyOf("table", Box{{1, 0.5, 1}}, 0, {0, -0.5, 0});
    RigidBody ball = BodyOf("ball", Sphere{0.1}, 1, {0.5, 0.1, 0});
    ball.v_WB = {1, 0, 0};
    world.bodies = {table, ball};
    world.steps = 280;
    world.sample_every = sample_every;
    const Trajectory fell = Stepped(world, [&](WorldState& state) {
      BodyState& is = state.bodies[1];
      // Round the edge at (1, 0): the part of its velocity into the edge is taken.
      is.v_WB += world.dt * world.gravity_W;
      const double edge = std::clamp(is.p_WB.x(), -1.0, 1.0);
      const Eigen::Vector3d p_edge = is.p_WB - Eigen::Vector3d(edge, 0, 0);
      const double gap = p_edge.norm() - 0.1;
      const Eigen::Vector3d n_W = p_edge.normalized();
      is.v_WB -= std::min(0.0, n_W.dot(is.v_WB) + gap / world.dt) * n_W;
      is.p_WB += world.dt * is.v_WB;
    });
    ASSERT_LT(fell.samples.back().bodies[1].p_WB.y(), -0.3);
    const std::vector<LawFinding> findings = Judge(world, fell, kClaim);
    EXPECT_TRUE(Passes(findings)) << sample_every;
  }
}

TEST(NeverPassesThrough, LetsBodiesRestSlideAndSeparate) {
  World world;
  RigidBody floor = BodyOf("floor", Box{{20, 1, 20}}, 0, {0, -1, 0});
  RigidBody tile = BodyOf("tile", Box{{0.3, 0.02, 0.3}}, 1, {0, 0.02, 0});
  tile.v_WB = {20, 0, 0};
  world.bodies = {floor, tile};
  world.steps = 120;
  for (const double deep : {-1e-3, 0.0, 1e-3}) {
    const Trajectory slides = Sampled(world, [&](double t) {
      WorldState state = StateAtStart(world);
      state.bodies[1].p_WB += Eigen::Vector3d(20 * t, t > 0 ? -deep : 0, 0);
      return state;
    });
    const std::vector<LawFinding> findings = Judge(world, slides, kClaim);
    EXPECT_TRUE(Passes(findings)) << deep;
  }
}

TEST(NeverPassesThrough, LetsASpinningBallFlyPastAnother) {
  World world;
  world.bodies = {BodyOf("left", Sphere{0.5}, 1, {-3, 0.51, 0}),
                  BodyOf("right", Sphere{0.5}, 1, {0, -0.5, 0})};
  world.bodies[0].v_WB = {60, 0, 0};
  world.bodies[1].w_WB = {0, 0, 50};
  world.gravity_W.setZero();
  world.dt = 1.0 / 60;
  world.steps = 10;
  const Trajectory passed = Stepped(world, [&](WorldState& state) {
    state.bodies[0].p_WB.x() += 1;
    state.bodies[1].q_WB = Turned(state.bodies[1].q_WB, world.dt * world.bodies[1].w_WB);
  });
  const std::vector<LawFinding> findings = Judge(world, passed, kClaim);
  EXPECT_TRUE(Passes(findings));
}

TEST(NeverPassesThrough, RefusesWhatCollidesWithNothingOrWithHalfSpacesAlone) {
  World world = BulletAndWall(500);
  EXPECT_TRUE(FaultsOf(world, kClaim).empty());
  world.bodies[1].collides = false;
  EXPECT_EQ(FaultsOf(world, kClaim).size(), 1U);
  world.bodies[1].collides = true;
  world.bodies[0] = GroundOf();
  EXPECT_EQ(FaultsOf(world, kClaim).size(), 1U);
}

TEST(SweptOverlap, OfASphereIsThatOfACapsule) {
  // Past the corner of a box, at a distance of 0.03 from its edge.
  World world;
  world.bodies = {BodyOf("ball", Sphere{0.1}, 1, {0, 0, 0}),
                  BodyOf("box", Box{{1, 1, 1}}, 0, {0, 0, 0})};
  const double along = std::numbers::sqrt2 / 2;
  const auto at = [&](double way) {
    WorldState state = StateAtStart(world);
    state.bodies[0].p_WB = Eigen::Vector3d(1, 1, 0) +
                           0.03 * Eigen::Vector3d(along, along, 0) +
                           way * Eigen::Vector3d(along, -along, 0);
    return state;
  };
  EXPECT_NEAR(SweptOverlapOf(world, at(-3), at(3), 0, 1).depth, 0.07, 1e-12);
  EXPECT_EQ(SweptOverlapOf(world, at(-3), at(-2), 0, 1).depth, 0);
}

TEST(SweptOverlap, OfABoxIsThatOfItsHullAndIsTheSameSeenFromEither) {
  World world;
  world.bodies = {BodyOf("a", Box{{0.1, 0.2, 0.3}}, 1, {0, 0, 0}),
                  BodyOf("b", Box{{0.5, 0.5, 0.5}}, 1, {0, 0, 0})};
  WorldState from = StateAtStart(world);
  WorldState to = from;
  from.bodies[0].p_WB = {-3, 0.6, 0};
  to.bodies[0].p_WB = {4, 0.6, 0};
  // Both move on by the same: what counts is the relative motion.
  to.bodies[0].p_WB += Eigen::Vector3d(0, 5, 7);
  to.bodies[1].p_WB += Eigen::Vector3d(0, 5, 7);
  EXPECT_NEAR(SweptOverlapOf(world, from, to, 0, 1).depth, 0.1, 1e-12);
  EXPECT_NEAR(SweptOverlapOf(world, from, to, 1, 0).depth, 0.1, 1e-12);
}

TEST(TurnsOnce, never_passes_through) {
  const World world = BulletAndWall(100);
  EXPECT_TRUE(TurnsOnce(world, Reflected(world, 0.5), kClaim, {1, 0, 0}));
}

}  // namespace
}  // namespace touchstone
