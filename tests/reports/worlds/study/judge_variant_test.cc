#include "reports/worlds/study/judge_variant.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reports/worlds/study/run_worlds.h"
#include "reports/worlds/study/world_variants.h"
#include "tests/reports/worlds/motions.h"
#include "tests/reports/worlds/study/studied.h"

namespace touchstone {
namespace {

using testing::HasSubstr;

TEST(JudgeVariant, PassesIfAllVariantsMoveAlike) {
  const FakeSimulator engine = OffBy(0, 1);
  const Studied studied(TwoBallsInFlight(), engine);
  for (const WorldVariant& variant : VariantsOf(studied.scenario.world)) {
    const Finding finding =
        JudgeVariant(studied.study(), {}, variant.measure,
                     SeenInWorld(variant, engine.Simulate(variant.world)));
    EXPECT_EQ(finding.verdict, Verdict::kPass)
        << NameOf(variant.measure) << ": " << finding.proof;
  }
}

TEST(JudgeVariant, FindsAnErrorAlongOneAxisOfTheWorldByTheHeading) {
  const FakeSimulator engine = OffBy(1e-3, 0);
  const Studied studied(TwoBallsInFlight(), engine);
  const std::vector<WorldVariant> variants = VariantsOf(studied.scenario.world);
  ASSERT_EQ(variants.front().measure, MeasureKind::kHeading);
  const Finding finding = JudgeVariant(
      studied.study(), {}, MeasureKind::kHeading,
      SeenInWorld(variants.front(), engine.Simulate(variants.front().world)));
  EXPECT_EQ(finding.verdict, Verdict::kFail);
  EXPECT_THAT(finding.proof, HasSubstr("turned about gravity"));
  EXPECT_THAT(finding.proof, HasSubstr(" m of distance + angle × radius: at "));
  EXPECT_THAT(finding.proof,
              HasSubstr("in the world itself and in the variant mapped back"));
}

TEST(JudgeVariant, AllowsTheDiscretisationError) {
  const FakeSimulator engine = OffBy(1e-3, 1);
  const Studied studied(TwoBallsInFlight(), engine);
  const std::vector<WorldVariant> variants = VariantsOf(studied.scenario.world);
  const Finding finding = JudgeVariant(
      studied.study(), {}, MeasureKind::kHeading,
      SeenInWorld(variants.front(), engine.Simulate(variants.front().world)));
  EXPECT_GT(finding.value, 1e-6);
  EXPECT_EQ(finding.verdict, Verdict::kPass) << finding.proof;
}

TEST(JudgeVariant, AllowsRoundingTimesTheGain) {
  const Studied studied(TwoBallsInFlight(), OffBy(0, 1));
  const auto tolerance = [&](double gain) {
    return JudgeVariant(studied.study(), {gain, gain}, MeasureKind::kHeading,
                        studied.whole)
        .tolerance;
  };
  EXPECT_NEAR(tolerance(10), 10 * tolerance(1), 1e-3 * tolerance(1));
}

TEST(JudgeVariant, GrantsNoMoreThanAStartMovedByAllRoundingsChanges) {
  // One rounding moves the body by 40 µm. If each of the roundings of two motions of a
  // hundred steps did so, they would explain a difference of 8 mm.
  const Studied studied(TwoBallsInFlight(), OffBy(0, 1));
  const auto jumped = [&](double jump) {
    Trajectory other = studied.whole;
    for (std::size_t s = 40; s < other.samples.size(); ++s)
      other.samples[s].bodies[0].p_WB.x() += jump;
    return other;
  };
  RoundingGrowth growth = GrowthOf(studied.study(), jumped(4e-5));
  const auto verdict = [&](double difference) {
    return JudgeVariant(studied.study(), growth, MeasureKind::kHeading,
                        jumped(difference))
        .verdict;
  };
  EXPECT_EQ(verdict(2e-3), Verdict::kUndecidable);
  growth.most =
      MostThatRoundingExplains(studied.study(), std::vector{jumped(4e-5), jumped(-3e-5)});
  EXPECT_NEAR(growth.most, 4e-4, 1e-9);
  EXPECT_EQ(verdict(3e-4), Verdict::kUndecidable);
  EXPECT_EQ(verdict(2e-3), Verdict::kFail);
}

TEST(JudgeVariant, ExplainsTheToleranceThatItApplies) {
  const Studied studied(TwoBallsInFlight(), OffBy(1e-3, 0));
  const WorldVariant heading = VariantsOf(studied.scenario.world).front();
  const Trajectory seen = SeenInWorld(heading, OffBy(1e-3, 0).Simulate(heading.world));
  // The gain is 10 before the horizon and 1e5 after it; here the horizon is the start.
  const Finding finding =
      JudgeVariant(studied.study(), {1e5, 10, 0}, MeasureKind::kHeading, seen);
  EXPECT_THAT(finding.tolerance_because, HasSubstr("amplifies 1e+05 times"));
  const Finding before =
      JudgeVariant(studied.study(), {1e5, 10}, MeasureKind::kHeading, seen);
  EXPECT_THAT(before.tolerance_because, HasSubstr("amplifies 10 times"));
  EXPECT_NEAR(finding.tolerance, 1e4 * before.tolerance, 10 * before.tolerance);
}

//            ball
//             o       A ball near the top of a smooth hump: x'' = k² x for its distance
//          .-- --.    x from the top, so that x = x₀ cosh k t. A rounding error of its
//        .'       '.  position is amplified cosh(k 1.5 s) = 1.5e8 times.
constexpr double kRate = 13;  // [1/s]

WorldScenario BallOnAHump() {
  const Eigen::Vector3d top(0.37, -1.13, 0.61);
  WorldScenario scenario;
  scenario.id = "world/test/hump";
  scenario.world.bodies = {
      BodyOf("hump", Sphere{0.5}, 0, top),
      BodyOf("ball", Sphere{0.1}, 0.7, top + Eigen::Vector3d(3.1e-9, 0.6, -1.7e-9))};
  scenario.world.dt = 0.01;
  scenario.world.steps = 150;
  return scenario;
}

/** Returns the exact motion, apart from the rounding of positions in the world. `off(t)`
 [m] is added along x. */
Trajectory OverTheHump(const World& world, double (*off)(double t)) {
  return Sampled(world, [&](double t) {
    WorldState state;
    const auto hump = std::find_if(world.bodies.begin(), world.bodies.end(),
                                   [](const RigidBody& body) { return body.mass == 0; });
    const Eigen::Vector3d top = hump->placed.X_WB.p_WB;
    for (const RigidBody& body : world.bodies) {
      Eigen::Vector3d p_W = body.placed.X_WB.p_WB;
      if (body.mass > 0) {
        const Eigen::Vector3d up = -world.gravity_W.normalized();
        const Eigen::Vector3d from_top = p_W - top;
        const Eigen::Vector3d beside = from_top - up * up.dot(from_top);
        p_W += (std::cosh(kRate * t) - 1) * beside + Eigen::Vector3d(off(t), 0, 0);
      }
      state.bodies.push_back({p_W, Eigen::Quaterniond(body.placed.X_WB.R_WB),
                              Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()});
    }
    return state;
  });
}

std::vector<Finding> FindingsOnTheHump(double (*off)(double t)) {
  const FakeSimulator engine(
      "engine", [off](const World& world) { return OverTheHump(world, off); });
  const std::vector<const Oracle*> oracles = {&engine};
  const std::vector<WorldScenario> worlds = {BallOnAHump()};
  return RunWorlds(worlds, oracles, {.jobs = 1}).findings;
}

const Finding& Heading(const std::vector<Finding>& findings) {
  return *std::find_if(findings.begin(), findings.end(), [](const Finding& finding) {
    return finding.measure == MeasureKind::kHeading;
  });
}

/** A box that stands on the ground, exactly or `above` it. */
WorldScenario StandingBox(double above) {
  WorldScenario scenario;
  scenario.id = "world/test/standing";
  scenario.world.bodies = {
      BodyOf("box", Box{{0.1, 0.2, 0.3}}, 1, {0.3, 0.2 + above, 0.1}), GroundOf()};
  scenario.world.dt = 0.01;
  scenario.world.steps = 100;
  return scenario;
}

/** The verdict of an engine whose box is `off` its place from 0.5 s on, but only in a
 world that was moved. */
Verdict OffInAMovedWorld(const WorldScenario& scenario, const Eigen::Vector3d& off) {
  const double x = scenario.world.bodies[0].placed.X_WB.p_WB.x();
  const FakeSimulator engine("engine", [&](const World& world) {
    const bool is_moved = std::abs(world.bodies[0].placed.X_WB.p_WB.x() - x) > 1e-9 &&
                          world.bodies[0].placed.X_WB.R_WB.isIdentity(0);
    return Sampled(world, [&](double t) {
      WorldState state = FreeFlight(world).samples.front();
      if (is_moved && t > 0.495) state.bodies[0].p_WB += off;
      return state;
    });
  });
  const std::vector<const Oracle*> oracles = {&engine};
  const std::vector<WorldScenario> worlds = {scenario};
  for (const Finding& finding : RunWorlds(worlds, oracles, {.jobs = 1}).findings) {
    if (finding.measure == MeasureKind::kTranslation) return finding.verdict;
  }
  ADD_FAILURE() << "no translation was judged";
  return Verdict::kFail;
}

TEST(JudgeVariant, GrantsTheFallOfAStepToAContactThatRoundingDecides) {
  constexpr double kFall = 9.82 * 0.01 * 0.01;  // [m]
  EXPECT_EQ(OffInAMovedWorld(StandingBox(0), {0, -kFall, 0}), Verdict::kPass);
  EXPECT_EQ(OffInAMovedWorld(StandingBox(0), {0, -1.1 * kFall, 0}), Verdict::kFail);
  EXPECT_EQ(OffInAMovedWorld(StandingBox(0), {1e-6, 0, 0}), Verdict::kFail) << "across";
  EXPECT_EQ(OffInAMovedWorld(StandingBox(0), {0, -0.3 * kFall, 0}), Verdict::kFail)
      << "no step falls so far";
  EXPECT_EQ(OffInAMovedWorld(StandingBox(1e-9), {0, -kFall, 0}), Verdict::kFail)
      << "no contact at the start";
}

// The top of the ground is as exact as its place: a rounding of 1000 m.
TEST(JudgeVariant, GrantsTheFallOffALargeFloorToo) {
  constexpr double kFall = 9.82 * 0.01 * 0.01;  // [m]
  WorldScenario scenario = StandingBox(1e-12);
  scenario.world.bodies[1] = BodyOf("floor", Box{{5000, 1000, 5000}}, 0, {0, -1000, 0});
  EXPECT_EQ(OffInAMovedWorld(scenario, {0, -kFall, 0}), Verdict::kPass);
  EXPECT_EQ(OffInAMovedWorld(scenario, {0, -1.1 * kFall, 0}), Verdict::kFail);
}

// A force of m g on a contact as soft as 1e-9 m/(N s) lets it sink by 1e-8 m in a second;
// the variant of three times the mass by three times as much.
TEST(JudgeVariant, GrantsWhatSoftContactsYield) {
  const Studied studied(StandingBox(0), FakeSimulator("engine", [](const World& world) {
                          return FreeFlight(world);
                        }));
  OracleInfo soft = studied.info;
  soft.parameters = {{.name = "cfm",
                      .here = 1e-9,
                      .shipped = 1e-6,
                      .least = 0,
                      .most = 1,
                      .whole = false,
                      .what = "softness",
                      .why = ""}};
  Trajectory sunk = studied.whole;
  for (std::size_t s = 0; s < sunk.samples.size(); ++s)
    sunk.samples[s].bodies[0].p_WB.y() -= 2 * 9.82e-9 * sunk.times[s];
  const auto verdict = [&] {
    const Study study{studied.scenario, soft, studied.whole, &studied.whole};
    return JudgeVariant(study, {}, MeasureKind::kMassScaling, sunk).verdict;
  };
  EXPECT_EQ(verdict(), Verdict::kFail);
  soft.softness = "cfm";
  EXPECT_EQ(SoftnessOf(soft), 1e-9);
  EXPECT_EQ(verdict(), Verdict::kPass);
  soft.setup.chosen["cfm"] = 1e-10;
  EXPECT_EQ(verdict(), Verdict::kFail);
}

/** The verdict on the moved world of an engine whose box falls by `off` at 0.5 s if its
 start is moved, by however little. */
Verdict FallsIfMoved(const Eigen::Vector3d& off) {
  const WorldScenario scenario = StandingBox(0);
  const Eigen::Vector3d& p_W = scenario.world.bodies[0].placed.X_WB.p_WB;
  const FakeSimulator engine("engine", [&](const World& world) {
    const Pose& X_WB = world.bodies[0].placed.X_WB;
    const bool is_moved = X_WB.p_WB != p_W && X_WB.R_WB.diagonal().minCoeff() > 0.999;
    return Sampled(world, [&](double t) {
      WorldState state = FreeFlight(world).samples.front();
      if (is_moved && t > 0.495) state.bodies[0].p_WB += off;
      return state;
    });
  });
  const std::vector<const Oracle*> oracles = {&engine};
  const std::vector<WorldScenario> worlds = {scenario};
  for (const Finding& finding : RunWorlds(worlds, oracles, {.jobs = 1}).findings) {
    if (finding.measure == MeasureKind::kTranslation) return finding.verdict;
  }
  ADD_FAILURE() << "no translation was judged";
  return Verdict::kFail;
}

// The fall is seen with a moved start, too: the motion amplifies a rounding 1e10 times.
TEST(JudgeVariant, TellsAFallFromAJumpOfUnknownSize) {
  constexpr double kFall = 9.82 * 0.01 * 0.01;  // [m]
  EXPECT_EQ(FallsIfMoved({0, -kFall, 0}), Verdict::kPass);
  EXPECT_EQ(FallsIfMoved({0, -0.3 * kFall, 0}), Verdict::kUnsupported);
  EXPECT_EQ(FallsIfMoved({kFall, 0, 0}), Verdict::kUnsupported) << "across the load";
}

TEST(UnstableMotion, DoesNotFailARightEngineForAmplifiedRounding) {
  const std::vector<Finding> findings = FindingsOnTheHump([](double) { return 0.0; });
  for (const Finding& finding : findings) {
    // OverTheHump() states no velocities.
    if (finding.law == "moves_at_its_velocity") continue;
    EXPECT_TRUE(finding.verdict == Verdict::kPass ||
                finding.verdict == Verdict::kUnsupported)
        << finding.proof;
  }
  EXPECT_EQ(Heading(findings).verdict, Verdict::kUnsupported);
  EXPECT_THAT(Heading(findings).proof, HasSubstr("this motion amplifies rounding "));
  EXPECT_THAT(Heading(findings).proof, HasSubstr("the variants cannot be compared"));
}

TEST(UnstableMotion, FailsAnEngineThatPrefersADirectionBeforeTheHorizon) {
  // Later the error is hidden, since amplified rounding explains as much.
  const std::vector<Finding> findings =
      FindingsOnTheHump([](double t) { return t > 0 && t < 0.5 ? 1e-8 : 0.0; });
  EXPECT_EQ(Heading(findings).verdict, Verdict::kFail);
  EXPECT_LT(Heading(findings).tolerance, 1e-8);
}

TEST(UnstableMotion, FailsAnEngineAfterTheHorizonByMoreThanRoundingExplains) {
  const std::vector<Finding> findings =
      FindingsOnTheHump([](double t) { return t > 1.4 ? 1e-2 : 0.0; });
  EXPECT_EQ(Heading(findings).verdict, Verdict::kFail);
  EXPECT_THAT(Heading(findings).proof, HasSubstr("turned about gravity differently"));
}

TEST(UnstableMotion, FailsAWrongEngineWhoseMotionJumps) {
  // A moved start changes the motion by 0.3 m, as with a row of balls that just touch.
  // Rounding is granted ten such jumps. A heavier ball rises by 2.1 m.
  const FakeSimulator engine("engine", [](const World& world) {
    return FreeFlight(world, [&](double t) {
      const bool jumps = world.bodies[0].placed.X_WB.p_WB.x() != 0.3;
      const bool heavier = world.bodies[0].mass > 2;
      return Eigen::Vector3d(jumps && t > 0.3 ? 0.3 : 0.0,
                             heavier && t > 0.3 ? 3 * (t - 0.3) : 0.0, 0);
    });
  });
  const std::vector<const Oracle*> oracles = {&engine};
  const std::vector<WorldScenario> worlds = {TwoBallsInFlight()};
  const std::vector<Finding> findings = RunWorlds(worlds, oracles, {.jobs = 1}).findings;
  const auto found =
      std::find_if(findings.begin(), findings.end(), [](const Finding& finding) {
        return finding.verdict == Verdict::kFail &&
               finding.proof.starts_with(
                   "the world with all masses three times as large: ballistic: ");
      });
  ASSERT_NE(found, findings.end());
  EXPECT_EQ(found->measure, MeasureKind::kPositionError);
  EXPECT_EQ(found->reference, "");
}

TEST(UnstableMotion, DoesNotFailARightEngineForASpinAboutTheMiddleAxis) {
  // A moved position changes nothing; a turn tilts the spin off the axis, and that grows.
  const FakeSimulator engine("engine", [](const World& world) {
    return Sampled(world, [&](double t) {
      const RigidBody& body = world.bodies[0];
      const Eigen::Matrix3d R_WB = body.placed.X_WB.R_WB;
      const Eigen::Vector3d tilt_W = (R_WB.col(0)).cross(body.w_WB.normalized());
      WorldState state;
      state.bodies = {{body.placed.X_WB.p_WB + t * t / 2 * world.gravity_W,
                       Turned(Eigen::Quaterniond(R_WB),
                              t * body.w_WB + (std::cosh(7.07 * t) - 1) * tilt_W),
                       t * world.gravity_W, body.w_WB}};
      return state;
    });
  });
  WorldScenario scenario;
  scenario.id = "world/test/handle";
  scenario.world.gravity_W = {0.3, -9.7, 1.1};
  RigidBody handle = BodyOf("handle", Sphere{0.3}, 3, {0, 0, 0});
  handle.placed.X_WB = Pose::FromQuaternion({0, 0, 0}, {1, 0, 0, 0});
  handle.w_WB = {10, 0, 0};
  scenario.world.bodies = {handle};
  scenario.world.dt = 0.01;
  scenario.world.steps = 300;
  const std::vector<const Oracle*> oracles = {&engine};
  const std::vector<WorldScenario> worlds = {scenario};
  for (const Finding& finding : RunWorlds(worlds, oracles, {.jobs = 1}).findings)
    EXPECT_NE(finding.verdict, Verdict::kFail) << finding.proof;
}

TEST(RoundingGrowth, StaysOneWithoutAHorizonInFreeFlight) {
  const Studied studied(TwoBallsInFlight(), OffBy(0, 1));
  const RoundingGrowth growth = GrowthOf(studied.study(), studied.whole);
  EXPECT_EQ(growth.gain, 1);
  EXPECT_EQ(growth.horizon, std::numeric_limits<double>::infinity());
}

TEST(RoundingGrowth, HasItsHorizonAtAJumpOfTheMotion) {
  const Studied studied(TwoBallsInFlight(), OffBy(0, 1));
  Trajectory nudged = studied.whole;
  for (std::size_t s = 40; s < nudged.samples.size(); ++s)
    nudged.samples[s].bodies[0].p_WB.x() += 0.3;
  const RoundingGrowth growth = GrowthOf(studied.study(), nudged);
  EXPECT_EQ(growth.horizon, studied.whole.times[40]);
  EXPECT_EQ(growth.gain_before, 1);
  EXPECT_NEAR(growth.gain, 0.3 / RoundingOf(studied.study(), 1), 1e-6 * growth.gain);
}

TEST(RoundingGrowth, HasNoHorizonIfDiscretisationExplainsMore) {
  const Studied studied(TwoBallsInFlight(), OffBy(1, 1));
  Trajectory nudged = studied.whole;
  nudged.samples.back().bodies[0].p_WB.x() += 1e-6;
  const RoundingGrowth growth = GrowthOf(studied.study(), nudged);
  EXPECT_GT(growth.gain, kLargestGain);
  EXPECT_EQ(growth.gain_before, growth.gain);
  EXPECT_EQ(growth.horizon, std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace touchstone
