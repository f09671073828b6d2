#include <cmath>

#include <gtest/gtest.h>

#include "reports/worlds/truth/damped_flight.h"
#include "tests/reports/worlds/motions.h"
#include "tests/reports/worlds/runge_kutta.h"

namespace touchstone {
namespace {

const Eigen::Vector3d kGravity(0.3, -9.82, 0.1);

World Thrown(double damping, double dt = 1.0 / 240) {
  World world;
  world.particles.push_back({"dust", {0.1, 2, -0.3}, {3, 4, -1}, 0.2, damping, 0.7});
  world.gravity_W = kGravity;
  world.dt = dt;
  world.steps = static_cast<int>(std::lround(2 / dt));
  return world;
}

TEST(DampedFlight, AgreesWithAnIntegration) {
  using State = Eigen::Matrix<double, 6, 1>;
  State start;
  start << 0.1, 2, -0.3, 3, 4, -1;
  for (const double c : {0.0, 1e-9, 4e-3, 0.3, 5.0}) {
    const auto field = [&](const State& y) {
      State rate;
      rate << y.tail<3>(), kGravity - c * y.tail<3>();
      return rate;
    };
    for (const double t : {0.01, 2.4}) {
      const State y = Integrated(field, start, t, 400);
      const PointState at =
          DampedFlight({start.head<3>(), start.tail<3>()}, kGravity, c, t);
      EXPECT_LE((at.p_W - y.head<3>()).norm(), 1e-10) << c << " " << t;
      EXPECT_LE((at.v_W - y.tail<3>()).norm(), 1e-10) << c << " " << t;
    }
  }
}

Trajectory Flown(const World& world, const FlightScheme& scheme, double damping) {
  return Stepped(world, [&world, scheme, damping](WorldState& state) {
    StepFlight(scheme, world.gravity_W, damping, world.dt, state.particles[0]);
  });
}

TEST(BallisticOfDampedParticles, TheTruthAndEverySchemePass) {
  for (const double dt : {1.0 / 60, 1e-3}) {
    const World world = Thrown(0.8, dt);
    const Trajectory exact = Sampled(world, [&](double t) {
      WorldState state;
      state.particles = {DampedFlight({world.particles[0].p_W, world.particles[0].v_W},
                                      world.gravity_W, 0.8, t)};
      return state;
    });
    EXPECT_TRUE(Passes(Judge(world, exact, ClaimOf("ballistic"))));
    for (const FlightScheme& scheme : FlightSchemes()) {
      EXPECT_TRUE(Passes(Judge(world, Flown(world, scheme, 0.8), ClaimOf("ballistic"))));
    }
  }
}

TEST(BallisticOfDampedParticles, FindsDampingPerStepInsteadOfPerSecond) {
  // Millington's printed form keeps `damping` of the velocity: here e^{-0.8} read as 0.8.
  const World world = Thrown(0.8);
  EXPECT_TRUE(Finds(Judge(world, Flown(world, {}, -std::log(0.8)), ClaimOf("ballistic")),
                    MeasureKind::kVelocityError));
  EXPECT_TRUE(Finds(Judge(world, Flown(world, {}, 0.82), ClaimOf("ballistic")),
                    MeasureKind::kPositionError));
}

TEST(BallisticOfDampedParticles, KnowsItsNumberAndRefusesHeldParticles) {
  World world = Thrown(0.8);
  EXPECT_TRUE(
      FaultsOf(world, ClaimOf("ballistic", {"dust"},
                              {{"expected_terminal_speed", kGravity.norm() / 0.8}}))
          .empty());
  world.springs.push_back({{AnchorKind::kWorld, -1, {0, 0, 0}},
                           {AnchorKind::kParticle, 0, {0, 0, 0}},
                           1,
                           0,
                           1});
  EXPECT_EQ(FaultsOf(world, ClaimOf("ballistic")).size(), 1U);
}

TEST(BallisticOfDampedParticles, JudgesThemBesideBodiesWithoutDamping) {
  World world = Thrown(0.8);
  world.bodies = {BodyOf("ball", Sphere{0.5}, 1, {0, 1, 0})};
  const auto flown = [&](double drag_of_ball) {
    return Stepped(world, [&world, drag_of_ball](WorldState& state) {
      StepFlight({}, world.gravity_W, 0.8, world.dt, state.particles[0]);
      BodyState& ball = state.bodies[0];
      PointState is{ball.p_WB, ball.v_WB};
      StepFlight({}, world.gravity_W, drag_of_ball, world.dt, is);
      ball.p_WB = is.p_W;
      ball.v_WB = is.v_W;
    });
  };
  EXPECT_TRUE(Passes(Judge(world, flown(0), ClaimOf("ballistic"))));
  const std::vector<LawFinding> found = Judge(world, flown(1e-6), ClaimOf("ballistic"));
  EXPECT_TRUE(Finds(found, MeasureKind::kVelocityError));
  // The ball is granted nothing for the damping of the particle.
  const LawFinding velocity = Of(found, MeasureKind::kVelocityError);
  EXPECT_EQ(velocity.grants, Grants::kRounding);
  EXPECT_EQ(velocity.tolerance.because, "64 roundings per step");
}

TEST(BallisticOfDampedParticles, RefusesATerminalSpeedThatIsNotThatOfAll) {
  World world = Thrown(0.8);
  const Claim claim =
      ClaimOf("ballistic", {}, {{"expected_terminal_speed", kGravity.norm() / 0.8}});
  EXPECT_TRUE(FaultsOf(world, claim).empty());
  world.particles.push_back(world.particles.front());
  world.particles.back().name = "smoke";
  EXPECT_TRUE(FaultsOf(world, claim).empty());
  world.particles.back().damping = 0.4;
  EXPECT_EQ(FaultsOf(world, claim).size(), 1U);
  world.particles.back().damping = 0;
  EXPECT_EQ(FaultsOf(world, claim).size(), 1U);
}

World Dropped(double bounce) {
  World world;
  world.particles.push_back({"grain", {0.2, 1, -0.1}, {0.4, 0, 0.1}, 0.2, 0, bounce});
  world.bodies = {GroundOf()};
  world.gravity_W = {0, -9.81, 0};
  world.steps = 960;
  return world;
}

/** `along` is the fraction of the tangential velocity that remains. */
Trajectory Bounced(const World& world, double bounce, double along = 1) {
  return Stepped(world, [&world, bounce, along](WorldState& state) {
    PointState& grain = state.particles[0];
    const double gh = 9.81 * world.dt;
    double& v = grain.v_W.y();
    if (grain.p_W.y() <= 0 && v < gh) {
      v = std::max(v - gh, -bounce * v);
      grain.v_W.x() *= along;
      grain.v_W.z() *= along;
    } else {
      v -= gh;
    }
    grain.p_W += world.dt * grain.v_W;
  });
}

TEST(BounceSeriesOfParticles, ASteppedMotionPasses) {
  for (const double bounce : {0.0, 0.5, 0.9}) {
    const World world = Dropped(bounce);
    EXPECT_TRUE(Passes(Judge(world, Bounced(world, bounce), ClaimOf("bounce_series"))))
        << bounce;
  }
}

TEST(BounceSeriesOfParticles, FindsAnotherRestitutionAndFriction) {
  const World world = Dropped(0.7);
  EXPECT_TRUE(Finds(Judge(world, Bounced(world, 0.8), ClaimOf("bounce_series")),
                    MeasureKind::kRestitution));
  EXPECT_TRUE(Finds(Judge(world, Bounced(world, 0.7, 0.7), ClaimOf("bounce_series")),
                    MeasureKind::kPositionError));
}

/** A grain and a ball, which fall side by side; the ball first if `ball_first`. Each rule
 is that of one of them: its velocity after gravity is reflected, or the one before. */
std::vector<LawFinding> JudgedTogether(bool grain_after, bool ball_after) {
  World world = Dropped(0.8);
  RigidBody ball = BodyOf("ball", Sphere{0.25}, 1, {2, 3.25, 0});
  ball.restitution = 0.8;
  world.bodies.insert(world.bodies.begin(), ball);
  world.bodies[1].restitution = 1;
  const double gh = 9.81 * world.dt;
  const auto step = [gh](double gap, double& v, bool after) {
    if (gap <= 0 && v < gh)
      v = after ? -0.8 * (v - gh) : std::max(v - gh, -0.8 * v);
    else
      v -= gh;
  };
  const Trajectory motion = Stepped(world, [&](WorldState& state) {
    PointState& grain = state.particles[0];
    BodyState& is = state.bodies[0];
    step(grain.p_W.y(), grain.v_W.y(), grain_after);
    step(is.p_WB.y() - 0.25, is.v_WB.y(), ball_after);
    grain.p_W += world.dt * grain.v_W;
    is.p_WB += world.dt * is.v_WB;
  });
  return Judge(world, motion, ClaimOf("bounce_series", {"grain", "ball"}));
}

TEST(BounceSeriesOfParticles, AreJudgedBesideBodies) {
  EXPECT_TRUE(Passes(JudgedTogether(false, false)));
}

TEST(BounceSeriesOfParticles, AllFallsMustFollowTheRecognisedRule) {
  EXPECT_EQ(Of(JudgedTogether(true, true), MeasureKind::kPositionError).recognised,
            "reflects the velocity after gravity");
  for (const bool grain_after : {false, true}) {
    const LawFinding found =
        Of(JudgedTogether(grain_after, !grain_after), MeasureKind::kPositionError);
    EXPECT_TRUE(IsBeyond(found)) << grain_after;
    EXPECT_EQ(found.recognised, "") << grain_after;
  }
}

TEST(BounceSeriesOfParticles, KnowsItsNumbersAndRefusesDampedParticles) {
  World world = Dropped(0.8);
  EXPECT_TRUE(FaultsOf(world, ClaimOf("bounce_series", {},
                                      {{"expected_first_apex", 0.64},
                                       {"expected_total_time", 4.063712769}}))
                  .empty());
  world.particles[0].damping = 0.1;
  EXPECT_EQ(FaultsOf(world, ClaimOf("bounce_series")).size(), 1U);
}

TEST(TurnsOnce, ballistic_of_a_damped_particle) {
  const World world = Thrown(0.8);
  EXPECT_TRUE(
      TurnsOnce(world, Flown(world, FlightSchemes()[0], 0.8), ClaimOf("ballistic")));
}

TEST(TurnsOnce, bounce_series_of_a_particle) {
  const World world = Dropped(0.5);
  EXPECT_TRUE(TurnsOnce(world, Bounced(world, 0.5), ClaimOf("bounce_series")));
}

}  // namespace
}  // namespace touchstone
