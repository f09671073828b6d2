#include "reports/worlds/study/run_worlds.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <fstream>
#include <map>
#include <sstream>
#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reports/worlds/laws/laws.h"
#include "reports/worlds/study/check_claims.h"
#include "reports/worlds/study/judge_once.h"
#include "reports/worlds/study/run_claims.h"
#include "reports/worlds/study/world_variants.h"
#include "reports/worlds/truth/mechanics.h"
#include "tests/reports/worlds/fake_simulator.h"
#include "tests/reports/worlds/motions.h"
#include "tests/reports/worlds/study/tie.h"
#include "tests/source_tree.h"

namespace touchstone {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::Field;
using testing::IsEmpty;
using testing::Not;

WorldScenario Flight(std::string id, int steps) {
  WorldScenario scenario;
  scenario.id = std::move(id);
  scenario.world.bodies = {BodyOf("ball", Sphere{0.5}, 2, {0.3, 1.7, -0.4})};
  scenario.world.steps = steps;
  scenario.world.sample_every = steps;
  scenario.claims = {ClaimOf("ballistic"), ClaimOf("deterministic")};
  return scenario;
}

Trajectory Exact(const World& world) {
  return FreeFlight(world);
}

std::vector<std::string> Described(const WorldsReport& report) {
  std::vector<std::string> lines;
  for (const Finding& finding : report.findings)
    lines.push_back(finding.scenario + " " + finding.oracle + " " +
                    std::string(NameOf(finding.measure)));
  return lines;
}

/** Returns the verdict of moves_at_its_velocity on an engine whose ball is 1 cm off in
 step 4 alone, where the world asks for a sample every 10 steps. */
template <typename Judge>
Verdict OffBetweenSamples(double off, Judge&& judge) {
  WorldScenario scenario = Flight("world/test/flight", 20);
  scenario.world.sample_every = 10;
  const FakeSimulator engine("engine", [off](const World& world) {
    return FreeFlight(world, [&](double t) {
      const bool is_step_4 = std::abs(t / world.dt - 4) < 0.5;
      return Eigen::Vector3d(is_step_4 ? off : 0, 0, 0);
    });
  });
  for (const Finding& finding : judge(scenario, engine))
    if (finding.measure == MeasureKind::kTravelError) return finding.verdict;
  ADD_FAILURE() << "nothing was judged";
  return Verdict::kUnsupported;
}

TEST(RunWorlds, JudgesEveryStepWhereAWorldAsksForFewSamples) {
  const auto run = [](const WorldScenario& scenario, const Oracle& engine) {
    const std::vector<const Oracle*> oracles = {&engine};
    const std::vector<WorldScenario> worlds = {scenario};
    WorldsReport report = RunWorlds(worlds, oracles, {.jobs = 1});
    EXPECT_EQ(report.worlds[0].trajectories[0].samples.size(), 3U);
    return report.findings;
  };
  EXPECT_EQ(OffBetweenSamples(0, run), Verdict::kPass);
  EXPECT_EQ(OffBetweenSamples(0.01, run), Verdict::kFail);
}

TEST(JudgeOnce, JudgesEveryStepWhereAWorldAsksForFewSamples) {
  const auto once = [](const WorldScenario& scenario, const Oracle& engine) {
    JudgedMotion judged = std::move(JudgeOnce(std::span(&scenario, 1), engine).front());
    EXPECT_EQ(judged.trajectory.samples.size(), 3U);
    return judged.findings;
  };
  EXPECT_EQ(OffBetweenSamples(0, once), Verdict::kPass);
  EXPECT_EQ(OffBetweenSamples(0.01, once), Verdict::kFail);
}

TEST(JudgeOnce, JudgesTheContactsOfEveryStep) {
  WorldScenario scenario;
  scenario.id = "world/test/lies";
  scenario.world = BallOnRoughGround();
  scenario.world.steps = 20;
  scenario.world.sample_every = 10;
  const auto verdict = [&](double aside) {
    const FakeSimulator engine("engine", [&](const World& world) {
      Trajectory still = Sampled(world, [&](double) { return StateAtStart(world); });
      still.gives_impulses = true;
      const Eigen::Vector3d J_W = -world.dt * world.bodies[0].mass * world.gravity_W;
      for (int step = 1; step <= world.steps; ++step) {
        const Eigen::Vector3d p_W(step == 4 ? aside : 0, 0, 0);
        still.impulses.push_back({step, 1, 0, p_W, {0, 1, 0}, J_W, 0});
      }
      return still;
    });
    const auto judged = JudgeOnce(std::span(&scenario, 1), engine);
    for (const Finding& finding : judged.front().findings)
      if (finding.measure == MeasureKind::kContactPlace) return finding.verdict;
    ADD_FAILURE() << "no contact was judged";
    return Verdict::kUnsupported;
  };
  EXPECT_EQ(verdict(0), Verdict::kPass);
  EXPECT_EQ(verdict(0.15), Verdict::kFail);
}

TEST(RunWorlds, TellsNothingFromAnEventThatARoundingPutsOffByAStep) {
  const WorldScenario scenario = Tie();
  const World& world = scenario.world;
  int early = 0;
  for (const WorldVariant& variant : VariantsOf(world)) {
    const std::size_t ball = BallOf(variant.world);
    const Trajectory motion = TurnsBackNear(variant.world);
    const Eigen::Vector3d& v_W = motion.samples[64].bodies[ball].v_WB;
    early += v_W.dot(variant.world.bodies[ball].v_WB) < 0;
  }
  ASSERT_THAT(early, testing::AllOf(testing::Gt(0), testing::Lt(5)))
      << "the world is no tie";
  const FakeSimulator engine("engine", TurnsBackNear);
  const std::vector<const Oracle*> oracles = {&engine};
  const WorldsReport report = RunWorlds({&scenario, 1}, oracles, {});
  int not_compared = 0;
  for (const Finding& finding : report.findings) {
    if (finding.measure != MeasureKind::kHeading &&
        finding.measure != MeasureKind::kTranslation &&
        finding.measure != MeasureKind::kMirror)
      continue;
    EXPECT_NE(finding.verdict, Verdict::kFail) << finding.proof;
    not_compared += finding.verdict == Verdict::kUnsupported;
  }
  EXPECT_GT(not_compared, 0);
}

constexpr double kG = 9.81;  ///< [m/s²]

/** Returns the motion of a box that slides on the ground. Friction is bounded along two
 axes of the world, and acts where it turns the box about no axis. */
Trajectory SlidesInABoxCone(const World& world) {
  const int moving = world.bodies[0].mass > 0 ? 0 : 1;
  const RigidBody& box = world.bodies[static_cast<std::size_t>(moving)];
  const double J_n = box.mass * kG * world.dt;
  const double limit = box.friction * J_n;
  std::vector<ContactImpulse> impulses;
  Trajectory trajectory = Stepped(world, [&](WorldState& state) {
    BodyState& body = state.bodies[static_cast<std::size_t>(moving)];
    ContactImpulse contact;
    contact.step = static_cast<int>(impulses.size()) + 1;
    contact.A = 1 - moving;
    contact.B = moving;
    contact.n_AB_W = Eigen::Vector3d::UnitY();
    contact.J_B_W =
        -box.mass * body.v_WB.cwiseMax(-limit / box.mass).cwiseMin(limit / box.mass);
    body.v_WB += contact.J_B_W / box.mass;
    contact.J_B_W.y() = J_n;
    contact.p_WC = body.p_WB - 0.1 / J_n * contact.J_B_W;
    body.p_WB += world.dt * body.v_WB;
    impulses.push_back(contact);
  });
  trajectory.gives_impulses = true;
  trajectory.impulses = std::move(impulses);
  return trajectory;
}

TEST(RunWorlds, CallsFrictionOfFixedDirectionsAModelWithoutAnyClaim) {
  WorldScenario scenario;
  scenario.id = "world/test/slides";
  scenario.world.bodies = {BodyOf("box", Box{{0.3, 0.1, 0.3}}, 2, {0, 0.1, 0}),
                           GroundOf()};
  for (RigidBody& body : scenario.world.bodies) body.friction = 0.4;
  scenario.world.bodies[0].v_WB = {2, 0, 1.2};
  scenario.world.gravity_W = {0, -kG, 0};
  scenario.world.dt = 0.01;
  scenario.world.steps = 100;
  const FakeSimulator engine("engine", SlidesInABoxCone);
  const std::vector<const Oracle*> oracles = {&engine};
  const WorldsReport report = RunWorlds({&scenario, 1}, oracles, {.jobs = 1});
  bool heading = false;
  for (const Finding& finding : report.findings) {
    if (finding.verdict != Verdict::kFail) continue;
    EXPECT_EQ(finding.cause, Cause::kModel) << finding.proof << finding.cause_because;
    heading = heading || finding.measure == MeasureKind::kHeading;
  }
  EXPECT_TRUE(heading);
}

TEST(RunWorlds, ReturnsTheSameReportForAnyNumberOfThreads) {
  const FakeSimulator a("a", Exact);
  const FakeSimulator b("b", Exact);
  const std::vector<const Oracle*> oracles = {&a, &b};
  const std::vector<WorldScenario> worlds = {Flight("world/test/a", 10),
                                             Flight("world/test/b", 20)};
  std::atomic<std::size_t> done = 0;
  const auto count = [&](double) { ++done; };
  const std::vector<std::string> one =
      Described(RunWorlds(worlds, oracles, {.jobs = 1, .on_done = count}));
  EXPECT_EQ(Described(RunWorlds(worlds, oracles, {.jobs = 4, .on_done = count})), one);
  EXPECT_EQ(done, 2 * CountOfWorldRuns(worlds, oracles));
  EXPECT_THAT(one, Contains("world/test/a a position_error"));
  EXPECT_THAT(one, Contains("world/test/b b determinism"));
}

TEST(RunWorlds, SaysHowLongEachKindOfMotionAndEachLawTook) {
  const FakeSimulator engine("engine", [](const World& world) {
    Trajectory motion = Exact(world);
    motion.seconds = 1;
    return motion;
  });
  const std::vector<const Oracle*> oracles = {&engine};
  const WorldScenario scenario = Flight("world/test/flight", 8);
  const WorldSeconds seconds =
      RunWorlds({&scenario, 1}, oracles, {}).worlds[0].seconds[0];
  EXPECT_EQ(seconds.motions.at("itself"), 1);
  EXPECT_EQ(seconds.motions.at("half step"), 1);
  EXPECT_EQ(seconds.motions.at("quarter step"), 1);
  EXPECT_EQ(seconds.motions.at("moved start"), 2);
  EXPECT_EQ(seconds.motions.at("mirror"), 1);
  EXPECT_EQ(seconds.motions.at("again"), 1);
  EXPECT_LT(seconds.motions.at("as shipped"), 1) << "no failure, so it is not asked";
  EXPECT_TRUE(seconds.laws.contains("ballistic"));
  EXPECT_GE(seconds.all, seconds.laws.at("ballistic"));
}

/** Returns how often `motion` is asked for a world at a quarter of the step of the one
 that the claim is about. */
int QuartersOf(const Claim& claim, Trajectory (*motion)(const World&)) {
  WorldScenario scenario = Flight("world/test/flight", 8);
  scenario.claims = {claim};
  std::atomic<int> quarters = 0;
  const double quarter = scenario.world.dt / 4;
  const FakeSimulator engine("engine", [&](const World& world) {
    quarters += world.dt == quarter;
    return motion(world);
  });
  const std::vector<const Oracle*> oracles = {&engine};
  RunWorlds({&scenario, 1}, oracles, {});
  return quarters;
}

/** Falls upwards. */
Trajectory Upwards(const World& world) {
  World lifted = world;
  lifted.gravity_W *= -5;
  return FreeFlight(lifted);
}

TEST(RunWorlds, SimulatesAQuarterOfTheStepOnlyForAnOrderOrForACause) {
  EXPECT_EQ(QuartersOf(ClaimOf("ballistic"), Exact), 1) << "its order is judged";
  EXPECT_EQ(QuartersOf(ClaimOf("never_penetrates"), Exact), 0);
  const Claim conserves = ClaimOf("conserves_energy");
  EXPECT_EQ(QuartersOf(conserves, Exact), 0);
  EXPECT_EQ(QuartersOf(conserves, Upwards), 1) << "a failure needs its cause";
}

TEST(RunWorlds, SimulatesOnlySmallWorldsAtSmallerSteps) {
  std::atomic<int> runs = 0;
  const FakeSimulator engine("engine", [&](const World& world) {
    ++runs;
    return FreeFlight(world);
  });
  const std::vector<const Oracle*> oracles = {&engine};
  std::vector<WorldScenario> worlds = {Flight("world/test/long", 200'000)};
  worlds[0].claims = {ClaimOf("ballistic")};
  RunWorlds(worlds, oracles, {.jobs = 1});
  EXPECT_EQ(runs, 1);
  worlds[0].world.steps = 100;
  worlds[0].world.sample_every = 100;
  RunWorlds(worlds, oracles, {.jobs = 1});
  // The whole, half and quarter step, two moved starts, and each of four variants.
  EXPECT_EQ(runs, 1 + 3 + 2 + 4);
}

TEST(RunWorlds, FindsTheWorstMemberOfAnEnsemble) {
  std::atomic<int> runs = 0;
  const FakeSimulator engine("engine", [&](const World& world) {
    const double off = ++runs == 3 ? 0.5 : 0;
    return FreeFlight(world,
                      [off](double t) { return Eigen::Vector3d(off * t * t, 0, 0); });
  });
  const std::vector<const Oracle*> oracles = {&engine};
  std::vector<WorldScenario> worlds = {Flight("world/test/many", 200'000)};
  worlds[0].claims = {ClaimOf("ballistic")};
  worlds[0].ensemble = Ensemble{4, 1e-3, 1};
  const WorldsReport report = RunWorlds(worlds, oracles, {.jobs = 1});
  EXPECT_EQ(runs, 4);
  EXPECT_THAT(report.findings,
              Contains(testing::AllOf(
                  Field(&Finding::measure, MeasureKind::kPositionError),
                  Field(&Finding::verdict, Verdict::kFail),
                  Field(&Finding::proof, testing::HasSubstr("member 2 of the")))));
}

TEST(RunWorlds, FindsAFailureThatOnlyALaterMemberOfAnEnsembleShows) {
  // A motion without a contact gives the cone nothing to judge.
  std::atomic<int> runs = 0;
  const FakeSimulator engine("engine", [&](const World& world) {
    Trajectory trajectory = FreeFlight(world);
    trajectory.gives_impulses = true;
    if (++runs == 2)
      trajectory.impulses = {{1, 0, 1, {0, 0, 0}, {0, 1, 0}, {3, 1, 0}, 0}};
    return trajectory;
  });
  const std::vector<const Oracle*> oracles = {&engine};
  std::vector<WorldScenario> worlds = {Flight("world/test/many", 200'000)};
  worlds[0].world.bodies.push_back(BodyOf("other", Sphere{0.5}, 2, {4, 1.7, -0.4}));
  worlds[0].claims = {ClaimOf("coulomb_cone", {"other"}), ClaimOf("ballistic")};
  worlds[0].ensemble = Ensemble{3, 1e-3, 1};
  const WorldsReport report = RunWorlds(worlds, oracles, {.jobs = 1});
  EXPECT_THAT(report.findings,
              Contains(testing::AllOf(
                  Field(&Finding::measure, MeasureKind::kConeViolation),
                  Field(&Finding::verdict, Verdict::kFail),
                  Field(&Finding::proof, testing::HasSubstr("member 1 of the")))));
  // One member is enough to verify the claim.
  EXPECT_THAT(report.findings,
              Not(Contains(Field(&Finding::verdict, Verdict::kUnsupported))));
}

TEST(RunWorlds, NamesTheSmallerStepOrTheVariantThatFails) {
  struct Case {
    bool (*strikes)(const World& world, const World& asked);
    std::string_view said;
  };
  for (const Case& planted :
       {Case{[](const World&w, const World&asked) { return w.dt == asked.dt / 2; },
             "engine, at half the step: it died"},
        Case{[](const World&w, const World&asked) { return w.dt == asked.dt / 4; },
             "engine, at a quarter of the step: it died"},
        Case{[](const World&w, const World&asked) {
               return w.bodies[0].mass != asked.bodies[0].mass;
             },
             "engine, with all masses three times as large: it died"}}) {
    const std::vector<WorldScenario> worlds = {Flight("world/test/a", 100)};
    const FakeSimulator engine("engine", [&](const World& world) {
      Trajectory trajectory = FreeFlight(world);
      if (!planted.strikes(world, worlds[0].world)) return trajectory;
      trajectory = {};
      trajectory.status = AnswerStatus::kCrashed;
      trajectory.reason = "it died";
      return trajectory;
    });
    const std::vector<const Oracle*> oracles = {&engine};
    EXPECT_THAT(
        RunWorlds(worlds, oracles, {.jobs = 1}).findings,
        Contains(testing::AllOf(Field(&Finding::measure, MeasureKind::kAnswering),
                                Field(&Finding::verdict, Verdict::kCrashed),
                                Field(&Finding::proof, testing::Eq(planted.said)))));
  }
}

TEST(RunWorlds, NamesTheSmallerStepThatDiverges) {
  const std::vector<WorldScenario> worlds = {Flight("world/test/a", 100)};
  const FakeSimulator engine("engine", [&](const World& world) {
    Trajectory trajectory = FreeFlight(world);
    if (world.dt < worlds[0].world.dt) trajectory.diverged_at_step = 7;
    return trajectory;
  });
  const std::vector<const Oracle*> oracles = {&engine};
  EXPECT_THAT(
      RunWorlds(worlds, oracles, {.jobs = 1}).findings,
      Contains(testing::AllOf(
          Field(&Finding::verdict, Verdict::kInvalid),
          Field(&Finding::proof,
                testing::HasSubstr("engine, at half the step: diverged in step 7")))));
}

TEST(RunWorlds, MapsThePointsOfAVariantBackIntoTheWorldItself) {
  // Turned or mirrored, the ball ends too high by more than the law allows of one motion,
  // but by less than two motions may differ.
  std::vector<WorldScenario> worlds = {Flight("world/test/a", 100)};
  const World& asked = worlds[0].world;
  worlds[0].world.gravity_W.setZero();
  worlds[0].world.bodies[0].v_WB = {0, 1, 0};
  const Trajectory exact = FreeFlight(asked);
  const Trajectory far_off =
      FreeFlight(asked, [](double t) { return Eigen::Vector3d(0, t, 0); });
  const double allowed =
      Of(Judge(asked, far_off, worlds[0].claims[0]), MeasureKind::kPositionError)
          .tolerance.value;
  const FakeSimulator engine("engine", [&](const World& world) {
    const Eigen::Vector3d& p_W = world.bodies[0].placed.X_WB.p_WB;
    const Eigen::Vector3d& asked_W = asked.bodies[0].placed.X_WB.p_WB;
    const bool is_elsewhere = (p_W - asked_W).norm() > 1e-3;
    const double rate = is_elsewhere ? 1.2 * allowed / exact.times.back() : 0;
    return FreeFlight(world, [&](double t) { return Eigen::Vector3d(0, rate * t, 0); });
  });
  const std::vector<const Oracle*> oracles = {&engine};
  int found = 0;
  for (const Finding& finding : RunWorlds(worlds, oracles, {.jobs = 1}).findings) {
    if (!finding.proof.starts_with("the world ")) continue;
    ++found;
    ASSERT_EQ(finding.cited.points_W.size(), 2U) << finding.proof;
    for (const Eigen::Vector3d& p_W : finding.cited.points_W)
      EXPECT_LT((p_W - exact.samples.back().bodies[0].p_WB).norm(), 1e-9);
  }
  EXPECT_GT(found, 0);
}

TEST(RunWorlds, FindsAnEngineThatIsNotDeterministic) {
  std::atomic<int> runs = 0;
  const FakeSimulator engine("moody", [&](const World& world) {
    const double off = 1e-15 * ++runs;
    return FreeFlight(world, [off](double) { return Eigen::Vector3d(off, 0, 0); });
  });
  const std::vector<const Oracle*> oracles = {&engine};
  const std::vector<WorldScenario> worlds = {Flight("world/test/a", 10)};
  const WorldsReport report = RunWorlds(worlds, oracles, {.jobs = 1});
  EXPECT_THAT(report.findings,
              Contains(testing::AllOf(Field(&Finding::measure, MeasureKind::kDeterminism),
                                      Field(&Finding::verdict, Verdict::kFail))));
  for (const Finding& finding : report.findings) {
    if (finding.measure != MeasureKind::kDeterminism) continue;
    EXPECT_EQ(finding.cited, (Cited{{"ball"}, 0.0, {}}));
  }
}

//     x              A motion that goes another way unless its start is exactly `x`: any
//     |              rounding error decides the way. The true motion does not.
//  ---o--->
//      \.
//       '->
Trajectory TornByRounding(const World& world, double x) {
  const double off = world.bodies[0].placed.X_WB.p_WB.x() == x ? 0 : 0.125;
  return FreeFlight(world, [off](double t) { return Eigen::Vector3d(off * t, 0, 0); });
}

std::map<MeasureKind, Verdict> VerdictsOn(const Oracle& engine,
                                          std::vector<Claim> claims) {
  std::vector<WorldScenario> worlds = {Flight("world/test/a", 10)};
  worlds[0].claims = std::move(claims);
  const std::vector<const Oracle*> oracles = {&engine};
  std::map<MeasureKind, Verdict> verdicts;
  for (const Finding& finding : RunWorlds(worlds, oracles, {.jobs = 1}).findings)
    verdicts[finding.measure] = finding.verdict;
  return verdicts;
}

TEST(RunWorlds, ComparesVariantsOfStableWorldsToTheEnd) {
  const FakeSimulator torn("torn",
                           [](const World& world) { return TornByRounding(world, 0.3); });
  auto verdicts = VerdictsOn(torn, {});
  EXPECT_EQ(verdicts.at(MeasureKind::kTranslation), Verdict::kUnsupported);
  EXPECT_FALSE(verdicts.contains(MeasureKind::kStability));

  const Claim stable = ClaimOf(kStable, {}, {{std::string(kStableGain), 4}});
  verdicts = VerdictsOn(torn, {stable});
  EXPECT_EQ(verdicts.at(MeasureKind::kStability), Verdict::kFail);
  EXPECT_EQ(verdicts.at(MeasureKind::kTranslation), Verdict::kFail);

  verdicts = VerdictsOn(FakeSimulator("exact", Exact), {stable});
  EXPECT_EQ(verdicts.at(MeasureKind::kStability), Verdict::kPass);
  EXPECT_EQ(verdicts.at(MeasureKind::kTranslation), Verdict::kPass);
}

TEST(RunWorlds, AllowsNoLatenessToAnEngineThatShowsNone) {
  std::vector<WorldScenario> worlds = {Flight("world/test/a", 10)};
  worlds[0].claims = {ClaimOf(kStable, {}, {{std::string(kStableGain), 4}})};
  const FakeSimulator exact("exact", Exact);
  const std::vector<const Oracle*> oracles = {&exact};
  EXPECT_THAT(RunWorlds(worlds, oracles, {.jobs = 1}).findings,
              Contains(testing::AllOf(Field(&Finding::measure, MeasureKind::kTranslation),
                                      Field(&Finding::tolerance, testing::Lt(1e-9)))));
}

TEST(RunWorlds, FindsAnEngineThatDivergesWithAMovedStart) {
  const FakeSimulator engine("engine", [](const World& world) {
    Trajectory trajectory = FreeFlight(world);
    const Eigen::Vector3d& p_WB = world.bodies[0].placed.X_WB.p_WB;
    const bool is_nudged = p_WB.x() != 0.3 && std::abs(p_WB.x() - 0.3) < 1e-9;
    if (is_nudged) trajectory.diverged_at_step = 4;
    return trajectory;
  });
  const std::vector<const Oracle*> oracles = {&engine};
  const std::vector<WorldScenario> worlds = {Flight("world/test/a", 10)};
  EXPECT_THAT(
      RunWorlds(worlds, oracles, {.jobs = 1}).findings,
      Contains(Field(&Finding::proof,
                     testing::HasSubstr("engine, with its start moved by a rounding: "
                                        "diverged in step 4"))));
}

std::vector<std::string> ErrorsIn(const WorldScenario& scenario) {
  std::vector<std::string> errors;
  for (const Diagnostic& error : ErrorsOfClaims(scenario))
    errors.push_back(ToString(error));
  return errors;
}

TEST(ErrorsOfClaims, AreNoneForAValidLawAndForDeterministic) {
  EXPECT_THAT(ErrorsIn(Flight("world/test/a", 10)), IsEmpty());
}

TEST(ErrorsOfClaims, NameTheNearestLaw) {
  WorldScenario scenario = Flight("world/test/a", 10);
  scenario.claims = {ClaimOf("balistic")};
  EXPECT_THAT(
      ErrorsIn(scenario),
      ElementsAre("world/test/a: claims[0].law is \"balistic\", which is not a law; "
                  "expected \"ballistic\""));
}

TEST(ErrorsOfClaims, IncludeTheFaultsOfTheLaw) {
  WorldScenario scenario = Flight("world/test/a", 10);
  scenario.claims = {ClaimOf("ballistic", {"nobody"})};
  EXPECT_THAT(ErrorsIn(scenario), Not(IsEmpty()));
}

TEST(ErrorsOfClaims, RefuseANumberThatNoLawReads) {
  WorldScenario scenario = Flight("world/test/a", 10);
  scenario.claims = {ClaimOf("conserves_momentum"), ClaimOf("energy_never_rises"),
                     ClaimOf(std::string(kDeterministic))};
  for (Claim& claim : scenario.claims) claim.numbers["expected_bounce"] = 1;
  EXPECT_THAT(
      ErrorsIn(scenario),
      ElementsAre(
          testing::HasSubstr("unknown key \"expected_bounce\" in "
                             "claims[0].numbers; expected one of "
                             "expected_momentum, x, y, z"),
          testing::HasSubstr("expected none: energy_never_rises takes no numbers"),
          testing::HasSubstr("expected none: deterministic takes no numbers")));
}

TEST(ErrorsOfClaims, SayWhatGainAStableWorldNeeds) {
  WorldScenario scenario = Flight("world/test/a", 10);
  const auto errors_with = [&](std::map<std::string, double> numbers) {
    scenario.claims = {ClaimOf(kStable, {}, std::move(numbers))};
    return ErrorsIn(scenario);
  };
  const std::string gain(kStableGain);
  EXPECT_THAT(errors_with({}),
              ElementsAre(testing::HasSubstr("claims[0] has no number \"gain\" (stable); "
                                             "expected the largest factor by which")));
  EXPECT_THAT(errors_with({{gain, 0.5}}),
              ElementsAre(testing::HasSubstr("claims[0].numbers.gain is 0.5; expected")));
  EXPECT_THAT(errors_with({{gain, 1}}), IsEmpty());
}

TEST(ErrorsOfClaims, RefuseStableInALargeWorldOrTwice) {
  WorldScenario scenario = Flight("world/test/a", 200'000);
  const Claim stable = ClaimOf(kStable, {}, {{std::string(kStableGain), 1}});
  scenario.claims = {stable};
  EXPECT_THAT(
      ErrorsIn(scenario),
      ElementsAre("world/test/a: claims[0].law is \"stable\" in a world too large "
                  "to be simulated twice; expected at most 100000 bodies times steps"));
  scenario.world.steps = 10;
  scenario.claims = {stable, ClaimOf("ballistic"), stable};
  EXPECT_THAT(ErrorsIn(scenario),
              ElementsAre("world/test/a: claims[2].law is \"stable\" a second time; "
                          "expected one gain per world"));
}

TEST(ErrorsOfClaims, RefuseNamesInAClaimAboutEverythingThatMoves) {
  WorldScenario scenario = Flight("world/test/a", 10);
  scenario.claims = {ClaimOf(kDeterministic, {"ball"})};
  EXPECT_THAT(
      ErrorsIn(scenario),
      ElementsAre("world/test/a: claims[0].about names something (deterministic); "
                  "expected no names: it is about everything that moves"));
}

TEST(ErrorsOfClaims, CarryTheirPositionInTheFile) {
  WorldScenario scenario = Flight("world/test/a", 10);
  scenario.claims = {ClaimOf("conserves_momentum")};
  scenario.claims[0].numbers = {{"expected_momentum", 77}, {"up", 1}};
  scenario.places.file = "a.toml";
  scenario.places.by_path["claims[0].numbers.expected_momentum"] = {{7, 3}, {7, 23}};
  scenario.places.by_path["claims[0].numbers.up"] = {{8, 3}, {8, 8}};
  EXPECT_THAT(ErrorsIn(scenario),
              ElementsAre(testing::StartsWith("a.toml:8:3: unknown key \"up\""),
                          testing::StartsWith(
                              "a.toml:7:23: claims[0].numbers.expected_momentum is 77")));
}

TEST(Laws, AreDescribedWithTheirNumbers) {
  std::ostringstream page;
  page << std::ifstream(InSourceTree("docs/laws.md")).rdbuf();
  std::istringstream rows(page.str().substr(page.str().find("## Numbers")));
  std::map<std::string, std::string> row_of;  // Indexed by the name of a law.
  for (std::string row; std::getline(rows, row);) {
    const std::size_t names_end = row.find(" | ");
    for (const Law& law : Laws()) {
      const std::string name = fmt::format("`{}`", law.name);
      if (row.substr(0, names_end).find(name) != std::string::npos)
        row_of.emplace(law.name, row);
    }
  }
  for (const Law& law : Laws()) {
    EXPECT_EQ(row_of.contains(std::string(law.name)), !law.numbers.empty()) << law.name;
    for (const std::string_view number : law.numbers) {
      EXPECT_THAT(row_of[std::string(law.name)],
                  testing::HasSubstr(fmt::format("`{}`", number)));
    }
  }
}

TEST(Laws, HaveSortedNumbers) {
  for (const Law& law : Laws())
    EXPECT_TRUE(std::is_sorted(law.numbers.begin(), law.numbers.end())) << law.name;
}

}  // namespace
}  // namespace touchstone
