#include "reports/worlds/study/motion_scale.h"

#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

namespace touchstone {
namespace {

/** A ball of 0.1 m and 2 kg under gravity of 10 m/s². */
World Ball() {
  World world;
  world.gravity_W = {0, -10, 0};
  world.bodies.emplace_back();
  world.bodies[0].placed.shape = Sphere{0.1};
  world.bodies[0].mass = 2;
  return world;
}

/** The ball with that velocity and spin. */
Trajectory Moving(double v, double w) {
  Trajectory trajectory;
  trajectory.times = {0};
  trajectory.samples = {{{{Eigen::Vector3d::Zero(), Eigen::Quaterniond::Identity(),
                           Eigen::Vector3d(v, 0, 0), Eigen::Vector3d(0, w, 0)}},
                         {},
                         {}}};
  return trajectory;
}

Finding Of(MeasureKind measure, double value) {
  Finding finding;
  finding.measure = measure;
  finding.value = value;
  return finding;
}

TEST(ScaleOf, TakesTheFastestOfAMotionAndItsSmallestBody) {
  World world = Ball();
  world.bodies.push_back(world.bodies[0]);
  world.bodies[1].placed.shape = Sphere{5};
  world.bodies[1].mass = 0;  // The ground does not count.
  Trajectory motion = Moving(3, 10);
  motion.samples[0].bodies.push_back(motion.samples[0].bodies[0]);
  const MotionScale scale = ScaleOf(world, motion.samples);
  EXPECT_EQ(scale.length, 0.2);
  EXPECT_NEAR(scale.speed, 3 + 10 * 0.1, 1e-12);
  EXPECT_EQ(scale.mass, 2);
}

TEST(ScaleOf, GivesABodyAtRestTheSpeedOfAFallOverItsSize) {
  EXPECT_NEAR(ScaleOf(Ball(), Moving(0, 0).samples).speed, std::sqrt(10 * 0.2), 1e-12);
  EXPECT_NEAR(ScaleOf(Ball(), {}).speed, std::sqrt(10 * 0.2), 1e-12);
}

// Two balls at rest that a rod of 1e-10 m too much moves are no fault of their motion.
TEST(ScaleOf, TakesNoMotionThatNobodySees) {
  World world = Ball();
  world.gravity_W.setZero();
  world.dt = 0.01;
  world.steps = 200;
  EXPECT_NEAR(ScaleOf(world, Moving(1e-10, 0).samples).speed, 1e-6 * 0.2 / 2, 1e-15);
  EXPECT_NEAR(ScaleOf(world, Moving(3, 0).samples).speed, 3, 1e-12);
}

TEST(ScaleOf, TakesTheExtentOfParticlesWhereNoBodyMoves) {
  World world;
  world.particles.emplace_back();
  Trajectory motion;
  motion.times = {0, 1};
  motion.samples = {{{}, {{Eigen::Vector3d(1, 0, 0), Eigen::Vector3d::Zero()}}, {}},
                    {{}, {{Eigen::Vector3d(1, -4, 0), Eigen::Vector3d::Zero()}}, {}}};
  EXPECT_EQ(ScaleOf(world, motion.samples).length, 4);
  // Two that hang still have an extent, too.
  for (WorldState& state : motion.samples)
    state.particles = {{Eigen::Vector3d(1, 0, 0), Eigen::Vector3d::Zero()},
                       {Eigen::Vector3d(1, 3, 4), Eigen::Vector3d::Zero()}};
  EXPECT_EQ(ScaleOf(world, motion.samples).length, 5);
}

// L = 0.2 m, V = 4 m/s, M = 2 kg.
TEST(ShareOf, DividesEachUnitByTheScaleOfItsOwn) {
  const MotionScale scale{.length = 0.2, .speed = 4, .mass = 2};
  EXPECT_NEAR(ShareOf(Of(MeasureKind::kPositionError, 0.1), scale), 0.5, 1e-15);
  EXPECT_NEAR(ShareOf(Of(MeasureKind::kVelocityError, 0.1), scale), 0.025, 1e-15);
  EXPECT_NEAR(ShareOf(Of(MeasureKind::kSpinError, 2), scale), 0.1, 1e-15);
  EXPECT_NEAR(ShareOf(Of(MeasureKind::kMomentumDrift, 0.8), scale), 0.1, 1e-15);
  EXPECT_NEAR(ShareOf(Of(MeasureKind::kAngularMomentumDrift, 0.8), scale), 0.5, 1e-15);
  EXPECT_NEAR(ShareOf(Of(MeasureKind::kEnergyDrift, 1.6), scale), 0.1, 1e-15);
  EXPECT_NEAR(ShareOf(Of(MeasureKind::kForceError, 16), scale), 0.1, 1e-15);
  EXPECT_NEAR(ShareOf(Of(MeasureKind::kEventTime, 0.01), scale), 0.2, 1e-15);
  EXPECT_EQ(ShareOf(Of(MeasureKind::kOrientationError, 0.3), scale), 0.3);
  EXPECT_EQ(ShareOf(Of(MeasureKind::kEnergyDrift, 0), {}), 0);
  EXPECT_EQ(ShareOf(Of(MeasureKind::kEnergyDrift, 1), {}),
            std::numeric_limits<double>::infinity());
}

TEST(GradeOf, OfAMotionFollowsItsShare) {
  const MotionScale scale{.length = 1, .speed = 1, .mass = 1};
  const auto grade = [&](MeasureKind measure, double value) {
    return GradeOf(Of(measure, value), scale);
  };
  EXPECT_EQ(grade(MeasureKind::kPenetration, 1e-7), Grade::kRounding);
  EXPECT_EQ(grade(MeasureKind::kPenetration, 1e-4), Grade::kSmall);
  EXPECT_EQ(grade(MeasureKind::kPenetration, 1e-2), Grade::kLarge);
  EXPECT_EQ(grade(MeasureKind::kPenetration, 0.2), Grade::kGross);
  EXPECT_EQ(grade(MeasureKind::kPenetration, NAN), Grade::kGross);
  EXPECT_EQ(grade(MeasureKind::kPassage, 0.01), Grade::kWrongTouch);
  EXPECT_EQ(grade(MeasureKind::kPassage, 1e-9), Grade::kRounding);
  EXPECT_EQ(grade(MeasureKind::kDeterminism, 1), Grade::kLarge);
  EXPECT_EQ(grade(MeasureKind::kObservedOrder, 1), Grade::kLarge);
  EXPECT_EQ(grade(MeasureKind::kDeterminism, 1e-9), Grade::kRounding);
}

TEST(GradeFaults, GradesWhatIsNoMotionAsUnusable) {
  std::vector<Finding> findings(3, Of(MeasureKind::kPenetration, 1e-2));
  findings[0].verdict = Verdict::kFail;
  findings[1].verdict = Verdict::kInvalid;
  findings[2].verdict = Verdict::kPass;
  GradeFaults({.length = 1, .speed = 1, .mass = 1}, findings);
  EXPECT_EQ(findings[0].grade, Grade::kLarge);
  EXPECT_EQ(findings[1].grade, Grade::kUnusable);
  EXPECT_EQ(findings[2].grade, Grade::kNone);
}

}  // namespace
}  // namespace touchstone
