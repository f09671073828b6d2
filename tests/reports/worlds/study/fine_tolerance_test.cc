#include "reports/worlds/study/fine_tolerance.h"

#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reports/worlds/truth/mechanics.h"

namespace touchstone {
namespace {

using testing::HasSubstr;

/** A ball of 0.1 m and 2 kg that moves at 3 m/s without loads, and a thin wall. */
World BallAndWall() {
  World world;
  world.gravity_W.setZero();
  world.dt = 0.01;
  world.steps = 1;
  world.bodies.resize(2);
  world.bodies[0].placed.shape = Sphere{0.1};
  world.bodies[0].mass = 2;
  world.bodies[0].v_WB = {3, 0, 0};
  world.bodies[1].mass = 0;
  world.bodies[1].placed.shape = Box{{1, 1, 0.0005}};
  return world;
}

/** The fine tolerances of the ball, by an engine that moves it at that speed. */
FineTolerance FineAt(double speed, const World& world = BallAndWall()) {
  Trajectory motion;
  motion.status = AnswerStatus::kAnswered;
  motion.times = {0, world.dt};
  motion.samples = {2, StateAtStart(world)};
  motion.samples[1].bodies[0].v_WB.x() = speed;
  const OracleInfo oracle;
  return FineTolerance({world, oracle, motion});
}

Finding Passed(MeasureKind measure, double value, double tolerance) {
  Finding finding;
  finding.measure = measure;
  finding.value = value;
  finding.tolerance = tolerance;
  finding.tolerance_because = "the step";
  return finding;
}

Finding Required(Finding finding) {
  FineAt(3).Require(finding);
  return finding;
}

TEST(FineTolerance, IsAHundredthOfTheMotion) {
  const FineTolerance fine = FineAt(3);
  EXPECT_NEAR(fine.Of(MeasureKind::kPositionError), 0.002, 1e-12);
  EXPECT_NEAR(fine.Of(MeasureKind::kVelocityError), 0.03, 1e-12);
  EXPECT_NEAR(fine.Of(MeasureKind::kEnergyDrift), 0.09, 1e-12);
  EXPECT_NEAR(fine.Of(MeasureKind::kOrientationError), 0.01, 1e-12);
  EXPECT_EQ(fine.Of(MeasureKind::kRestitution), 0.01);
}

TEST(FineTolerance, OfADepthIsLessThanAThinBox) {
  EXPECT_EQ(FineAt(3).Of(MeasureKind::kPenetration), 0.0005);
  EXPECT_EQ(FineAt(3).Of(MeasureKind::kPassage), 0.0005);
}

TEST(FineTolerance, HasNoLimitForWhatHasNoSize) {
  EXPECT_TRUE(std::isinf(FineAt(3).Of(MeasureKind::kObservedOrder)));
  EXPECT_TRUE(std::isinf(FineAt(3).Of(MeasureKind::kAnswering)));
}

// Twice the true energy is the most that a motion may enlarge it by.
TEST(FineTolerance, IsNotWidenedByAnEngineThatGainsSpeed) {
  EXPECT_LE(FineAt(300).Of(MeasureKind::kVelocityError), 0.03 * 1.5);
  EXPECT_LE(FineAt(300).Of(MeasureKind::kEnergyDrift), 0.09 * 2.1);
}

TEST(FineTolerance, NarrowsAPassThatItAllows) {
  const Finding narrow = Required(Passed(MeasureKind::kPositionError, 0.001, 0.001));
  EXPECT_EQ(narrow.tolerance_because, "the step");
  const Finding narrowed = Required(Passed(MeasureKind::kPositionError, 0.0019, 0.5));
  EXPECT_EQ(narrowed.verdict, Verdict::kPass);
  EXPECT_NEAR(narrowed.tolerance, 0.002, 1e-12);
  EXPECT_EQ(narrowed.tolerance_because,
            "narrowed to 0.002 m, a hundredth of the smallest moving body: the step");
  EXPECT_THAT(Required(Passed(MeasureKind::kPenetration, 0, 1)).tolerance_because,
              HasSubstr("narrowed to 0.0005 m, half the thickness of the thinnest box"));
}

TEST(FineTolerance, WithdrawsAPassThatNothingShowsToBeRight) {
  const Finding coarse = Required(Passed(MeasureKind::kPositionError, 0.0021, 0.5));
  EXPECT_EQ(coarse.verdict, Verdict::kUndecidable);
  EXPECT_EQ(coarse.undecided, Undecided::kCoarse);
  EXPECT_EQ(coarse.tolerance, 0.5);
  EXPECT_THAT(coarse.tolerance_because, HasSubstr("wider than 0.002 m"));
}

TEST(FineTolerance, ChangesNothingElse) {
  Finding failed = Passed(MeasureKind::kPositionError, 0.6, 0.5);
  failed.verdict = Verdict::kFail;
  EXPECT_EQ(Required(failed).verdict, Verdict::kFail);
  EXPECT_EQ(Required(failed).tolerance, 0.5);
  // A recognised model passes beyond its tolerance.
  Finding recognised = Passed(MeasureKind::kPositionError, 0.6, 0.5);
  recognised.reference = "law";
  recognised.cause = Cause::kModel;
  recognised.cause_because = "simultaneous impacts";
  EXPECT_EQ(Required(recognised).verdict, Verdict::kPass);
}

}  // namespace
}  // namespace touchstone
