#include <cmath>

#include <gtest/gtest.h>

#include "reports/worlds/truth/vertical_bounces.h"
#include "tests/reports/worlds/motions.h"

namespace touchstone {
namespace {

World DroppedBall(double e, double dt = 1.0 / 240, int seconds = 6) {
  World world;
  RigidBody ball = BodyOf("ball", Sphere{0.5}, 3, {0.2, 1.5, -0.1});
  ball.restitution = e;
  RigidBody ground = GroundOf();
  ground.restitution = 1;
  world.bodies = {ball, ground};
  world.dt = dt;
  world.steps = static_cast<int>(std::lround(seconds / dt));
  return world;
}

/** `leave` returns the velocity after a step in contact, from the one before and g h. */
template <typename Leave>
Trajectory Bounced(const World& world, const Leave& leave) {
  return Stepped(world, [&world, leave](WorldState& state) {
    BodyState& ball = state.bodies[0];
    double& v = ball.v_WB.y();
    const double gh = 9.82 * world.dt;
    v = ball.p_WB.y() <= 0.5 && v - gh < 0 ? leave(v, gh) : v - gh;
    ball.p_WB.y() += world.dt * v;
  });
}

Trajectory ReflectingTheStart(const World& world, double e) {
  return Bounced(world, [e](double v, double gh) { return std::max(v - gh, -e * v); });
}

Trajectory ReflectingAfterGravity(const World& world, double e) {
  return Bounced(world, [e](double v, double gh) { return -e * (v - gh); });
}

Trajectory Exactly(const World& world, double e) {
  const VerticalBounces truth({1, 0}, 9.82, e);
  return Sampled(world, [&world, truth](double t) {
    const Height at = truth.At(t);
    WorldState state;
    state.bodies = {
        {{0.2, 0.5 + at.gap, -0.1},
         Eigen::Quaterniond::Identity(),
         {0, at.velocity, 0},
         {0, 0, 0}},
        {{0, 0, 0}, world.bodies[1].placed.X_WB.q_WB.value(), {0, 0, 0}, {0, 0, 0}}};
    return state;
  });
}

TEST(VerticalBounces, HasTheClosedFormsOfTheSeries) {
  const double g = 9.81;
  const VerticalBounces truth({1, 0}, g, 0.8);
  EXPECT_NEAR(truth.first_impact(), 0.451523641, 1e-9);
  EXPECT_NEAR(truth.impact_speed(), 4.429446918, 1e-9);
  EXPECT_NEAR(truth.total_time(), 4.063712769, 1e-9);
  EXPECT_EQ(truth.At(5).gap, 0);
  // The apex of the n-th flight is e²ⁿ, half a flight after its start.
  double start = truth.first_impact();
  for (int n = 1; n < 8; ++n) {
    const double flight = 2 * truth.impact_speed() * std::pow(0.8, n) / g;
    const Height apex = truth.At(start + flight / 2);
    EXPECT_NEAR(apex.gap, std::pow(0.8, 2 * n), 1e-12);
    EXPECT_NEAR(apex.velocity, 0, 1e-12);
    start += flight;
  }
}

TEST(VerticalBounces, AgreesWithAnEventLoop) {
  for (const double e : {0.0, 0.3, 0.9, 1.0}) {
    const VerticalBounces truth({0.7, 1.2}, 9.82, e);
    double gap = 0.7;
    double v = 1.2;
    double from = 0;
    for (int k = 1; k <= 500; ++k) {
      const double t = 0.0071 * k;
      double end = (v + std::sqrt(v * v + 2 * 9.82 * gap)) / 9.82;
      while (from + end < t && v * v + gap > 1e-12) {
        from += end;
        v = e * (9.82 * end - v);
        gap = 0;
        end = 2 * v / 9.82;
      }
      const double since = t - from;
      const double expected =
          v * v + gap > 1e-12 ? gap + v * since - 4.91 * since * since : 0;
      EXPECT_NEAR(truth.At(t).gap, expected, 1e-9) << e << " " << t;
    }
  }
}

TEST(BounceSeries, FindsAWrongFallInTheFewStepsBeforeTheFirstImpact) {
  // 0.45 s are 27 steps of 1/60 s. Half a step's fall is 4 % of that, more than the
  // planted error.
  const World world = DroppedBall(0.8, 1.0 / 60);
  const auto after = [&](double slower, double later) {
    return Sampled(world, [&, slower, later](double t) {
      WorldState state = Exactly(world, 0.8).samples.front();
      const Height at = VerticalBounces({1, 0}, slower * 9.82, 0.8)
                            .At(std::max(0.0, t - later * world.dt));
      state.bodies[0].p_WB.y() = 0.5 + at.gap;
      state.bodies[0].v_WB.y() = at.velocity;
      return state;
    });
  };
  EXPECT_TRUE(Passes(Judge(world, after(1, 0), ClaimOf("bounce_series"))));
  for (const auto& [slower, later] : {std::pair(0.98, 0.0), std::pair(1.0, 0.1)}) {
    const std::vector<LawFinding> findings =
        Judge(world, after(slower, later), ClaimOf("bounce_series"));
    EXPECT_FALSE(Finds(findings, MeasureKind::kPositionError));
    EXPECT_TRUE(Finds(findings, MeasureKind::kVelocityError));
  }
}

TEST(BounceSeries, TheTruthAndTheStartOfStepRulePass) {
  for (const double e : {0.0, 0.5, 0.9, 1.0}) {
    for (const double dt : {1.0 / 60, 1.0 / 240, 1e-3}) {
      const World world = DroppedBall(e, dt);
      EXPECT_TRUE(Passes(Judge(world, Exactly(world, e), ClaimOf("bounce_series")))) << e;
      EXPECT_TRUE(
          Passes(Judge(world, ReflectingTheStart(world, e), ClaimOf("bounce_series"))))
          << e << " " << dt;
    }
  }
}

TEST(BounceSeries, RecognisesTheRuleThatReflectsAfterGravity) {
  World world = DroppedBall(1, 1.0 / 240, 20);
  for (const int sample_every : {1, 3}) {
    world.sample_every = sample_every;
    const std::vector<LawFinding> findings =
        Judge(world, ReflectingAfterGravity(world, 1), ClaimOf("bounce_series"));
    const LawFinding position = Of(findings, MeasureKind::kPositionError);
    EXPECT_GT(position.value, position.tolerance.value);
    EXPECT_EQ(position.recognised, "reflects the velocity after gravity");
  }
}

TEST(BounceSeries, DoesNotRecogniseARuleThatNoBounceShows) {
  // With e = 0 both rules leave no speed.
  const World world = DroppedBall(0);
  Trajectory lifted = ReflectingAfterGravity(world, 0);
  for (std::size_t s = 1; s < lifted.samples.size(); ++s)
    lifted.samples[s].bodies[0].p_WB.y() += 0.3;
  EXPECT_TRUE(
      Finds(Judge(world, lifted, ClaimOf("bounce_series")), MeasureKind::kPositionError));
}

TEST(BounceSeries, RecognisesOnlyThePositionsOfTheRule) {
  const World world = DroppedBall(1, 1.0 / 240, 20);
  const Trajectory right = ReflectingAfterGravity(world, 1);
  for (const Eigen::Vector3d& off :
       {Eigen::Vector3d(0, 40, 0), Eigen::Vector3d(9, 0, 0), Eigen::Vector3d(0, 0, -9)}) {
    Trajectory moved = right;
    for (std::size_t s = moved.samples.size() / 2; s < moved.samples.size(); ++s)
      moved.samples[s].bodies[0].p_WB += off;
    EXPECT_TRUE(
        Finds(Judge(world, moved, ClaimOf("bounce_series")), MeasureKind::kPositionError))
        << off.transpose();
  }
  Trajectory early = right;
  for (std::size_t s = 1; s < 20; ++s) early.samples[s].bodies[0].p_WB.y() += 0.1;
  EXPECT_TRUE(
      Finds(Judge(world, early, ClaimOf("bounce_series")), MeasureKind::kPositionError));
}

TEST(BounceSeries, DoesNotRecogniseAGainOfAnotherKind) {
  const World world = DroppedBall(1, 1.0 / 240, 20);
  const Trajectory gaining =
      Bounced(world, [](double v, double gh) { return -(v - 0.7 * gh); });
  EXPECT_TRUE(Finds(Judge(world, gaining, ClaimOf("bounce_series")),
                    MeasureKind::kPositionError));
}

TEST(BounceSeries, FindsRestitutionOffByATenth) {
  const World world = DroppedBall(0.5);
  const std::vector<LawFinding> findings =
      Judge(world, ReflectingTheStart(world, 0.6), ClaimOf("bounce_series"));
  EXPECT_TRUE(Finds(findings, MeasureKind::kRestitution));
  EXPECT_TRUE(Finds(findings, MeasureKind::kPositionError));
}

TEST(BounceSeries, MeasuresTheRestitutionOfExactFlightsToRounding) {
  // Gravity alone changes the speeds around an impact by up to g Δt/V, 4 % at 1/60 s.
  for (const double e : {0.0, 0.5, 0.8, 1.0}) {
    for (const double dt : {1.0 / 60, 0.01, 1.0 / 240, 1e-3}) {
      const World world = DroppedBall(e, dt, 2);
      const std::vector<LawFinding> findings =
          Judge(world, Exactly(world, e), ClaimOf("bounce_series"));
      EXPECT_LE(Of(findings, MeasureKind::kRestitution).value, 1e-13) << e << " " << dt;
    }
  }
}

TEST(BounceSeries, MeasuresTheRestitutionOfALateImpactButFindsItsPosition) {
  // It falls 0.2 m into the ground: later than the tolerance of the position allows, V h
  // = 2 cm.
  World world = DroppedBall(0.8, 1.0 / 240, 1);
  const VerticalBounces late({1.2, 0}, 9.82, 0.8);
  const Trajectory sunk = Sampled(world, [&](double t) {
    WorldState state = Exactly(world, 0.8).samples.front();
    state.bodies[0].p_WB.y() = 0.3 + late.At(t).gap;
    state.bodies[0].v_WB.y() = late.At(t).velocity;
    return state;
  });
  const std::vector<LawFinding> findings = Judge(world, sunk, ClaimOf("bounce_series"));
  EXPECT_LE(Of(findings, MeasureKind::kRestitution).value, 1e-13);
  EXPECT_TRUE(Finds(findings, MeasureKind::kPositionError));
}

TEST(BounceSeries, FindsARestitutionErrorBelowGravitysEffectOnTheSamples) {
  // Off by 0.03. Gravity changes either sample by g Δt/V = 0.037, four steps apart.
  World world = DroppedBall(0.5, 1.0 / 240, 1);
  world.sample_every = 4;
  EXPECT_TRUE(Finds(Judge(world, Exactly(world, 0.53), ClaimOf("bounce_series")),
                    MeasureKind::kRestitution));
}

TEST(BounceSeries, FindsABodyThatDoesNotBounce) {
  const World world = DroppedBall(0.5);
  EXPECT_TRUE(Finds(Judge(world, ReflectingTheStart(world, 0), ClaimOf("bounce_series")),
                    MeasureKind::kRestitution));
}

TEST(BounceSeries, AllowsDepthCorrection) {
  // That raises the flight after the impact by V h at most, and so moves its intersection
  // with the one before by h/(1 + e).
  for (const double e : {0.05, 0.1, 0.2, 0.5, 0.8}) {
    for (int k = 0; k < 40; ++k) {
      World world = DroppedBall(e, 1.0 / 240, 2);
      world.sample_every = 4;
      world.bodies[0].placed.X_WB.p_WB.y() = 1 + 0.013 * k;
      const Trajectory lifted = Stepped(world, [&](WorldState& state) {
        BodyState& ball = state.bodies[0];
        double& v = ball.v_WB.y();
        const double gh = 9.82 * world.dt;
        const bool strikes = ball.p_WB.y() <= 0.5 && v - gh < 0;
        v = !strikes ? v - gh : -v > gh ? std::max(v - gh, -e * v) : 0;
        ball.p_WB.y() += world.dt * v;
        if (strikes) ball.p_WB.y() = std::max(ball.p_WB.y(), 0.5);
      });
      const std::vector<LawFinding> findings =
          Judge(world, lifted, ClaimOf("bounce_series"));
      EXPECT_FALSE(Finds(findings, MeasureKind::kRestitution)) << e << " " << k;
    }
  }
}

TEST(BounceSeries, FindsABodyThatDoesNotBounceAtAnyPhaseOfItsImpact) {
  // A flight that leads to where it lies would leave with g (Δt − τ): 0.1 of V if its
  // apex is there. world/bounce/restitution_sweep has these numbers.
  for (const double height : {0.8, 0.9, 1.0, 1.1, 1.2}) {
    World world = DroppedBall(0.1, 0.002, 2);
    world.sample_every = 25;
    world.bodies[0].placed.X_WB.p_WB.y() = 0.5 + height;
    const VerticalBounces dead({height, 0}, 9.82, 0);
    const Trajectory lies = Sampled(world, [&](double t) {
      WorldState state = Exactly(world, 0).samples.front();
      state.bodies[0].p_WB.y() = 0.5 + dead.At(t).gap;
      state.bodies[0].v_WB.y() = dead.At(t).velocity;
      return state;
    });
    EXPECT_TRUE(
        Finds(Judge(world, lies, ClaimOf("bounce_series")), MeasureKind::kRestitution))
        << height;
  }
}

TEST(BounceSeries, FindsAThresholdThatEndsSlowBounces) {
  const World world = DroppedBall(0.8);
  const Trajectory thresholded = Bounced(world, [](double v, double gh) {
    return -v < 2 ? std::max(v - gh, 0.0) : -0.8 * v;
  });
  EXPECT_TRUE(Finds(Judge(world, thresholded, ClaimOf("bounce_series")),
                    MeasureKind::kRestitution));
}

TEST(BounceSeries, FindsSidewaysDrift) {
  const World world = DroppedBall(1);
  Trajectory drifting = Exactly(world, 1);
  for (std::size_t s = 0; s < drifting.samples.size(); ++s)
    drifting.samples[s].bodies[0].p_WB.x() += 0.1 * drifting.times[s] * drifting.times[s];
  EXPECT_TRUE(Finds(Judge(world, drifting, ClaimOf("bounce_series")),
                    MeasureKind::kPositionError));
}

TEST(BounceSeries, KnowsItsNumbers) {
  World world = DroppedBall(0.8);
  world.gravity_W = {0, -9.81, 0};
  EXPECT_TRUE(FaultsOf(world, ClaimOf("bounce_series", {"ball"},
                                      {{"expected_total_time", 4.063712769},
                                       {"expected_first_apex", 0.64},
                                       {"expected_impact_speed", 4.429446918}}))
                  .empty());
  EXPECT_FALSE(
      FaultsOf(world, ClaimOf("bounce_series", {"ball"}, {{"expected_first_apex", 0.65}}))
          .empty());
}

TEST(BounceSeries, RefusesBodiesThatDoNotFallStraight) {
  World world = DroppedBall(0.8);
  world.bodies[0].v_WB = {0.1, 0, 0};
  EXPECT_FALSE(FaultsOf(world, ClaimOf("bounce_series")).empty());
  world.bodies[0].v_WB.setZero();
  world.bodies[0].placed.X_WB.p_WB.y() = -3;
  EXPECT_FALSE(FaultsOf(world, ClaimOf("bounce_series")).empty());
}

TEST(ConservesEnergy, ElasticBouncesPassOrTheRuleIsRecognised) {
  const World world = DroppedBall(1, 1.0 / 240, 20);
  const Claim claim = ClaimOf("conserves_energy");
  EXPECT_TRUE(Passes(Judge(world, Exactly(world, 1), claim)));
  EXPECT_TRUE(Passes(Judge(world, ReflectingTheStart(world, 1), claim)));
  EXPECT_EQ(
      Of(Judge(world, ReflectingAfterGravity(world, 1), claim), MeasureKind::kEnergyDrift)
          .recognised,
      "reflects the velocity after gravity");
  const Trajectory gaining =
      Bounced(world, [](double v, double gh) { return -(v - 0.7 * gh); });
  EXPECT_TRUE(Finds(Judge(world, gaining, claim), MeasureKind::kEnergyDrift));
}

TEST(EnergyNeverRises, BouncesPassOrTheRuleIsRecognised) {
  const Claim claim = ClaimOf("energy_never_rises");
  for (const double e : {0.3, 0.9, 1.0}) {
    const World world = DroppedBall(e, 1.0 / 240, 20);
    EXPECT_TRUE(Passes(Judge(world, Exactly(world, e), claim))) << e;
    EXPECT_TRUE(Passes(Judge(world, ReflectingTheStart(world, e), claim))) << e;
  }
  const World world = DroppedBall(1, 1.0 / 240, 20);
  EXPECT_EQ(
      Of(Judge(world, ReflectingAfterGravity(world, 1), claim), MeasureKind::kEnergyDrift)
          .recognised,
      "reflects the velocity after gravity");
}

TEST(TurnsOnce, bounce_series) {
  const World world = DroppedBall(0.5, 1.0 / 240, 3);
  EXPECT_TRUE(TurnsOnce(world, Exactly(world, 0.5), ClaimOf("bounce_series")));
}

TEST(TurnsOnce, energy_never_rises_of_a_bouncing_ball) {
  const World world = DroppedBall(0.5);
  EXPECT_TRUE(TurnsOnce(world, Exactly(world, 0.5), ClaimOf("energy_never_rises")));
}

}  // namespace
}  // namespace touchstone
