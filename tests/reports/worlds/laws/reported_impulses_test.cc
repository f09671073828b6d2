#include "reports/worlds/law_support/reported_impulses.h"

#include <array>
#include <string>

#include <gtest/gtest.h>

#include "reports/worlds/truth/mechanics.h"
#include "tests/reports/worlds/motions.h"

namespace touchstone {
namespace {

constexpr double kRadius = 0.2;

/** An engine that puts bodies to sleep that are slower than `speed` [m/s]. */
OracleInfo Sleeping(double speed) {
  OracleInfo info = DoubleEngine();
  info.sleep_speed = speed;
  info.sleep_documented_by = "the parameter sleep_speed";
  return info;
}

World BallAt(double height) {
  World world;
  world.bodies = {BodyOf("ball", Sphere{kRadius}, 2, {0, kRadius + height, 0}),
                  GroundOf()};
  world.steps = 20;
  return world;
}

/** Returns the motion of a ball that does not move, with a contact in each step that
 carries `share` of its weight and `across` [N s] along the ground. */
Trajectory Still(const World& world, double share, double across = 0) {
  Trajectory still = Stepped(world, [](WorldState&) {});
  still.gives_impulses = true;
  const RigidBody& ball = world.bodies[0];
  const Eigen::Vector3d carried_W = -share * world.dt * ball.mass * world.gravity_W;
  for (int step = 1; share != 0 && step <= world.steps; ++step) {
    still.impulses.push_back({step,
                              1,
                              0,
                              {0, 0, 0},
                              {0, 1, 0},
                              carried_W + across * Eigen::Vector3d::UnitX(),
                              0});
  }
  return still;
}

constexpr std::array kBalances = {"momentum_balance", "angular_momentum_balance"};

TEST(SleepLoss, IsWhatTheSleepSpeedAllowsOfABodyThatIsCarried) {
  const World world = BallAt(0);
  const Trajectory still = Still(world, 1);
  const OracleInfo oracle = Sleeping(0.05);
  const Motion motion{world, oracle, still};
  const ReportedImpulses reported = ReportedBefore(motion, 3);
  const SleepLoss loss = SleepLossBefore(motion, reported, 0, 3);
  EXPECT_DOUBLE_EQ(loss.momentum, 2 * 0.05);
  EXPECT_DOUBLE_EQ(loss.angular, 0.4 * 2 * kRadius * kRadius * 0.05 / kRadius);
}

TEST(SleepLoss, IsNothingForABodyThatMovesAndForEnginesWithoutSleep) {
  const World world = BallAt(0);
  const OracleInfo sleeping = Sleeping(0.05);
  Trajectory motion = Still(world, 1);
  motion.samples[3].bodies[0].w_WB = {0, 1e-9, 0};
  const Motion moves{world, sleeping, motion};
  EXPECT_EQ(SleepLossBefore(moves, ReportedBefore(moves, 3), 0, 3).momentum, 0);
  const Motion awake{world, DoubleEngine(), motion};
  EXPECT_EQ(SleepLossBefore(awake, ReportedBefore(awake, 2), 0, 2).momentum, 0);
}

TEST(SleepLoss, LetsTheImpulsesOfASleepingBodyBeThoseOfTheStepBefore) {
  // They are off by what it lost: by 0.04 m/s of the 0.05 m/s that are documented.
  const World world = BallAt(0);
  const Trajectory still = Still(world, 1, 0.04 * world.bodies[0].mass);
  const Claim claim = ClaimOf("momentum_balance");
  EXPECT_TRUE(Passes(Judge(world, still, claim, Sleeping(0.05))));
  EXPECT_TRUE(
      Finds(Judge(world, still, claim, Sleeping(0.03)), MeasureKind::kMomentumBalance));
  EXPECT_TRUE(Finds(Judge(world, still, claim), MeasureKind::kMomentumBalance));
}

TEST(SleepLoss, IsNotGrantedToABodyThatIsFrozenInTheAir) {
  // g h is 0.04 m/s, less than either sleep speed.
  const World world = BallAt(0.5);
  const Claim claim = ClaimOf("momentum_balance");
  for (const double speed : {0.05, 10.0}) {
    EXPECT_TRUE(Finds(Judge(world, Still(world, 0), claim, Sleeping(speed)),
                      MeasureKind::kMomentumBalance))
        << speed;
    // A wall beside it carries nothing.
    EXPECT_TRUE(Finds(Judge(world, Still(world, 1e-3), claim, Sleeping(speed)),
                      MeasureKind::kMomentumBalance))
        << speed;
  }
}

TEST(SleepLoss, IsInTheOriginOfTheTolerance) {
  EXPECT_EQ(WithSleep("rounding", DoubleEngine()), "rounding");
  EXPECT_EQ(WithSleep("rounding", Sleeping(0.05)),
            "rounding; and what a body loses that falls asleep, at 0.05 m/s at most (the "
            "parameter sleep_speed)");
  const World world = BallAt(0);
  for (const char* const law : kBalances) {
    for (const LawFinding& finding :
         Judge(world, Still(world, 1), ClaimOf(law), Sleeping(0.05))) {
      EXPECT_NE(finding.tolerance.because.find("falls asleep"), std::string::npos) << law;
    }
  }
}

}  // namespace
}  // namespace touchstone
