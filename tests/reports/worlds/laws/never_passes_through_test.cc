#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "reports/worlds/law_support/overlap.h"
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

/** The greatest depth on the way. [m] */
double DepthOf(const World& world, const WorldState& from, const WorldState& to, int A,
               int B) {
  double depth = 0;
  for (const SweptOverlap& overlap : SweptOverlapsOf(world, from, to, A, B, {}))
    depth = std::max(depth, overlap.depth);
  return depth;
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
  const LawFinding passage =
      Of(Judge(world, Through(world), kClaim), MeasureKind::kPassage);
  EXPECT_NEAR(passage.value, 0.5 - 0.013 + 0.01, 1e-9);
  EXPECT_NE(passage.proof.find("a way around would have to lie 0.497 m aside, and "),
            std::string::npos);
  ASSERT_TRUE(passage.cited.time && passage.cited.first_time);
  EXPECT_LE(*passage.cited.first_time, *passage.cited.time);
}

// The velocities at two samples do not tell what a rod did between them, so the whole way
// may have been used to turn aside, and no more.
TEST(NeverPassesThrough, LetsABodyOnARodTurnAsideByNoMoreThanItsWay) {
  for (const double half_width : {0.5, 5.0}) {
    World world = BulletAndWall(500);
    world.bodies[0].placed.shape = Box{{0.005, half_width, half_width}};
    DistanceJoint& rod = world.joints.emplace_back();
    rod.A.on = AnchorKind::kWorld;
    rod.A.point = {0, 1000, 0};
    rod.B.on = AnchorKind::kBody;
    rod.B.index = 1;
    rod.length = 1000;
    const LawFinding passage =
        Of(Judge(world, Through(world), kClaim), MeasureKind::kPassage);
    EXPECT_NEAR(passage.value, half_width - 0.013 + 0.01, 1e-9);
    EXPECT_NEAR(passage.tolerance.value, 1.5 * 500 * world.dt, 1e-9);
    EXPECT_EQ(IsBeyond(passage), half_width == 5.0);
  }
}

// Two pairs of springs move a ball on the curve x = cos πt, y = cos 2πt. It goes around
// the block, and is at rest on either side of it at the samples.
TEST(NeverPassesThrough, LetsSpringsMoveABodyAroundAnotherBetweenSamples) {
  const double pi = std::numbers::pi;
  World world;
  world.bodies = {BodyOf("block", Box{{0.2, 0.2, 0.2}}, 0, {0, 1, 0}),
                  BodyOf("ball", Sphere{0.1}, 1, {1, 1, 0})};
  world.gravity_W.setZero();
  world.dt = 1e-3;
  world.steps = 3000;
  world.sample_every = 1000;
  for (const Eigen::Vector3d& direction :
       {Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0, 1, 0)}) {
    for (const double side : {-1.0, 1.0}) {
      Spring& spring = world.springs.emplace_back();
      spring.A.point = 1000 * side * direction;
      spring.B.on = AnchorKind::kBody;
      spring.B.index = 1;
      spring.rest_length = 1000;
      spring.stiffness = direction.x() * pi * pi / 2 + direction.y() * 2 * pi * pi;
    }
  }
  const Trajectory swings = Sampled(world, [&](double t) {
    WorldState state = StateAtStart(world);
    state.bodies[1].p_WB = {std::cos(pi * t), std::cos(2 * pi * t), 0};
    state.bodies[1].v_WB = {-pi * std::sin(pi * t), -2 * pi * std::sin(2 * pi * t), 0};
    return state;
  });
  EXPECT_TRUE(Passes(Judge(world, swings, kClaim)));
  // Samples of every step show that a ball goes straight through.
  world.sample_every = 1;
  const Trajectory through = Sampled(world, [&](double t) {
    WorldState state = StateAtStart(world);
    state.bodies[1].p_WB = {t < 0.5 ? 1.0 : -1.0, 1, 0};
    return state;
  });
  EXPECT_TRUE(Finds(Judge(world, through, kClaim), MeasureKind::kPassage));
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

TEST(NeverPassesThrough, LetsAnImpactTakeManyStepsToEnd) {
  // A late impact leaves a ball 0.1 mm inside a wall. It returns at a tenth of its speed,
  // so it slides along inside for several steps, each far less than its radius.
  World world;
  RigidBody floor = BodyOf("floor", Box{{9, 1, 9}}, 0, {0, -1, 0});
  RigidBody ball = BodyOf("ball", Sphere{1}, 1, {0, 1 + 1e-4, 0});
  ball.v_WB = Eigen::Vector3d(4e-4, -2e-4, 0) / world.dt;
  world.bodies = {floor, ball};
  world.gravity_W.setZero();
  world.steps = 24;
  const Trajectory slow = Stepped(world, [&](WorldState& state) {
    BodyState& is = state.bodies[1];
    if (is.p_WB.y() < 1 && is.v_WB.y() < 0) is.v_WB.y() *= -0.1;
    is.p_WB += world.dt * is.v_WB;
  });
  ASSERT_LT(slow.samples[2].bodies[1].p_WB.y(), 1);
  ASSERT_GT(slow.samples.back().bodies[1].p_WB.y(), 1);
  EXPECT_TRUE(Passes(Judge(world, slow, kClaim)));
}

TEST(NeverPassesThrough, LetsAPlateRockOnAnEdge) {
  // Half a turn of 0.2 rad to either side. The hull of both poses is 0.05 m below the
  // edge, where no pose of the plate ever is.
  World world;
  RigidBody wedge = BodyOf("wedge", Box{{0.5, 0.5, 2}}, 0, {0, -std::sqrt(0.5), 0});
  wedge.placed.X_WB = Pose::FromQuaternion(
      wedge.placed.X_WB.p_WB, Turned({1, 0, 0, 0}, {0, 0, std::numbers::pi / 4}));
  RigidBody plate = BodyOf("plate", Box{{0.5, 0.02, 0.5}}, 1, {0, 0, 0});
  const double height = 0.02 / std::cos(0.1) + 1e-3;
  const auto tilted = [&](double angle) {
    return Pose::FromQuaternion({0, height, 0}, Turned({1, 0, 0, 0}, {0, 0, angle}));
  };
  plate.placed.X_WB = tilted(0.1);
  world.bodies = {wedge, plate};
  world.gravity_W.setZero();
  world.dt = 1.0 / 60;
  world.steps = 1;
  Trajectory rocks = Stepped(world, [&](WorldState& state) {
    state.bodies[1].q_WB = Turned({1, 0, 0, 0}, {0, 0, -0.1});
  });
  EXPECT_LT(DepthOf(world, rocks.samples[0], rocks.samples[1], 1, 0), 0.01);
  EXPECT_TRUE(Passes(Judge(world, rocks, kClaim)));
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

/** A plank turns about the edge of a table from lying to hanging, `gap` [m] away from the
 edge, with `samples` samples per radian. */
Trajectory Tips(const World& world, double gap, int samples) {
  Trajectory tipped;
  tipped.times.reserve(2 * static_cast<std::size_t>(samples));
  tipped.samples.reserve(2 * static_cast<std::size_t>(samples));
  const double most = 1.4;
  for (int i = 0; i <= most * samples; ++i) {
    const double angle = static_cast<double>(i) / samples;
    WorldState state = StateAtStart(world);
    BodyState& plank = state.bodies[1];
    // Its lower face stays `gap` from the edge at (1, 0), 5 cm from the plank's middle.
    const Eigen::Quaterniond q(Eigen::AngleAxisd(-angle, Eigen::Vector3d::UnitZ()));
    plank.q_WB = q;
    plank.p_WB = Eigen::Vector3d(1, 0, 0) + q * Eigen::Vector3d(0.05, 0.04 + gap, 0);
    plank.w_WB = {0, 0, -1};
    plank.v_WB = plank.w_WB.cross(q * Eigen::Vector3d(0.05, 0.04 + gap, 0));
    tipped.times.push_back(angle);
    tipped.samples.push_back(state);
  }
  return tipped;
}

// The hull of two poses of a body that turns about a point of its surface holds places
// about that point where the body never is.
TEST(NeverPassesThrough, LetsAPlankTipOverAnEdge) {
  World world;
  world.bodies = {BodyOf("table", Box{{1, 0.5, 1}}, 0, {0, -0.5, 0}),
                  BodyOf("plank", Box{{0.5, 0.04, 0.1}}, 1, {1.05, 0.0401, 0})};
  world.gravity_W.setZero();
  for (const int samples : {2, 3, 10, 60}) {
    world.dt = 1.0 / samples;
    world.steps = static_cast<int>(1.4 * samples);
    const Trajectory tips = Tips(world, 1e-4, samples);
    for (const WorldState& state : tips.samples)
      ASSERT_EQ(OverlapOf(world, state, 0, 1).depth, 0);
    EXPECT_TRUE(Passes(Judge(world, tips, kClaim))) << samples;
  }
}

// The way of a cube that rests on another leads into it by less than a rounding.
TEST(NeverPassesThrough, LetsABodyCreepOverAnotherAtADepthOfARounding) {
  World world;
  world.bodies = {BodyOf("lower", Box{{0.5, 0.5, 0.5}}, 0, {0, 0, 0}),
                  BodyOf("upper", Box{{0.5, 0.5, 0.5}}, 1, {0, 1, 0})};
  world.steps = 1;
  for (const double sideways : {1e-3, 1e-9}) {
    for (const double down : {0.0, 0x1p-53, 1e-17}) {
      const Trajectory creeps = Stepped(world, [&](WorldState& state) {
        state.bodies[1].p_WB += Eigen::Vector3d(sideways, -down, 0);
      });
      EXPECT_TRUE(Passes(Judge(world, creeps, kClaim))) << sideways << " " << down;
    }
  }
}

// Seen from the cube the ball's path bends by its own speed too, as Coriolis found.
TEST(NeverPassesThrough, LetsABallFlyPastASpinningCube) {
  World world;
  // The cube's edges are 0.495 m from its axis; the ball passes at 0.526 m.
  world.bodies = {BodyOf("cube", Box{{0.35, 0.35, 0.35}}, 1, {0, 0, 0}),
                  BodyOf("ball", Sphere{0.02}, 1, {-1, 0.546, 0})};
  world.bodies[1].v_WB = {20, 0, 0};
  world.gravity_W.setZero();
  world.dt = 0.1;
  world.steps = 1;
  for (const double spin : {1.0, 3.0, 5.0, 9.9, -9.9}) {
    world.bodies[0].w_WB = {0, 0, spin};
    const Trajectory passed = Stepped(world, [&](WorldState& state) {
      state.bodies[1].p_WB.x() += 2;
      state.bodies[0].q_WB = Turned(state.bodies[0].q_WB, {0, 0, spin * world.dt});
    });
    EXPECT_TRUE(Passes(Judge(world, passed, kClaim))) << spin;
  }
}

/** A blade of 1 m to either side turns by 1.2 rad a step about a fixed hub; a post stands
 `away` from the hub, between two places of the blade. */
World BladeAndPost(double away, int sample_every = 1) {
  World world;
  world.bodies = {BodyOf("post", Box{{0.02, 0.02, 1}}, 0, {away, 0, 0}),
                  BodyOf("blade", Box{{1, 0.02, 0.02}}, 1, {0, 0, 0})};
  world.bodies[1].placed.X_WB = Pose::FromQuaternion(
      {0, 0, 0}, Eigen::Quaterniond(Eigen::AngleAxisd(-0.6, Eigen::Vector3d::UnitZ())));
  world.bodies[1].w_WB = {0, 0, 72};
  world.gravity_W.setZero();
  world.dt = 1.0 / 60;
  world.steps = 4;
  world.sample_every = sample_every;
  return world;
}

/** Each step turns the blade by `turn` [rad]. */
Trajectory Turning(const World& world, double turn) {
  return Stepped(world, [turn](WorldState& state) {
    state.bodies[1].q_WB = Turned(state.bodies[1].q_WB, {0, 0, turn});
  });
}

TEST(NeverPassesThrough, FollowsABladeThatTurnsOverARadianAStep) {
  for (const double away : {0.8, 0.95}) {
    const World world = BladeAndPost(away);
    EXPECT_TRUE(Finds(Judge(world, Turning(world, 1.2), kClaim), MeasureKind::kPassage))
        << away;
  }
  const World clear = BladeAndPost(1.05);
  EXPECT_TRUE(Passes(Judge(clear, Turning(clear, 1.2), kClaim)));
}

TEST(NeverPassesThrough, ClaimsNoWayRoundThatItDoesNotKnow) {
  // Between two samples the blade turns by 2.4 rad in two steps.
  const World seldom = BladeAndPost(0.8, 2);
  EXPECT_TRUE(Passes(Judge(seldom, Turning(seldom, 1.2), kClaim)));
  // The spins say 1.2 rad a step, the places another turn.
  const World world = BladeAndPost(0.8);
  for (const double turn : {1.4, -1.2})
    EXPECT_TRUE(Passes(Judge(world, Turning(world, turn), kClaim))) << turn;
}

/** A ball at two samples, on both sides of a post. */
World BallAndPost() {
  World world;
  world.bodies = {BodyOf("post", Box{{0.3, 5, 0.3}}, 0, {0, 0, 0}),
                  BodyOf("ball", Sphere{0.05}, 1, {-5, 0, 0})};
  world.bodies[1].v_WB = {10, 0, 0};
  world.gravity_W.setZero();
  world.dt = 1e-3;
  world.steps = 1000;
  world.sample_every = 1000;
  return world;
}

Trajectory Beyond(const World& world) {
  return Sampled(world, [&](double t) {
    WorldState state = StateAtStart(world);
    state.bodies[1].p_WB.x() += 10 * t;
    return state;
  });
}

TEST(NeverPassesThrough, LetsPushesTakeABallAroundAPostBetweenTwoSamples) {
  World world = BallAndPost();
  EXPECT_TRUE(Finds(Judge(world, Beyond(world), kClaim), MeasureKind::kPassage));
  world.pushes.reserve(3);
  for (const auto& [time, impulse] : {std::pair(0.0, 4.0), {0.5, -8.0}, {0.999, 4.0}}) {
    Push push;
    push.body = 1;
    push.time = time;
    push.J_W = {0, 0, impulse};
    world.pushes.push_back(push);
  }
  EXPECT_TRUE(Passes(Judge(world, Beyond(world), kClaim)));
}

TEST(NeverPassesThrough, KnowsNothingOfAWayOnARodBetweenTwoSamples) {
  World world = BallAndPost();
  world.joints.emplace_back();
  world.joints[0].A = {AnchorKind::kBody, 1};
  EXPECT_TRUE(Passes(Judge(world, Beyond(world), kClaim)));
}

// Its own impulses bend the way of a body by metres, but not around a wall of 80 m.
TEST(NeverPassesThrough, GrantsNoWayThroughAWallForTheImpulseOfIt) {
  World world;
  world.bodies = {BodyOf("wall", Box{{0.25, 40, 40}}, 0, {0, 0, 0}),
                  BodyOf("bar", Box{{0.1, 0.1, 0.4}}, 1, {-5, 0.3, 0.2})};
  world.gravity_W.setZero();
  world.dt = 1.0 / 60;
  world.steps = 1;
  for (const double spin : {0.0, 10.0, 4.7e4}) {
    world.bodies[1].v_WB = {1000, 0, 0};
    const Trajectory through = Stepped(world, [&](WorldState& state) {
      BodyState& bar = state.bodies[1];
      bar.p_WB.x() = 0.8;
      bar.v_WB = {393, 0, 0};
      bar.w_WB = {spin, 0, 0};
      bar.q_WB =
          Turned(bar.q_WB, std::fmod(spin * world.dt, 6) * Eigen::Vector3d::UnitX());
    });
    const std::vector<LawFinding> findings = Judge(world, through, kClaim);
    EXPECT_TRUE(Finds(findings, MeasureKind::kPassage)) << spin;
    EXPECT_GT(Of(findings, MeasureKind::kPassage).value, 39) << spin;
  }
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
  EXPECT_NEAR(DepthOf(world, at(-3), at(3), 0, 1), 0.07, 1e-12);
  EXPECT_EQ(DepthOf(world, at(-3), at(-2), 0, 1), 0);
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
  EXPECT_NEAR(DepthOf(world, from, to, 0, 1), 0.1, 1e-12);
  EXPECT_NEAR(DepthOf(world, from, to, 1, 0), 0.1, 1e-12);
}

TEST(TurnsOnce, never_passes_through) {
  const World world = BulletAndWall(100);
  EXPECT_TRUE(TurnsOnce(world, Reflected(world, 0.5), kClaim, {1, 0, 0}));
}

}  // namespace
}  // namespace touchstone
