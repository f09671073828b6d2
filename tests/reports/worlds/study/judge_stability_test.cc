#include "reports/worlds/study/judge_stability.h"

#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reports/worlds/study/run_worlds.h"
#include "tests/reports/worlds/fake_simulator.h"
#include "tests/reports/worlds/motions.h"

namespace touchstone {
namespace {

constexpr double kH = 0.01;       // [s]
constexpr double kG = 9.81;       // [m/s²]
constexpr double kSpeed = 3;      // [m/s]
constexpr double kBraking = 4.9;  // [m/s²]

//   ____
//  |    |-->     A box that slides over the floor and starts a rounding error above it.
//  '----'
//  ---------
WorldScenario SlidingBox() {
  WorldScenario scenario;
  scenario.id = "world/test/slide";
  RigidBody box = BodyOf("box", Box{{0.3, 0.2, 0.1}}, 2, {0.3, 0.2, 1.7});
  box.v_WB = {kSpeed, 0, 0};
  scenario.world.bodies = {GroundOf(), box};
  scenario.world.gravity_W = {0, -kG, 0};
  scenario.world.dt = kH;
  scenario.world.steps = 40;
  return scenario;
}

/** Returns a motion of the box in which the contact is detected only after `late` steps.
 Until then the box slides freely and falls; from then on it brakes. `off` is added to all
 its positions. */
Trajectory Slides(const World& world, int late, const Eigen::Vector3d& off) {
  return Sampled(world, [&](double t) {
    WorldState state;
    for (const RigidBody& body : world.bodies)
      state.bodies.push_back({body.placed.X_WB.p_WB,
                              Eigen::Quaterniond(body.placed.X_WB.R_WB), body.v_WB,
                              body.w_WB});
    const double seen = late * kH;
    const double braked = std::max(0.0, t - seen);
    BodyState& box = state.bodies[1];
    const double way = kSpeed * t - kBraking * braked * braked / 2;
    const double fall = kG * std::min(t, seen) * kH;
    box.p_WB += Eigen::Vector3d(way, -fall, 0) + off;
    box.v_WB.x() -= kBraking * braked;
    return state;
  });
}

Finding JudgedBeside(const std::vector<Trajectory>& nudged) {
  const WorldScenario scenario = SlidingBox();
  const Trajectory in_time = Slides(scenario.world, 0, Eigen::Vector3d::Zero());
  return JudgeStability({scenario, DoubleEngine(), in_time}, 10, nudged);
}

TEST(JudgeStability, AllowsAContactToBeDetectedAStepLate) {
  const World world = SlidingBox().world;
  const Finding finding =
      JudgedBeside({Slides(world, 0, Eigen::Vector3d::Constant(1e-15)),
                    Slides(world, 1, Eigen::Vector3d::Zero())});
  EXPECT_EQ(finding.verdict, Verdict::kPass) << finding.proof;
  EXPECT_GT(finding.value, kBraking * 40 * kH * kH / 2);
  EXPECT_NEAR(finding.tolerance, 1.5 * kH * (kSpeed + 2 * kG * kH), 1e-9);
}

TEST(JudgeStability, FindsTheWorstOfSeveralNudges) {
  const World world = SlidingBox().world;
  const Finding finding =
      JudgedBeside({Slides(world, 0, Eigen::Vector3d::Zero()),
                    Slides(world, 0, {0, 0, 0.07}), Slides(world, 1, {0, 0, 0.01})});
  EXPECT_EQ(finding.verdict, Verdict::kFail);
  EXPECT_EQ(finding.cause, Cause::kDefect);
  EXPECT_NEAR(finding.value, 0.07, 1e-12);
  EXPECT_THAT(finding.proof, testing::HasSubstr(" m away if its start is moved "));
}

TEST(JudgeStability, QuotesWhatTheEnginePrinted) {
  Trajectory failed = Slides(SlidingBox().world, 0, {0, -1, 0});
  failed.complaint = "LCP internal error";
  EXPECT_THAT(JudgedBeside({failed}).proof,
              testing::HasSubstr("(it printed: LCP internal error)"));
}

}  // namespace
}  // namespace touchstone
