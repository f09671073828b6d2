#include "oracles/function_simulator.h"

#include <limits>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "docs/examples/my_world.h"

namespace touchstone {
namespace {

using testing::HasSubstr;
using enum WorldFeature;

World BallOnGround() {
  World world;
  world.gravity_W = {0, 0, -10};
  world.dt = 0.01;
  world.steps = 10;
  RigidBody ground;
  ground.name = "ground";
  ground.placed.shape = HalfSpace{};
  ground.mass = 0;
  RigidBody ball;
  ball.name = "ball";
  ball.placed = {Sphere{0.1}, {}};
  ball.placed.X_WB.p_WB = {0, 0, 5};
  ball.v_WB = {1, 0, 0};
  world.bodies = {ground, ball};
  world.bodies[0].friction = 0;
  return world;
}

SimulatorPromises Slop(double slop, std::string by) {
  return {.simulates = {kSphere}, .slop = slop, .documented_by = std::move(by)};
}

TEST(MakeSimulator, RunsTheUsersEngine) {
  const auto mine = MakeSimulator<MyWorld>("mine", MyWorldSimulates());
  const Trajectory trajectory = mine->Simulate(BallOnGround());
  ASSERT_EQ(trajectory.status, AnswerStatus::kAnswered) << trajectory.reason;
  ASSERT_EQ(trajectory.samples.size(), 11U);
  // Semi-implicit Euler: g h² (1 + 2 + … + 10) below the start.
  const Eigen::Vector3d p_W = trajectory.samples.back().bodies[1].p_WB;
  EXPECT_NEAR(p_W.x(), 0.1, 1e-12);
  EXPECT_NEAR(p_W.z(), 5 - 10 * 1e-4 * 55, 1e-12);
}

TEST(MakeSimulator, SimulatesOnlyWhatItNames) {
  const auto mine = MakeSimulator<MyWorld>("mine", MyWorldSimulates());
  World world = BallOnGround();
  world.bodies[1].placed.shape = Box{{1, 1, 1}};
  EXPECT_EQ(mine->info().CannotSimulate(world), "not among what mine simulates");
  world = BallOnGround();
  world.bodies[0].friction = 0.5;
  EXPECT_NE(mine->info().CannotSimulate(world), "");
  world = BallOnGround();
  world.bodies.push_back(world.bodies[1]);
  EXPECT_NE(mine->info().CannotSimulate(world), "") << "two balls may meet";
  EXPECT_EQ(mine->Simulate(world).status, AnswerStatus::kUnsupported);
}

TEST(MakeSimulator, AnswersNoContactQuery) {
  const auto mine = MakeSimulator<MyWorld>("mine", MyWorldSimulates());
  EXPECT_FALSE(mine->info().AnswersContacts());
  const ContactAnswer answer = mine->Answer({{Sphere{1}, {}}, {Sphere{1}, {}}});
  EXPECT_EQ(answer.status, AnswerStatus::kUnsupported);
  EXPECT_THAT(answer.reason, HasSubstr("moves worlds only"));
}

TEST(MakeSimulator, TurnsAnExceptionIntoACrash) {
  const auto mine = MakeSimulator(
      "mine",
      [](const World&) -> std::unique_ptr<Simulation> {
        throw std::runtime_error("out of worlds");
      },
      MyWorldSimulates());
  const Trajectory trajectory = mine->Simulate(BallOnGround());
  EXPECT_EQ(trajectory.status, AnswerStatus::kCrashed);
  EXPECT_THAT(trajectory.reason, HasSubstr("out of worlds"));
}

TEST(MakeSimulator, ShowsADocumentedSlop) {
  const auto mine = MakeSimulator<MyWorld>("mine", Slop(0.005, "section 4"));
  EXPECT_EQ(mine->info().slop, 0.005);
  const Setting& shown = mine->info().settings.back();
  EXPECT_EQ(shown.value, "0.005 m");
  EXPECT_THAT(shown.why, HasSubstr("documented by section 4"));
  EXPECT_EQ(MakeSimulator<MyWorld>("mine", MyWorldSimulates())->info().slop, 0);
}

TEST(MakeSimulator, RefusesASlopThatIsDocumentedNowhereOrThatIsNoLength) {
  EXPECT_THROW(MakeSimulator<MyWorld>("mine", Slop(0.005, "")), std::invalid_argument);
  for (const double slop : {-0.1, std::numeric_limits<double>::infinity(),
                            std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_THROW(MakeSimulator<MyWorld>("mine", Slop(slop, "section 4")),
                 std::invalid_argument);
  }
}

TEST(EverythingExcept, LeavesOutOnlyWhatIsNamed) {
  const std::vector<WorldFeature> features = EverythingExcept({kCloth, kMovingBodies});
  EXPECT_EQ(features.size(), static_cast<std::size_t>(kWorldFeatures - 2));
  for (const WorldFeature feature : features) {
    EXPECT_NE(feature, kCloth);
    EXPECT_NE(feature, kMovingBodies);
  }
}

}  // namespace
}  // namespace touchstone
