#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "reports/worlds/laws/laws.h"
#include "reports/worlds/truth/mechanics.h"
#include "tests/reports/worlds/motions.h"

namespace touchstone {
namespace {

World FallingBall() {
  World world;
  RigidBody ball = BodyOf("ball", Sphere{0.5}, 3, {0.2, 1.5, -0.1});
  ball.restitution = 0;
  world.bodies = {ball, GroundOf()};
  world.steps = 480;
  return world;
}

/** Falls, and stops in the first step that starts at a gap of at most −`late`. */
Trajectory StoppingAt(const World& world, double late, double sinking = 0) {
  return Stepped(world, [&world, late, sinking](WorldState& state) {
    BodyState& ball = state.bodies[0];
    double& v = ball.v_WB.y();
    v = ball.p_WB.y() - 0.5 <= -late ? -sinking : v - 9.82 * world.dt;
    ball.p_WB.y() += world.dt * v;
  });
}

TEST(NeverPenetrates, ABodyStoppedOnDetectionPasses) {
  const World world = FallingBall();
  const std::vector<LawFinding> findings =
      Judge(world, StoppingAt(world, 0), ClaimOf("never_penetrates"));
  EXPECT_TRUE(Passes(findings));
  EXPECT_GT(findings[0].value, 0);
}

TEST(NeverPenetrates, FindsABodyThatIsStoppedTooDeep) {
  const World world = FallingBall();
  EXPECT_TRUE(Finds(Judge(world, StoppingAt(world, 0.03), ClaimOf("never_penetrates")),
                    MeasureKind::kPenetration));
  EXPECT_TRUE(Passes(Judge(world, StoppingAt(world, 0.03),
                           ClaimOf("never_penetrates", {}, {{"slack", 0.02}}))));
}

TEST(NeverPenetrates, FindsABodyThatSinksAndOneThatFallsThrough) {
  const World world = FallingBall();
  for (const Trajectory& wrong : {StoppingAt(world, 0, 0.05), StoppingAt(world, 100)}) {
    EXPECT_TRUE(Finds(Judge(world, wrong, ClaimOf("never_penetrates")),
                      MeasureKind::kPenetration));
  }
}

TEST(NeverPenetrates, GrantsASlidingBodyNoDepthForItsSpeedAlongThePlane) {
  World world = FallingBall();
  world.bodies[0].placed.X_WB.p_WB.y() = 0.5;
  world.bodies[0].v_WB = {20, 0, 0};
  const Trajectory sunk = Sampled(world, [&](double t) {
    WorldState state = StateAtStart(world);
    state.bodies[0].p_WB += Eigen::Vector3d(20 * t, t > 0.1 ? -0.02 : 0, 0);
    return state;
  });
  ASSERT_GT(1.5 * 20 * world.dt, 0.02);
  EXPECT_TRUE(
      Finds(Judge(world, sunk, ClaimOf("never_penetrates")), MeasureKind::kPenetration));
}

TEST(NeverPenetrates, ForgetsTheImpactSpeedAfterSeparation) {
  // It falls at 6 m/s to 1 cm above the ground and rests there; 0.44 s later it is 1 cm
  // deep.
  World world = FallingBall();
  world.bodies[0].v_WB = {0, -6, 0};
  const Trajectory sunk = Sampled(world, [&](double t) {
    WorldState state = StateAtStart(world);
    const double y = t < 0.16 ? 1.5 - 6 * t : t < 0.6 ? 0.51 : 0.49;
    state.bodies[0].p_WB.y() = y;
    state.bodies[0].v_WB.y() = t < 0.16 ? -6 : 0;
    return state;
  });
  ASSERT_GT(1.5 * 6 * world.dt, 0.01);
  EXPECT_TRUE(
      Finds(Judge(world, sunk, ClaimOf("never_penetrates")), MeasureKind::kPenetration));
}

/** The ball arrives at 6 m/s, at 0.167 s, and is as deep as `depth_at` says at each time
 from then on. [m, s] */
template <typename DepthAt>
Trajectory Arriving(const World& world, const DepthAt& depth_at) {
  return Sampled(world, [&](double t) {
    WorldState state = StateAtStart(world);
    const bool has_arrived = 1.5 - 6 * t <= 0.5;
    state.bodies[0].p_WB.y() = has_arrived ? 0.5 - depth_at(t) : 1.5 - 6 * t;
    state.bodies[0].v_WB.y() = has_arrived ? 0 : -6;
    return state;
  });
}

TEST(NeverPenetrates, GrantsTheSpeedOfAnArrivalForTwoStepsOnly) {
  World world = FallingBall();
  world.bodies[0].v_WB = {0, -6, 0};
  const double deep = 0.9 * 1.5 * 6 * world.dt;
  const double arrival = 1.0 / 6;
  // It stays as deep as the step of its arrival has left it.
  EXPECT_TRUE(Passes(Judge(world, Arriving(world, [&](double) { return deep; }),
                           ClaimOf("never_penetrates"))));
  // It is stopped at the surface, and sinks to the same depth by and by.
  const auto sinks_from = [&](double start, double over) {
    return Arriving(world, [=](double t) {
      return deep * std::clamp((t - arrival - start) / over, 1e-3, 1.0);
    });
  };
  EXPECT_TRUE(
      Passes(Judge(world, sinks_from(0, 1.5 * world.dt), ClaimOf("never_penetrates"))));
  for (const double over : {5 * world.dt, 0.5}) {
    EXPECT_TRUE(Finds(Judge(world, sinks_from(0.1, over), ClaimOf("never_penetrates")),
                      MeasureKind::kPenetration))
        << over;
  }
}

TEST(NeverPenetrates, SlowArrivalsDoNotProlongTheGrantOfAFastOne) {
  // A ball is stopped at the surface and rests a micrometre deep, and so does another one
  // on it. It sinks long after it has arrived, in one step or in several.
  World world = FallingBall();
  world.bodies[0].v_WB = {0, -6, 0};
  const double deep = 0.9 * 1.5 * 6 * world.dt;
  world.bodies.push_back(BodyOf("on it", Sphere{0.1}, 1, {0.2, 2.1 - 1e-6, -0.1}));
  world.bodies[2].v_WB = {0, -6, 0};
  for (const int steps : {1, 2, 4, 20}) {
    for (const bool is_loaded : {false, true}) {
      Trajectory sunk = Arriving(world, [&](double t) {
        return 1e-6 + deep * std::clamp((t - 0.5) / (steps * world.dt), 0.0, 1.0);
      });
      for (WorldState& state : sunk.samples) {
        state.bodies[2].p_WB.y() =
            state.bodies[0].p_WB.y() + (is_loaded ? 0.6 - 1e-6 : 5);
        state.bodies[2].v_WB = state.bodies[0].v_WB;
      }
      EXPECT_TRUE(Finds(Judge(world, sunk, ClaimOf("never_penetrates", {"ball"})),
                        MeasureKind::kPenetration))
          << steps << is_loaded;
    }
  }
}

TEST(NeverPenetrates, FindsABodyThatSinksSlowlyWhileAnotherBouncesOnIt) {
  World world = FallingBall();
  world.steps = 240;
  world.bodies[0].v_WB = {0, -6, 0};
  world.bodies.push_back(BodyOf("on it", Sphere{0.1}, 1, {0.2, 2.1 - 1e-6, -0.1}));
  world.bodies[2].v_WB = {0, -6, 0};
  for (const double speed : {0.02, 0.05, 0.2}) {
    for (const int every : {1, 3, 4, 5, 8}) {
      const double start = 0.3;
      const double deep = 0.9 * 1.5 * 6 * world.dt;
      Trajectory sunk = Arriving(world, [&](double t) {
        return 1e-6 + std::clamp(speed * (t - start), 0.0, deep);
      });
      for (std::size_t s = 0; s < sunk.samples.size(); ++s) {
        WorldState& state = sunk.samples[s];
        const double t = sunk.times[s];
        const bool sinks = t > start && speed * (t - start) < deep;
        if (sinks) state.bodies[0].v_WB.y() = -speed;
        const bool is_up = s % static_cast<std::size_t>(every) == 1;
        state.bodies[2].p_WB.y() =
            state.bodies[0].p_WB.y() + 0.6 + (is_up ? 1e-5 : -1e-6);
        state.bodies[2].v_WB = state.bodies[0].v_WB;
      }
      EXPECT_TRUE(Finds(Judge(world, sunk, ClaimOf("never_penetrates", {"ball"})),
                        MeasureKind::kPenetration))
          << speed << ' ' << every;
    }
  }
}

TEST(NeverPenetrates, GrantsAnArrivalOnABodyThatIsDeepAlready) {
  // It overlaps the ground by 5 cm, approaches it and is stopped one step later.
  World world = FallingBall();
  world.bodies[0].placed.X_WB.p_WB.y() = 0.45;
  world.bodies[0].v_WB = {0, -6, 0};
  const auto stopped_after = [&](int steps) {
    return Sampled(world, [&](double t) {
      WorldState state = StateAtStart(world);
      state.bodies[0].p_WB.y() -= 6 * std::min(t, steps * world.dt);
      if (t > (steps - 0.5) * world.dt) state.bodies[0].v_WB.setZero();
      return state;
    });
  };
  EXPECT_TRUE(Passes(Judge(world, stopped_after(1), ClaimOf("never_penetrates"))));
  EXPECT_TRUE(Finds(Judge(world, stopped_after(2), ClaimOf("never_penetrates")),
                    MeasureKind::kPenetration));
}

TEST(NeverPenetrates, GrantsAnArrivalAlongANormalThatTurns) {
  // A ball glances off another one. The direction of their depth turns between two
  // samples, so their depth along the last direction was more than 0 at the first.
  World world;
  world.gravity_W.setZero();
  world.dt = 1e-3;
  world.sample_every = 10;
  world.steps = 10;
  world.bodies = {BodyOf("a", Sphere{0.5}, 1, {0, 0, 0}),
                  BodyOf("b", Sphere{0.5}, 1, {1 + 1e-9, 0, 0})};
  world.bodies[1].v_WB = {-3, 5, 0};
  const Trajectory glances = Sampled(world, [&](double t) {
    WorldState state = StateAtStart(world);
    state.bodies[1].p_WB += Eigen::Vector3d(-0.3 * t, 5 * t, 0);
    return state;
  });
  const std::vector<LawFinding> findings =
      Judge(world, glances, ClaimOf("never_penetrates"));
  EXPECT_GT(findings[0].value, 1e-3);
  EXPECT_TRUE(Passes(findings));
}

TEST(NeverPenetrates, GrantsABodyTheArrivalOfAnotherOnIt) {
  // A ball hits another that has long rested on the ground, and drives it in.
  World world = FallingBall();
  RigidBody hammer = BodyOf("hammer", Sphere{0.5}, 3, {0.2, 4.5, -0.1});
  hammer.v_WB = {0, -6, 0};
  world.bodies[0].placed.X_WB.p_WB.y() = 0.5 - 1e-6;
  world.bodies.push_back(hammer);
  world.gravity_W.setZero();
  const double driven = 0.9 * 1.5 * 6 * world.dt;
  const auto motion = [&](bool is_hit) {
    return Sampled(world, [&](double t) {
      WorldState state = StateAtStart(world);
      BodyState& rests = state.bodies[0];
      BodyState& falls = state.bodies[2];
      const bool has_arrived = t >= 0.5;
      rests.p_WB.y() = 0.5 - (has_arrived ? driven : 1e-6);
      if (has_arrived) rests.v_WB.y() = falls.v_WB.y() = -6;
      falls.p_WB.y() = has_arrived ? 1.5 - driven - 1e-6 : 4.5 - 6 * t;
      if (!is_hit) falls.p_WB.x() += 5;
      return state;
    });
  };
  EXPECT_TRUE(Passes(Judge(world, motion(true), ClaimOf("never_penetrates", {"ball"}))));
  EXPECT_TRUE(Finds(Judge(world, motion(false), ClaimOf("never_penetrates", {"ball"})),
                    MeasureKind::kPenetration));
}

TEST(NeverPenetrates, GrantsTheInitialPenetration) {
  World world = FallingBall();
  world.bodies[0].placed.X_WB.p_WB.y() = 0.4;
  const Trajectory still = Stepped(world, [](WorldState&) {});
  EXPECT_TRUE(Passes(Judge(world, still, ClaimOf("never_penetrates"))));
}

TEST(NeverPenetrates, GrantsTheInitialPenetrationForAsLongAsTheClaimSays) {
  World world = FallingBall();
  world.gravity_W.setZero();
  world.bodies[0].placed.X_WB.p_WB.y() = 0.4;
  const double half = world.steps * world.dt / 2;
  const Claim parts = ClaimOf("never_penetrates", {}, {{"parted_by", half}});
  const Trajectory still = Stepped(world, [](WorldState&) {});
  EXPECT_TRUE(Finds(Judge(world, still, parts), MeasureKind::kPenetration));
  const Trajectory pushed_out = Stepped(world, [](WorldState& state) {
    double& y = state.bodies[0].p_WB.y();
    y = std::min(0.5, y + 0.1 / 200);
  });
  EXPECT_TRUE(Passes(Judge(world, pushed_out, parts)));
  const Claim at_the_end =
      ClaimOf("never_penetrates", {}, {{"parted_by", world.steps * world.dt}});
  EXPECT_FALSE(FindLaw("never_penetrates")->faults(world, at_the_end).empty());
}

TEST(NeverPenetrates, IgnoresBodiesThatDoNotCollide) {
  World world = FallingBall();
  world.bodies[0].collides = false;
  EXPECT_TRUE(Judge(world, StoppingAt(world, 100), ClaimOf("never_penetrates")).empty());
}

TEST(NeverPenetrates, MeasuresPairsOfBoxesAndOfSpheres) {
  World world;
  world.gravity_W.setZero();
  world.bodies = {BodyOf("a", Box{{0.5, 0.5, 0.5}}, 1, {0, 0, 0}),
                  BodyOf("b", Box{{0.5, 0.5, 0.5}}, 1, {0.9, 0.3, 0.2}),
                  BodyOf("c", Sphere{0.5}, 1, {5, 0, 0}),
                  BodyOf("d", Sphere{0.5}, 1, {5.7, 0, 0})};
  world.steps = 1;
  // Apart at the start, overlapping after one step.
  const Trajectory overlapping = Sampled(world, [&](double) {
    WorldState state;
    for (const RigidBody& body : world.bodies) {
      state.bodies.push_back(
          {body.placed.X_WB.p_WB, Eigen::Quaterniond::Identity(), {0, 0, 0}, {0, 0, 0}});
    }
    return state;
  });
  world.bodies[1].placed.X_WB.p_WB.x() = 2;
  world.bodies[3].placed.X_WB.p_WB.x() = 7;
  EXPECT_NEAR(Judge(world, overlapping, ClaimOf("never_penetrates", {"a"}))[0].value, 0.1,
              1e-9);
  EXPECT_NEAR(Judge(world, overlapping, ClaimOf("never_penetrates", {"d"}))[0].value, 0.3,
              1e-12);
}

TEST(TurnsOnce, never_penetrates) {
  const World world = FallingBall();
  EXPECT_TRUE(TurnsOnce(world, StoppingAt(world, 0), ClaimOf("never_penetrates")));
}

TEST(NeverPenetrates, GrantsATileNoDepthForItsSlidingAndItsSpin) {
  // A tile of 4 cm slides at 20 m/s, or spins about the normal, and sinks 3 mm a step.
  World world;
  world.bodies = {BodyOf("tile", Box{{0.3, 0.02, 0.3}}, 1, {0, 0.02, 0}), GroundOf()};
  world.dt = 1.0 / 60;
  world.steps = 10;
  for (const bool slides : {true, false}) {
    RigidBody& tile = world.bodies[0];
    tile.v_WB = {slides ? 20.0 : 0.0, 0, 0};
    tile.w_WB = {0, slides ? 0.0 : 40.0, 0};
    for (const int sample_every : {1, 5}) {
      world.sample_every = sample_every;
      const auto sunk = [&](double each_step) {
        return Sampled(world, [&](double t) {
          WorldState state = StateAtStart(world);
          BodyState& is = state.bodies[0];
          is.p_WB += t * tile.v_WB - Eigen::Vector3d(0, each_step * t / world.dt, 0);
          is.q_WB = Turned(is.q_WB, t * tile.w_WB);
          return state;
        });
      };
      EXPECT_TRUE(Passes(Judge(world, sunk(0), ClaimOf("never_penetrates"))));
      EXPECT_TRUE(Finds(Judge(world, sunk(3e-3), ClaimOf("never_penetrates")),
                        MeasureKind::kPenetration))
          << slides << sample_every;
    }
  }
}

TEST(NeverPenetrates, GrantsTheSpeedOfACornerThatComesDown) {
  // A plank turns about its far end; its near end comes down at 4 m/s.
  World world;
  const double tilt = 0.02;
  RigidBody plank = BodyOf("plank", Box{{1, 0.02, 0.1}}, 1, {0, 0, 0});
  const Eigen::Quaterniond q_WB = Turned(Eigen::Quaterniond::Identity(), {0, 0, -tilt});
  const Eigen::Vector3d near_W = q_WB * Eigen::Vector3d(1, -0.02, 0);
  plank.placed.X_WB = Pose::FromQuaternion({0, 1e-4 - near_W.y(), 0}, q_WB);
  plank.w_WB = {0, 0, -2};
  plank.v_WB = {0, -2, 0};
  world.bodies = {plank, GroundOf()};
  world.steps = 1;
  const Trajectory landed = Stepped(world, [&](WorldState& state) {
    BodyState& is = state.bodies[0];
    is.p_WB += world.dt * plank.v_WB;
    is.q_WB = Turned(is.q_WB, world.dt * plank.w_WB);
    is.v_WB.setZero();
    is.w_WB.setZero();
  });
  const LawFinding found =
      Of(Judge(world, landed, ClaimOf("never_penetrates")), MeasureKind::kPenetration);
  EXPECT_NEAR(found.value, 4 * world.dt, 0.02 * 4 * world.dt);
  EXPECT_LE(found.value, found.tolerance.value);
  EXPECT_LE(found.tolerance.value, 1.6 * found.value);
}

}  // namespace
}  // namespace touchstone
