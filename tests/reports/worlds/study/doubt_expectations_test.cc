#include "reports/worlds/study/doubt_expectations.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reports/worlds/study/judge_world.h"
#include "tests/reports/worlds/fake_simulator.h"
#include "tests/reports/worlds/motions.h"

namespace touchstone {
namespace {

using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

/** An engine: its library, and where it has the ball, off the truth along z. [m] */
using Engine = std::pair<std::string, double>;

/** A ball in flight, with its place at 0.2 s as the file states it; the true one is (0.2,
 1, 0). */
WorldScenario FlightTo(const Eigen::Vector3d& p_W) {
  WorldScenario scenario;
  scenario.id = "world/test/flight";
  scenario.world.gravity_W.setZero();
  scenario.world.bodies = {BodyOf("ball", Sphere{0.2}, 1, {0, 1, 0})};
  scenario.world.bodies[0].v_WB = {1, 0, 0};
  scenario.world.dt = 0.01;
  scenario.world.steps = 50;
  scenario.expectations = {
      {"ball", 0.2, 0.01, ExpectedVector{ExpectedVector::Of::kPosition, p_W, {}}, ""}};
  return scenario;
}

/** The judgement of a world, and of its file. */
struct Judged {
  std::vector<Finding> findings;  ///< Those about the expectation.
  std::vector<std::string> faults;
};

/** @param late by how much all lag along y, per second. [m/s] */
Judged Judge(const WorldScenario& scenario, const std::vector<Engine>& engines,
             double late = 0) {
  WorldResult result{scenario, {}, {}, {}};
  std::vector<OracleInfo> oracles;
  for (const auto& [library, off] : engines) {
    OracleInfo& info = oracles.emplace_back(DoubleEngine());
    info.name = "engine" + std::to_string(oracles.size());
    info.library = library;
    result.trajectories.push_back(FreeFlight(scenario.world, [off = off, late](double t) {
      return Eigen::Vector3d(0, -late * t, t > 0 ? off : 0);
    }));
  }
  Judged judged;
  for (std::size_t o = 0; o < oracles.size(); ++o) {
    for (Finding& finding : JudgeWorld({scenario, oracles[o], result.trajectories[o]}))
      if (finding.law == "expect[0]") judged.findings.push_back(std::move(finding));
  }
  judged.faults = DoubtExpectations(result, oracles, judged.findings);
  return judged;
}

std::vector<Verdict> VerdictsOf(const Judged& judged) {
  std::vector<Verdict> verdicts;
  for (const Finding& finding : judged.findings) verdicts.push_back(finding.verdict);
  return verdicts;
}

void ExpectNobodyAccused(const Judged& judged) {
  EXPECT_THAT(VerdictsOf(judged),
              ElementsAre(Verdict::kUndecidable, Verdict::kUndecidable));
  for (const Finding& finding : judged.findings) {
    EXPECT_EQ(finding.proof, "");
    EXPECT_THAT(finding.tolerance_because, HasSubstr("if nothing acted on it"));
  }
  EXPECT_THAT(judged.faults, IsEmpty());
}

TEST(DoubtExpectations, BlameAFileThatAgreeingEnginesContradict) {
  const Judged judged =
      Judge(FlightTo({0.2, 1, 3}), {{"A", 0}, {"B", 0.001}, {"C", -0.7}});
  EXPECT_THAT(
      VerdictsOf(judged),
      ElementsAre(Verdict::kUndecidable, Verdict::kUndecidable, Verdict::kUndecidable));
  for (const Finding& finding : judged.findings) {
    EXPECT_EQ(finding.proof, "");
    EXPECT_EQ(finding.cause, Cause::kNone);
  }
  EXPECT_THAT(
      judged.faults,
      ElementsAre("world/test/flight: “ball” is expected a position of (0.2, "
                  "1, 3) m at 0.2 s, but engine1 has (0.2, 1, 0) m; none of 3 engines "
                  "meets this, and engine1 and engine2 agree to 0.001 m. Correct it."));
}

TEST(DoubtExpectations, LeaveAnExpectationThatAnEngineMeets) {
  const Judged judged = Judge(FlightTo({0.2, 1, 3}), {{"A", 0}, {"B", 0}, {"C", 3}});
  EXPECT_THAT(VerdictsOf(judged),
              ElementsAre(Verdict::kFail, Verdict::kFail, Verdict::kPass));
  EXPECT_THAT(judged.faults, IsEmpty());
}

/** The same flight, with a wall for which it may be bound. */
WorldScenario FlightAtAWall(const Eigen::Vector3d& p_W) {
  WorldScenario scenario = FlightTo(p_W);
  scenario.world.bodies.push_back(BodyOf("wall", Box{{0.005, 2, 2}}, 0, {0.31, 0, 0}));
  return scenario;
}

// All may have missed the wall. They are not accused, nor is the file.
TEST(DoubtExpectations, AccuseNobodyIfEnginesAgreeOnlyInThatNothingActs) {
  ExpectNobodyAccused(Judge(FlightAtAWall({-0.1, 1, 0}), {{"A", 0}, {"B", 0}}));
}

// Those that agree best are untouched; two others are the better evidence.
TEST(DoubtExpectations, BlameAFileIfEnginesAgreeInWhatActs) {
  const Judged judged =
      Judge(FlightAtAWall({-0.1, 1, 0}), {{"A", 0}, {"B", 0}, {"C", 0.7}, {"D", 0.701}});
  EXPECT_THAT(VerdictsOf(judged), Each(Verdict::kUndecidable));
  EXPECT_THAT(judged.faults,
              ElementsAre(HasSubstr("engine3 and engine4 agree to 0.001 m.")));
}

// Its free motion is then the truth.
TEST(DoubtExpectations, BlameAFileIfNothingCollides) {
  WorldScenario scenario = FlightAtAWall({-0.1, 1, 0});
  scenario.world.bodies[1].collides = false;
  EXPECT_THAT(Judge(scenario, {{"A", 0}, {"B", 0}}).faults, SizeIs(1));
}

// The flight ends 1 cm short of the wall, at 0.4 m, until the moment that is asked for.
TEST(DoubtExpectations, BlameAFileIfTheWallIsNotReachedYet) {
  WorldScenario scenario = FlightAtAWall({-0.1, 1, 0});
  Body& wall = scenario.world.bodies[1].placed;
  wall.X_WB.p_WB.x() = 0.415 + 0.02;
  EXPECT_THAT(Judge(scenario, {{"A", 0}, {"B", 0}}).faults, SizeIs(1));
  wall.X_WB.p_WB.x() = 0.415;
  ExpectNobodyAccused(Judge(scenario, {{"A", 0}, {"B", 0}}));
}

// A lone ball on a spring to the world, which both leave out.
TEST(DoubtExpectations, AccuseNobodyIfEnginesAgreeOnlyInThatNothingPulls) {
  WorldScenario scenario = FlightTo({0.1, 1, 0});
  Spring spring;
  spring.A = {AnchorKind::kBody, 0, Eigen::Vector3d::Zero()};
  spring.stiffness = 100;
  scenario.world.springs = {spring};
  ExpectNobodyAccused(Judge(scenario, {{"A", 0}, {"B", 0}}));
}

// Two engines with the semi-implicit scheme fall through a wall: g h t/2 below the truth.
TEST(DoubtExpectations, AccuseNobodyIfEnginesFallFreelyByAScheme) {
  WorldScenario scenario = FlightAtAWall({0.2, 1.5, 0});
  scenario.world.gravity_W = {0, -10, 0};
  scenario.expectations[0].what = ExpectedVector{
      ExpectedVector::Of::kPosition, {0.2, 0.83, 0}, Eigen::Vector3d::UnitY()};
  ExpectNobodyAccused(Judge(scenario, {{"A", 0}, {"B", 0}}, 10 * 0.01 / 2));
}

// The beam turns by 1 rad a sample, from 0.5 rad before the ball to 0.5 rad behind it.
TEST(DoubtExpectations, AccuseNobodyIfABeamTurnsPastTheBall) {
  WorldScenario scenario = FlightTo({1, 1, 0});
  scenario.expectations[0].time = 0.03;
  scenario.world.bodies[0].v_WB.setZero();
  const Eigen::Vector3d ahead_W(std::cos(0.5), std::sin(0.5), 0);
  scenario.world.bodies.push_back(
      BodyOf("beam", Box{{1, 0.01, 0.01}}, 1, Eigen::Vector3d(0, 1, 0) - 0.9 * ahead_W));
  scenario.world.bodies[1].w_WB = {0, 0, 100};
  ExpectNobodyAccused(Judge(scenario, {{"A", 0}, {"B", 0}}));
}

// Its attitude is that of a free ball, but something has moved it.
TEST(DoubtExpectations, LookAtTheWholeStateForWhatActs) {
  WorldScenario scenario = FlightAtAWall({0, 0, 0});
  scenario.expectations[0].what = ExpectedTopple{true};
  EXPECT_THAT(Judge(scenario, {{"A", 0.7}, {"B", 0.7}}).faults, SizeIs(1));
  ExpectNobodyAccused(Judge(scenario, {{"A", 0}, {"B", 0}}));
}

// Two builds of one library have the same faults.
TEST(DoubtExpectations, LeaveAnExpectationThatOneLibraryContradicts) {
  const Judged judged = Judge(FlightTo({0.2, 1, 3}), {{"A", 0}, {"A", 0}});
  EXPECT_THAT(VerdictsOf(judged), ElementsAre(Verdict::kFail, Verdict::kFail));
  EXPECT_THAT(judged.faults, IsEmpty());
}

// The errors are of one size, to either side.
TEST(DoubtExpectations, LeaveAnExpectationOnWhichEnginesDoNotAgree) {
  const Judged judged = Judge(FlightTo({0.2, 1, 0}), {{"A", 0.5}, {"B", -0.5}});
  EXPECT_THAT(VerdictsOf(judged), ElementsAre(Verdict::kFail, Verdict::kFail));
  EXPECT_THAT(judged.faults, IsEmpty());
}

}  // namespace
}  // namespace touchstone
