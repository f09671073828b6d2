#include "reports/worlds/study/judge_expectation.h"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reports/worlds/study/judge_world.h"
#include "tests/reports/worlds/fake_simulator.h"
#include "tests/reports/worlds/motions.h"

namespace touchstone {
namespace {

using testing::AllOf;
using testing::HasSubstr;

/** A ball that flies with v = (1, 0, 0) and turns about z at −3 rad/s, and a post. */
World Flight() {
  World world;
  world.gravity_W.setZero();
  world.bodies = {BodyOf("ball", Sphere{0.2}, 1, {0, 1, 0}),
                  BodyOf("post", Sphere{0.2}, 0, {1, 1, 0})};
  world.bodies[0].v_WB = {1, 0, 0};
  world.bodies[0].w_WB = {0, 0, -3};
  world.dt = 0.01;
  world.steps = 50;
  return world;
}

LawFinding Judged(const World& world, const MotionExpectation& expectation) {
  const Trajectory motion = FreeFlight(world);
  return JudgeExpectation({world, DoubleEngine(), motion}, expectation);
}

bool Holds(const LawFinding& finding) {
  return finding.value <= finding.tolerance.value;
}

using Of = ExpectedVector::Of;

TEST(JudgeExpectation, APlaceHoldsToItsTolerance) {
  MotionExpectation expected{"ball", 0.2, 0.01,
                             ExpectedVector{Of::kPosition, {0.205, 1, 0}, {}}, ""};
  EXPECT_TRUE(Holds(Judged(Flight(), expected)));
  expected.tolerance = 0.004;
  const LawFinding wrong = Judged(Flight(), expected);
  EXPECT_FALSE(Holds(wrong));
  EXPECT_EQ(wrong.measure, MeasureKind::kPositionError);
  EXPECT_NEAR(wrong.value, 0.005, 1e-12);
  EXPECT_THAT(wrong.proof,
              AllOf(HasSubstr("“ball” is expected a position of (0.205, 1, 0)"),
                    HasSubstr("at 0.2 s"), HasSubstr(" has (0.2, 1, 0) m")));
  EXPECT_EQ(wrong.cited.names, std::vector<std::string>{"ball"});
  EXPECT_EQ(wrong.cited.time, 0.2);
  ASSERT_EQ(wrong.cited.points_W.size(), 2U);
  EXPECT_EQ(wrong.cited.points_W[0], Eigen::Vector3d(0.205, 1, 0));
}

TEST(JudgeExpectation, AComponentLeavesTheOthersOpen) {
  const Eigen::Vector3d along(3, 0, 0);
  EXPECT_TRUE(
      Holds(Judged(Flight(), {"ball", 0.2, 1e-9,
                              ExpectedVector{Of::kPosition, {0.2, 9, 9}, along}, ""})));
  EXPECT_FALSE(
      Holds(Judged(Flight(), {"ball", 0.2, 1e-9,
                              ExpectedVector{Of::kPosition, {0.3, 1, 0}, along}, ""})));
}

TEST(JudgeExpectation, VelocityAndSpinHaveTheirSign) {
  for (const double sign : {1.0, -1.0}) {
    EXPECT_EQ(
        Holds(Judged(Flight(), {"ball", 0.2, 0.1,
                                ExpectedVector{Of::kVelocity, {sign, 0, 0}, {}}, ""})),
        sign > 0);
    EXPECT_EQ(
        Holds(Judged(Flight(), {"ball", 0.2, 0.1,
                                ExpectedVector{Of::kSpin, {0, 0, 3 * sign}, {}}, ""})),
        sign < 0);
  }
}

TEST(JudgeExpectation, AnAngleHasItsSignAndNoTurns) {
  const auto judged = [&](double angle, const Eigen::Vector3d& axis) {
    return Judged(Flight(), {"ball", 0.4, 0.01, ExpectedAngle{angle, axis}, ""});
  };
  EXPECT_TRUE(Holds(judged(-1.2, {0, 0, 1})));
  EXPECT_TRUE(Holds(judged(1.2, {0, 0, -2})));
  EXPECT_TRUE(Holds(judged(-1.2 + 4 * std::numbers::pi, {0, 0, 1})));
  const LawFinding wrong = judged(1.2, {0, 0, 1});
  EXPECT_FALSE(Holds(wrong));
  EXPECT_EQ(wrong.measure, MeasureKind::kOrientationError);
  EXPECT_THAT(wrong.proof, HasSubstr("an angle of 1.2 rad about (0, 0, 1)"));
}

TEST(JudgeExpectation, AnOrientationMayHaveEitherSignOfItsQuaternion) {
  Eigen::Quaterniond q_WB(Eigen::AngleAxisd(-1.2, Eigen::Vector3d::UnitZ()));
  EXPECT_TRUE(
      Holds(Judged(Flight(), {"ball", 0.4, 0.01, ExpectedOrientation{q_WB}, ""})));
  q_WB.coeffs() *= -1;
  EXPECT_TRUE(
      Holds(Judged(Flight(), {"ball", 0.4, 0.01, ExpectedOrientation{q_WB}, ""})));
  EXPECT_FALSE(
      Holds(Judged(Flight(), {"ball", 0.4, 0.01,
                              ExpectedOrientation{Eigen::Quaterniond::Identity()}, ""})));
}

TEST(JudgeExpectation, ATouchIsSeenWhereBodiesMeet) {
  World world = Flight();
  world.steps = 100;
  const auto judged = [&](double at) {
    return Judged(world, {"ball", at, 0.001, ExpectedTouch{"post"}, ""});
  };
  // The surfaces are 0.6 m apart.
  EXPECT_TRUE(Holds(judged(0.6)));
  const LawFinding late = judged(0.7);
  EXPECT_FALSE(Holds(late));
  EXPECT_EQ(late.measure, MeasureKind::kEventTime);
  EXPECT_NEAR(late.value, 0.1, 0.02);
  EXPECT_THAT(late.proof, HasSubstr("“ball” is expected to touch “post” first at 0.7 s"));
  EXPECT_EQ(late.cited, (Cited{{"ball", "post"}, 0.7, {}, 0.7}));
  world.steps = 50;
  const LawFinding never = judged(0.5);
  EXPECT_EQ(never.value, std::numeric_limits<double>::infinity());
  EXPECT_THAT(never.proof, HasSubstr("has never"));
}

TEST(MetBy, AMotionMeetsWhatItHas) {
  World world = Flight();
  world.steps = 100;
  const Trajectory motion = FreeFlight(world);
  const ReferenceState elsewhere{
      0.3, "ball", {9, 9, 9}, Eigen::Quaterniond(0, 1, 0, 0), 2};
  const auto stated = std::to_array<decltype(MotionExpectation::what)>(
      {ExpectedVector{Of::kPosition, {9, 9, 9}, {}},
       ExpectedVector{Of::kVelocity, {9, 9, 9}, Eigen::Vector3d(1, 2, 3)},
       ExpectedVector{Of::kSpin, {9, 9, 9}, {}},
       ExpectedOrientation{Eigen::Quaterniond(0, 1, 0, 0)}, ExpectedAngle{2, {0, 1, 2}},
       ExpectedTouch{"post"}, ExpectedTopple{false},
       ExpectedTrajectory{"other.csv", {elsewhere}}});
  for (const auto& what : stated) {
    const MotionExpectation expected{"ball", 0.9, 1e-9, what, ""};
    const Motion seen{world, DoubleEngine(), motion};
    EXPECT_GT(JudgeExpectation(seen, expected).value, 0.1) << what.index();
    const std::optional<MotionExpectation> met = MetBy(seen, expected);
    ASSERT_TRUE(met) << what.index();
    EXPECT_NEAR(JudgeExpectation(seen, *met).value, 0, 1e-12) << what.index();
  }
  EXPECT_FALSE(
      MetBy({world, DoubleEngine(), motion}, {"ball", 0.9, 1e-9, ExpectedRest{}, ""}));
}

TEST(JudgeExpectation, ATouchIsSeenInTheImpulsesOfAnEngine) {
  const World world = Flight();
  Trajectory motion = FreeFlight(world);
  motion.gives_impulses = true;
  motion.impulses = {{20, 1, 0, {0, 0, 0}, {1, 0, 0}, {0, 0, 0}, 0},
                     {30, 1, 0, {0, 0, 0}, {1, 0, 0}, {-1, 0, 0}, 0}};
  const LawFinding touched = JudgeExpectation(
      {world, DoubleEngine(), motion}, {"ball", 0.3, 0.001, ExpectedTouch{"post"}, ""});
  EXPECT_NEAR(touched.value, 0, 1e-12);
}

TEST(JudgeExpectation, ATopplingBodyTiltsByMoreThanAnEighthOfATurn) {
  // It turns at 3 rad/s, by 45° after 0.262 s.
  const auto judged = [&](bool topples, double by) {
    return Judged(Flight(), {"ball", by, 0, ExpectedTopple{topples}, ""});
  };
  EXPECT_TRUE(Holds(judged(true, 0.3)));
  EXPECT_FALSE(Holds(judged(true, 0.2)));
  EXPECT_TRUE(Holds(judged(false, 0.2)));
  EXPECT_FALSE(Holds(judged(false, 0.4)));
  // The samples on both sides of the event, 0.01 s apart, decide.
  EXPECT_FALSE(Holds(judged(true, 0.26)));
  EXPECT_TRUE(Holds(judged(false, 0.26)));
  EXPECT_TRUE(Holds(judged(true, 0.27)));
  EXPECT_FALSE(Holds(judged(false, 0.27)));
  World upright = Flight();
  upright.bodies[0].w_WB = {0, 3, 0};
  const auto still = [&](bool topples) {
    return Judged(upright, {"ball", 0.5, 0, ExpectedTopple{topples}, ""});
  };
  EXPECT_FALSE(Holds(still(true)));
  EXPECT_TRUE(Holds(still(false)));
}

TEST(JudgeExpectation, RestIsJudgedFromItsTimeToTheEnd) {
  World world = Flight();
  const Trajectory stopping = Sampled(world, [&](double t) {
    WorldState state = FreeFlight(world).samples.front();
    state.bodies[0].v_WB = {t < 0.295 ? 1.0 : 0.001, 0, 0};
    state.bodies[0].w_WB.setZero();
    return state;
  });
  const auto judged = [&](double by) {
    return JudgeExpectation({world, DoubleEngine(), stopping},
                            {"ball", by, 0.01, ExpectedRest{}, ""});
  };
  EXPECT_TRUE(Holds(judged(0.3)));
  EXPECT_FALSE(Holds(judged(0.29)));
  EXPECT_EQ(judged(0.29).measure, MeasureKind::kVelocityError);
}

TEST(JudgeExpectation, ASpeedThatIsNoNumberIsNoRest) {
  const World world = Flight();
  const Trajectory lost = Sampled(world, [&](double t) {
    WorldState state = FreeFlight(world).samples.front();
    state.bodies[0].v_WB.setZero();
    state.bodies[0].w_WB.setZero();
    if (t > 0.245 && t < 0.255) state.bodies[0].w_WB.x() = std::nan("");
    return state;
  });
  EXPECT_FALSE(Holds(JudgeExpectation({world, DoubleEngine(), lost},
                                      {"ball", 0.1, 0.01, ExpectedRest{}, ""})));
}

TEST(JudgeExpectation, AReferenceTrajectoryHoldsEveryPointOfABody) {
  const Eigen::Quaterniond q_WB(Eigen::AngleAxisd(-1.2, Eigen::Vector3d::UnitZ()));
  ExpectedTrajectory reference{
      "r.csv", {{0.2, "ball", {0.2, 1, 0}, {}, 2}, {0.4, "ball", {0.4, 1, 0}, q_WB, 3}}};
  const auto judged = [&] { return Judged(Flight(), {"", 0, 0.01, reference, ""}); };
  EXPECT_TRUE(Holds(judged()));
  // 0.1 rad at a radius of 0.2 m are 0.02 m.
  reference.states[1].q_WB =
      Eigen::Quaterniond(Eigen::AngleAxisd(-1.1, Eigen::Vector3d::UnitZ()));
  EXPECT_NEAR(judged().value, 0.02, 1e-9);
  reference.states[0].p_W.z() = 0.03;
  EXPECT_FALSE(Holds(judged()));
  EXPECT_THAT(judged().proof, HasSubstr("r.csv:2 expects “ball” at (0.2, 1, 0.03)"));
  EXPECT_EQ(judged().cited.names, std::vector<std::string>{"ball"});
  EXPECT_THAT(judged().cited.points_W,
              testing::ElementsAre(Eigen::Vector3d(0.2, 1, 0.03)));
}

TEST(JudgeExpectation, AFailureFailsTheMotionAndNamesTheExpectation) {
  WorldScenario scenario;
  scenario.id = "mine/flight";
  scenario.world = Flight();
  scenario.expectations = {
      {"ball", 0.2, 0.01, ExpectedVector{Of::kPosition, {0.2, 1, 0}, {}}, ""},
      {"ball", 0.2, 0.01, ExpectedVector{Of::kPosition, {0.3, 1, 0}, {}}, "Measured."}};
  const FakeSimulator engine("mine",
                             [](const World& world) { return FreeFlight(world); });
  const Trajectory motion = engine.Simulate(scenario.world);
  int judged = 0;
  for (const Finding& finding : JudgeWorld({scenario, engine.info(), motion})) {
    if (!finding.law.starts_with("expect")) continue;
    EXPECT_EQ(finding.verdict == Verdict::kFail, finding.law == "expect[1]");
    EXPECT_FALSE(finding.universal);
    ++judged;
    if (finding.verdict != Verdict::kFail) continue;
    EXPECT_THAT(finding.proof, HasSubstr("expect[1]: “ball” is expected a position of"));
    EXPECT_THAT(finding.tolerance_because, HasSubstr("Measured."));
  }
  EXPECT_EQ(judged, 2);
}

}  // namespace
}  // namespace touchstone
