#include "reports/worlds/study/judge_world.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reports/worlds/truth/mechanics.h"
#include "reports/worlds/truth/sliding.h"
#include "reports/worlds/truth/vertical_bounces.h"
#include "tests/reports/worlds/fake_simulator.h"
#include "tests/reports/worlds/motions.h"
#include "tests/reports/worlds/study/studied.h"

namespace touchstone {
namespace {

using testing::HasSubstr;

const Finding* Find(const std::vector<Finding>& findings, MeasureKind measure) {
  const auto found = std::find_if(findings.begin(), findings.end(),
                                  [&](const Finding& f) { return f.measure == measure; });
  return found == findings.end() ? nullptr : &*found;
}

TEST(JudgeWorld, PassesTheClosedForm) {
  const Studied studied(TwoBallsInFlight(), OffBy(0, 1));
  for (const Finding& finding : JudgeWorld(studied.study())) {
    EXPECT_EQ(finding.verdict, Verdict::kPass) << finding.proof;
    EXPECT_EQ(finding.reference, "law");
  }
}

TEST(JudgeWorld, CallsAnErrorThatVanishesWithTheStepDiscretisation) {
  const Studied studied(TwoBallsInFlight(), OffBy(1000, 1));
  const std::vector<Finding> findings = JudgeWorld(studied.study());
  const Finding* position = Find(findings, MeasureKind::kPositionError);
  ASSERT_NE(position, nullptr);
  EXPECT_EQ(position->verdict, Verdict::kFail);
  EXPECT_EQ(position->cause, Cause::kDiscretisation);
  EXPECT_THAT(position->proof, HasSubstr("ballistic: off has"));
}

TEST(JudgeWorld, CarriesWhatTheProofNames) {
  const Studied studied(TwoBallsInFlight(), OffBy(1000, 1));
  const std::vector<Finding> findings = JudgeWorld(studied.study());
  const Finding* position = Find(findings, MeasureKind::kPositionError);
  ASSERT_TRUE(position != nullptr && position->cited.time);
  EXPECT_THAT(position->proof,
              HasSubstr(fmt::format("after {:.6g} s", *position->cited.time)));
  ASSERT_EQ(position->cited.names.size(), 1U);
  EXPECT_THAT(position->proof,
              HasSubstr(fmt::format("off has “{}” at", position->cited.names[0])));
  EXPECT_EQ(position->cited.points_W.size(), 2U);
  for (const Finding& finding : findings) {
    if (finding.verdict != Verdict::kPass) continue;
    EXPECT_EQ(finding.cited, Cited()) << finding.law;
  }
}

TEST(JudgeWorld, QuotesWhatTheEnginePrintedInAFailure) {
  Studied studied(TwoBallsInFlight(), OffBy(1, 0));
  studied.whole.complaint = "LCP internal error";
  const std::vector<Finding> findings = JudgeWorld(studied.study());
  EXPECT_THAT(Find(findings, MeasureKind::kPositionError)->proof,
              testing::EndsWith("(it printed: LCP internal error)"));
  EXPECT_EQ(Find(findings, MeasureKind::kAnswering)->proof, "");
}

TEST(JudgeWorld, CallsAnErrorThatStaysADefect) {
  const Studied studied(TwoBallsInFlight(), OffBy(1, 0));
  const std::vector<Finding> findings = JudgeWorld(studied.study());
  const Finding* position = Find(findings, MeasureKind::kPositionError);
  ASSERT_NE(position, nullptr);
  EXPECT_EQ(position->verdict, Verdict::kFail);
  EXPECT_EQ(position->cause, Cause::kDefect);
  EXPECT_THAT(position->cause_because,
              HasSubstr("would have to fall to 1/1.4 at each halving"));
  EXPECT_THAT(position->cause_because, Not(HasSubstr("hardly smaller")));
}

// A body that passes through a wall at two steps and not at the third: no error that
// falls with the step, and yet a reader who sees its 0 is owed the reason.
TEST(JudgeWorld, SaysThatAnErrorIsGoneAtAQuarterOfTheStepThoughNotAtAHalf) {
  const World world = TwoBallsInFlight().world;
  const FakeSimulator engine("threshold", [&](const World& refined) {
    const double off = refined.dt < 0.4 * world.dt ? 0 : 1;
    return FreeFlight(refined,
                      [=](double t) { return Eigen::Vector3d(t > 0 ? off : 0, 0, 0); });
  });
  const Studied studied(TwoBallsInFlight(), engine);
  const std::vector<Finding> findings = JudgeWorld(studied.study());
  const Finding* position = Find(findings, MeasureKind::kPositionError);
  ASSERT_NE(position, nullptr);
  EXPECT_EQ(position->cause, Cause::kDefect);
  EXPECT_THAT(position->cause_because,
              HasSubstr("it passes at a quarter but is hardly smaller at a half"));
}

TEST(JudgeWorld, FailsTheOrderOfAnErrorThatHardlyFallsWithTheStep) {
  const Studied studied(TwoBallsInFlight(), OffBy(1e-3, 0.2));
  const std::vector<Finding> findings = JudgeWorld(studied.study());
  const Finding* order = Find(findings, MeasureKind::kObservedOrder);
  ASSERT_NE(order, nullptr);
  EXPECT_EQ(order->verdict, Verdict::kFail);
  EXPECT_NEAR(order->value, 0.8, 1e-6);
}

TEST(JudgeWorld, HoldsAnEngineToTheOrderThatItStates) {
  Studied first_order(TwoBallsInFlight(), OffBy(10, 1));
  EXPECT_EQ(Find(JudgeWorld(first_order.study()), MeasureKind::kObservedOrder)->verdict,
            Verdict::kPass);
  first_order.info.stated_order = 4;
  first_order.info.order_stated_by = "its manual";
  const std::vector<Finding> findings = JudgeWorld(first_order.study());
  const Finding* order = Find(findings, MeasureKind::kObservedOrder);
  EXPECT_EQ(order->verdict, Verdict::kFail);
  EXPECT_NEAR(order->value, 3, 1e-4);
  EXPECT_THAT(order->tolerance_because, HasSubstr("order 4 is stated by its manual"));

  Studied fourth_order(TwoBallsInFlight(), OffBy(1e6, 4));
  fourth_order.info.stated_order = 4;
  const std::vector<Finding> as_stated = JudgeWorld(fourth_order.study());
  EXPECT_EQ(Find(as_stated, MeasureKind::kObservedOrder)->verdict, Verdict::kPass);
}

TEST(JudgeWorld, ObservesTheOrderBeforeSwingsLosePhase) {
  // First-order in its phase: soon the swings differ by twice their amplitude at any
  // step.
  const FakeSimulator engine("swings", [](const World& world) {
    return FreeFlight(world, [&](double t) {
      return Eigen::Vector3d(1e-3 * std::sin(100 * (1 + 10 * world.dt) * t), 0, 0);
    });
  });
  const Studied studied(TwoBallsInFlight(), engine);
  const std::vector<Finding> findings = JudgeWorld(studied.study());
  const Finding* order = Find(findings, MeasureKind::kObservedOrder);
  ASSERT_NE(order, nullptr);
  EXPECT_EQ(order->verdict, Verdict::kPass) << order->proof;
}

TEST(JudgeWorld, BlamesNoErrorOnTheStepWithoutSmallerSteps) {
  const Studied studied(TwoBallsInFlight(), OffBy(1000, 1));
  Study study = studied.study();
  study.half = nullptr;
  study.quarter = nullptr;
  EXPECT_EQ(Find(JudgeWorld(study), MeasureKind::kPositionError)->cause, Cause::kDefect);
}

/** An engine whose ball follows the closed form, but `off` [m] too high after its first
 impact. */
FakeSimulator Bouncing(double off) {
  return FakeSimulator("bounces", [off](const World& world) {
    const VerticalBounces truth({1, 0}, 9.82, 0.8);
    return Sampled(world, [&world, truth, off](double t) {
      const Height at = truth.At(t);
      WorldState state = StateAtStart(world);
      state.bodies[0].p_WB.y() += at.gap - 1 + (t > truth.first_impact() ? off : 0);
      state.bodies[0].v_WB.y() = at.velocity;
      return state;
    });
  });
}

TEST(JudgeWorld, HoldsImpactsToTheToleranceOfAQuarterOfTheStep) {
  WorldScenario scenario;
  scenario.id = "world/test/bounce";
  scenario.world.bodies = {BodyOf("ball", Sphere{0.5}, 3, {0.2, 1.5, -0.1}), GroundOf()};
  scenario.world.bodies[0].restitution = 0.8;
  scenario.world.bodies[1].restitution = 1;
  scenario.world.gravity_W = {0, -9.82, 0};
  scenario.world.dt = 0.01;
  scenario.world.steps = 100;
  scenario.claims = {ClaimOf("bounce_series")};
  const auto verdict = [&](double off, MeasureKind measure) {
    const Studied studied(scenario, Bouncing(off));
    return Find(JudgeWorld(studied.study()), measure)->verdict;
  };
  EXPECT_EQ(verdict(0, MeasureKind::kLimitError), Verdict::kPass);
  // The error is below V h, but above the V h of a quarter of the step.
  EXPECT_EQ(verdict(0.05, MeasureKind::kPositionError), Verdict::kUndecidable);
  EXPECT_EQ(verdict(0.05, MeasureKind::kLimitError), Verdict::kFail);
}

// In the first step the motion has 0.9 of the error that is allowed, next to nothing.
// Later it has half of a tolerance that is as wide as a body.
TEST(JudgeWorld, CallsNoMotionRightForItsNarrowestTolerance) {
  const FakeSimulator engine("engine", [](const World& world) {
    return FreeFlight(world, [&](double t) {
      const double allowed = 1.5 * world.gravity_W.norm() * world.dt * t / 2;
      return Eigen::Vector3d((t > world.dt ? 0.5 : 0.9) * allowed, 0, 0);
    });
  });
  const Studied studied(TwoBallsInFlight(), engine);
  const std::vector<Finding> findings = JudgeWorld(studied.study());
  const Finding* position = Find(findings, MeasureKind::kPositionError);
  ASSERT_NE(position, nullptr);
  EXPECT_EQ(position->verdict, Verdict::kUndecidable);
  EXPECT_EQ(position->undecided, Undecided::kCoarse);
  EXPECT_GT(position->value, 0.03);
  EXPECT_GT(position->tolerance, 0.07);
}

// Two balls of 0.4 m and more that are 9 cm off after 2 s, by that scheme and no more.
TEST(JudgeWorld, PassesAnErrorThatIsAllOfAKnownScheme) {
  WorldScenario scenario = TwoBallsInFlight();
  scenario.world.steps = 200;
  const auto judged = [&](double share) {
    const FakeSimulator engine("engine", [share](const World& world) {
      return FreeFlight(world, [&](double t) {
        return Eigen::Vector3d(share * world.gravity_W * world.dt * t / 2);
      });
    });
    const Studied studied(scenario, engine);
    return *Find(JudgeWorld(studied.study()), MeasureKind::kPositionError);
  };
  const Finding finding = judged(1);
  EXPECT_EQ(finding.verdict, Verdict::kPass);
  EXPECT_EQ(RecognisedModelOf(finding), "semi-implicit Euler");
  EXPECT_GT(finding.value, 0.09);
  EXPECT_EQ(judged(0.9).verdict, Verdict::kUndecidable);
}

TEST(JudgeWorld, ReportsAClaimWithNothingToJudgeAsUnverified) {
  // Without a contact there is no impulse to check against the cone.
  WorldScenario scenario = TwoBallsInFlight();
  scenario.claims.push_back(ClaimOf("coulomb_cone", {"near"}));
  const Studied studied(scenario, OffBy(0, 1));
  const std::vector<std::vector<Finding>> groups = JudgeWorldByClaim(studied.study());
  // The universal laws follow the two claims.
  ASSERT_GT(groups.size(), 3U);
  ASSERT_EQ(groups[2].size(), 1U);
  EXPECT_EQ(groups[2][0].verdict, Verdict::kUnsupported);
  EXPECT_EQ(groups[2][0].proof,
            "coulomb_cone: this motion gives the law nothing to judge");
}

TEST(JudgeWorld, JudgesAFailedAnswerNoFurther) {
  struct Case {
    AnswerStatus status;
    Verdict verdict;
  };
  for (const auto& [status, verdict] :
       {Case{AnswerStatus::kCrashed, Verdict::kCrashed},
        Case{AnswerStatus::kTimedOut, Verdict::kTimedOut},
        Case{AnswerStatus::kUnsupported, Verdict::kUnsupported}}) {
    const FakeSimulator engine("gone", [status = status](const World&) {
      Trajectory trajectory;
      trajectory.status = status;
      trajectory.reason = "it is gone";
      return trajectory;
    });
    const Studied studied(TwoBallsInFlight(), engine);
    const std::vector<Finding> findings =
        JudgeWorld({studied.scenario, studied.info, studied.whole});
    ASSERT_EQ(findings.size(), 1U);
    EXPECT_EQ(findings[0].verdict, verdict);
    EXPECT_EQ(findings[0].measure, MeasureKind::kAnswering);
    EXPECT_THAT(findings[0].proof, HasSubstr("it is gone"));
  }
}

TEST(JudgeWorld, CallsADivergedMotionInvalidAndNamesTheStep) {
  const FakeSimulator engine("explodes", [](const World& world) {
    Trajectory trajectory = FreeFlight(world);
    trajectory.diverged_at_step = 42;
    return trajectory;
  });
  const Studied studied(TwoBallsInFlight(), engine);
  const std::vector<Finding> findings = JudgeWorld(studied.study());
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0].verdict, Verdict::kInvalid);
  EXPECT_THAT(findings[0].proof, HasSubstr("diverged in step 42, at 0.42 s"));
  EXPECT_FALSE(IsWhole(studied.whole));
}

TEST(JudgeWorld, CallsAMotionWithAnotherStartInvalidEvenWithoutAClaim) {
  struct Case {
    std::string_view said;
    std::string_view cited;  // A name; empty: no part of the world.
    std::size_t points;
    void (*change)(WorldState&);
  };
  for (const Case& planted :
       {Case{"the position of “near” at", "near", 2,
             [](WorldState& state) { state.bodies[0].p_WB.x() += 1e-9; }},
        Case{"the velocity of “far” at", "far", 0,
             [](WorldState& state) { state.bodies[1].v_WB *= 0.99; }},
        Case{"the spin of “near” at", "near", 0,
             [](WorldState& state) { state.bodies[0].w_WB.setZero(); }},
        Case{"“near” turned by 0.01 rad", "near", 0,
             [](WorldState& state) {
               state.bodies[0].q_WB = Turned(state.bodies[0].q_WB, {0, 0.01, 0});
             }},
        Case{"other bodies or points", "", 0,
             [](WorldState& state) { state.bodies.pop_back(); }}}) {
    WorldScenario scenario = TwoBallsInFlight();
    scenario.claims.clear();
    const FakeSimulator engine("elsewhere", [&](const World& world) {
      Trajectory trajectory = FreeFlight(world);
      planted.change(trajectory.samples.front());
      return trajectory;
    });
    const Trajectory motion = engine.Simulate(scenario.world);
    const std::vector<Finding> findings = JudgeWorld({scenario, engine.info(), motion});
    ASSERT_EQ(findings.size(), 1U);
    EXPECT_EQ(findings[0].verdict, Verdict::kInvalid);
    EXPECT_EQ(findings[0].measure, MeasureKind::kAnswering);
    EXPECT_THAT(findings[0].proof, HasSubstr(planted.said));
    const Cited& cited = findings[0].cited;
    EXPECT_EQ(cited.points_W.size(), planted.points) << planted.said;
    if (planted.cited.empty()) {
      EXPECT_EQ(cited, Cited());
    } else {
      EXPECT_THAT(cited.names, testing::ElementsAre(planted.cited));
      EXPECT_EQ(cited.time, 0);
    }
  }
}

TEST(JudgeWorld, FailsAnEngineWithTwoFrictionCones) {
  // Two blocks slide obliquely. The second engine brakes one by the box cone and the
  // other by the diamond cone.
  WorldScenario scenario;
  scenario.id = "world/test/cones";
  for (const double x : {-3.0, 3.0}) {
    RigidBody block =
        BodyOf(x < 0 ? "left" : "right", Box{{0.2, 0.02, 0.2}}, 1, {x, 0.02, 0});
    block.friction = 0.4;
    block.v_WB = Eigen::Vector3d(2, 0, 1);
    scenario.world.bodies.push_back(block);
  }
  scenario.world.bodies.push_back(GroundOf());
  scenario.world.bodies.back().friction = 0.4;
  scenario.world.dt = 1e-3;
  scenario.world.steps = 600;
  scenario.claims = {ClaimOf("slide_to_stop", {"left"}),
                     ClaimOf("slide_to_stop", {"right"})};
  const auto judged = [&](FrictionCone of_left, FrictionCone of_right) {
    const FakeSimulator engine("mixed", [&](const World& world) {
      const std::vector<TangentFrame> frames = TangentFramesOf(Eigen::Vector3d::UnitY());
      return Sampled(world, [&](double t) {
        WorldState state = StateAtStart(world);
        for (const std::size_t i : {0U, 1U}) {
          const RigidBody& body = world.bodies[i];
          const Slip slip =
              SlipAfter(i == 0 ? of_left : of_right,
                        frames.front().transpose() * body.v_WB, 0.4 * 9.82, t);
          state.bodies[i].p_WB += frames.front() * slip.travelled;
          state.bodies[i].v_WB = frames.front() * slip.velocity;
        }
        return state;
      });
    });
    const Trajectory motion = engine.Simulate(scenario.world);
    std::vector<Verdict> verdicts;
    for (const Finding& finding : JudgeWorld({scenario, engine.info(), motion})) {
      if (finding.cause != Cause::kNone) verdicts.push_back(finding.verdict);
    }
    return verdicts;
  };
  EXPECT_THAT(
      judged(FrictionCone::kBox, FrictionCone::kBox),
      testing::AllOf(testing::Not(testing::IsEmpty()), testing::Each(Verdict::kPass)));
  EXPECT_THAT(
      judged(FrictionCone::kBox, FrictionCone::kDiamond),
      testing::AllOf(testing::Not(testing::IsEmpty()), testing::Each(Verdict::kFail)));
}

TEST(JudgeRepetition, FailsADifferenceOfOneBit) {
  const WorldScenario scenario = TwoBallsInFlight();
  const Studied studied(scenario, OffBy(0, 1));
  EXPECT_EQ(JudgeRepetition(studied.study(), studied.whole).verdict, Verdict::kPass);
  Trajectory again = studied.whole;
  double& x = again.samples[7].bodies[1].p_WB.x();
  x = std::nextafter(x, std::numeric_limits<double>::infinity());
  const Finding finding = JudgeRepetition(studied.study(), again);
  EXPECT_EQ(finding.verdict, Verdict::kFail);
  EXPECT_THAT(finding.proof, HasSubstr("at 0.07 s “far” position.x"));
  EXPECT_EQ(finding.cited, (Cited{{"far"}, studied.whole.times[7], {}}));
}

TEST(JudgeWorld, ComparesTheImpulsesOfStepsAsForces) {
  // Friction of 3 N or of 3 N times the step, without a normal force, in every step.
  for (const bool is_force_of_step : {false, true}) {
    const FakeSimulator rubs("rubs", [&](const World& world) {
      Trajectory trajectory = FreeFlight(world);
      trajectory.gives_impulses = true;
      for (int step = 1; step <= world.steps; ++step) {
        const double F = is_force_of_step ? 3 * world.dt : 3;
        trajectory.impulses.push_back(
            {step, 0, 1, {0, 0, 0}, {0, 1, 0}, {F * world.dt, 0, 0}, 0});
      }
      return trajectory;
    });
    WorldScenario scenario = TwoBallsInFlight();
    scenario.claims = {{"coulomb_cone", {}, {}, ""}};
    const Studied studied(scenario, rubs);
    const std::vector<Finding> findings = JudgeWorld(studied.study());
    const Finding* cone = Find(findings, MeasureKind::kConeViolation);
    ASSERT_NE(cone, nullptr);
    EXPECT_EQ(cone->verdict, Verdict::kFail);
    EXPECT_EQ(cone->cause, is_force_of_step ? Cause::kDiscretisation : Cause::kDefect);
  }
}

TEST(JudgeWorld, ExcusesNoErrorByTheStepThatIsGrantedRoundingAlone) {
  // The engine reports impulses of h² that it does not apply.
  const FakeSimulator invents("invents", [&](const World& world) {
    Trajectory trajectory = FreeFlight(world);
    trajectory.gives_impulses = true;
    for (int step = 1; step <= world.steps; ++step) {
      trajectory.impulses.push_back(
          {step, 0, 1, {0, 0, 0}, {0, 1, 0}, {0, world.dt * world.dt, 0}, 0});
    }
    return trajectory;
  });
  WorldScenario scenario = TwoBallsInFlight();
  scenario.claims = {{"momentum_balance", {}, {}, ""}};
  const Studied studied(scenario, invents);
  const std::vector<Finding> findings = JudgeWorld(studied.study());
  const Finding* balance = Find(findings, MeasureKind::kMomentumBalance);
  ASSERT_NE(balance, nullptr);
  EXPECT_EQ(balance->verdict, Verdict::kFail);
  EXPECT_EQ(balance->cause, Cause::kDefect);
  EXPECT_EQ(balance->safety, 1);
}

TEST(JudgeWorld, DecidesNothingByAToleranceThatIsNotFinite) {
  // A reported impulse so large that sums over it overflow, and in a later step a body
  // that jumps through a wall.
  const FakeSimulator overflows("overflows", [](const World& world) {
    Trajectory trajectory = FreeFlight(world);
    trajectory.gives_impulses = true;
    trajectory.impulses.push_back({1, 0, 1, {0, 0, 0}, {0, 1, 0}, {0, 1.7e308, 0}, 0});
    return trajectory;
  });
  WorldScenario scenario;
  scenario.id = "world/overflow";
  scenario.world.bodies = {BodyOf("bullet", Sphere{0.01}, 0.01, {-1, 0, 0}),
                           BodyOf("wall", Box{{0.005, 9, 9}}, 0, {0, 0, 0})};
  scenario.world.bodies[0].v_WB = {100, 0, 0};
  scenario.world.gravity_W.setZero();
  scenario.world.steps = 4;
  const Studied studied(scenario, overflows);
  const std::vector<Finding> findings = JudgeWorld(studied.study());
  const Finding* balance = Find(findings, MeasureKind::kMomentumBalance);
  ASSERT_NE(balance, nullptr);
  EXPECT_FALSE(std::isfinite(balance->tolerance));
  EXPECT_EQ(balance->verdict, Verdict::kUndecidable);
  EXPECT_THAT(balance->proof, HasSubstr("no number follows for its tolerance"));
  // An impulse excuses nothing in another step.
  const Finding* passage = Find(findings, MeasureKind::kPassage);
  ASSERT_NE(passage, nullptr);
  EXPECT_EQ(passage->verdict, Verdict::kFail);
}

TEST(JudgeWorld, StatesTheFactorOfSafetyOfAnErrorLaw) {
  const Studied studied(TwoBallsInFlight(), OffBy(1, 0));
  const std::vector<Finding> findings = JudgeWorld(studied.study());
  EXPECT_EQ(Find(findings, MeasureKind::kPositionError)->safety, 1.5);
  EXPECT_EQ(Find(findings, MeasureKind::kVelocityError)->safety, 1);
}

}  // namespace
}  // namespace touchstone
