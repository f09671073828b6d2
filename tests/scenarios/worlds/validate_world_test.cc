#include "scenarios/worlds/validate_world.h"

#include <limits>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace touchstone {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

/** Returns a world made in C++, which has no file for diagnostics to refer to. */
World TwoBalls() {
  World world;
  world.bodies.resize(2);
  world.bodies[0].name = "ball";
  world.bodies[0].placed.shape = Sphere{0.5};
  world.bodies[1].name = "other";
  world.bodies[1].placed.shape = Sphere{0.5};
  world.bodies[1].placed.X_WB = Pose::FromQuaternion({2, 0, 0}, {1, 0, 0, 0});
  return world;
}

std::vector<std::string> Texts(const std::vector<Fault>& faults) {
  std::vector<std::string> texts;
  for (const Fault& fault : faults) {
    texts.push_back(fault.where + ' ' + fault.what + "; expected " + fault.expected);
  }
  return texts;
}

TEST(FaultsOfWorld, AreEmptyForAValidWorld) {
  EXPECT_THAT(Texts(FaultsOf(TwoBalls())), IsEmpty());
}

TEST(FaultsOfWorld, NameABodyByItsName) {
  World world = TwoBalls();
  world.bodies[1].mass = std::numeric_limits<double>::quiet_NaN();
  world.bodies[0].placed.shape = Sphere{-1};
  EXPECT_THAT(Texts(FaultsOf(world)),
              ElementsAre("bodies.ball.radius is -1; expected a finite length > 0",
                          "bodies.other.mass is nan; expected a finite number >= 0"));
}

TEST(FaultsOfWorld, NameABodyWithoutANameByItsIndex) {
  World world = TwoBalls();
  world.bodies[1].name = "";
  EXPECT_THAT(Texts(FaultsOf(world)),
              ElementsAre("bodies[1] is named \"\"; "
                          "expected a name of A-Z, a-z, 0-9, _ and -"));
}

TEST(FaultsOfWorld, IncludeADuplicateName) {
  World world = TwoBalls();
  world.bodies[1].name = "ball";
  world.particles.push_back({"ball"});
  EXPECT_THAT(Texts(FaultsOf(world)),
              ElementsAre("bodies.ball has the name of bodies.ball; "
                          "expected a unique name",
                          "particles.ball has the name of bodies.ball; "
                          "expected a unique name"));
}

TEST(FaultsOfWorld, IncludeAnchorsThatDoNotExist) {
  World world = TwoBalls();
  world.springs.push_back({{AnchorKind::kBody, 2}, {AnchorKind::kParticle, 0}});
  world.joints.push_back({{AnchorKind::kWorld, 0}, {AnchorKind::kBody, -1}, 1});
  EXPECT_THAT(Texts(FaultsOf(world)),
              ElementsAre("springs[0].A has index 2; expected an index into the bodies",
                          "springs[0].B has index 0; "
                          "expected an index into the particles",
                          "joints[0].A has index 0; expected -1 for the world",
                          "joints[0].B has index -1; "
                          "expected an index into the bodies"));
}

TEST(FaultsOfWorld, IncludeARodBetweenPointsThatAreEqualUpToRounding) {
  World world = TwoBalls();
  // 0.1 + 0.2 is one rounding away from 0.3.
  world.joints.push_back({{AnchorKind::kWorld, -1, {0.1 + 0.2, 0, 0}},
                          {AnchorKind::kBody, 0, {0.3, 0, 0}},
                          1});
  EXPECT_THAT(Texts(FaultsOf(world)),
              ElementsAre("joints[0].B is at the same point as A; expected two ends at "
                          "different points"));
}

TEST(FaultsOfWorld, IncludePushesOfNoBodyAndBetweenNoSteps) {
  World world = TwoBalls();
  world.pushes = {{2, 0}, {0, 0.5 / 240}, {0, 1}, {0, 239.0 / 240}};
  EXPECT_THAT(Texts(FaultsOf(world)),
              ElementsAre("pushes[0].body is 2; expected an index into the bodies",
                          "pushes[1].time is 0.0020833333333333333; "
                          "expected a multiple of dt = 0.004166666666666667",
                          "pushes[2].time is 1; expected a time before the end at 1 s"));
}

TEST(FaultsOfWorld, IncludeAStepOfZero) {
  World world = TwoBalls();
  world.dt = 0;
  world.steps = 0;
  // The time of a push is not checked against an invalid step.
  world.pushes = {{0, 0.3}};
  EXPECT_THAT(Texts(FaultsOf(world)),
              ElementsAre("world.dt is 0; expected a finite number > 0",
                          "world.steps is 0; expected a count from 1 to 1000000"));
}

TEST(FaultsOfWorld, IncludeAWorldWithoutMovingParts) {
  World world = TwoBalls();
  world.bodies[0].mass = 0;
  world.bodies[1].mass = 0;
  EXPECT_THAT(Texts(FaultsOf(world)),
              ElementsAre("world has nothing that moves; "
                          "expected a body, a particle or a cloth that can move"));
}

TEST(FaultsOfWorld, IncludeMagnitudesThatEnginesCannotHold) {
  World world = TwoBalls();
  world.bodies[0].mass = 1e-300;
  world.bodies[1].placed.shape = Sphere{1e-40};
  world.bodies[1].v_WB = {0, -1e10, 0};
  EXPECT_THAT(Texts(FaultsOf(world)),
              ElementsAre("bodies.ball.mass is 1e-300; expected a value from 1e-09 to "
                          "1e+09 kg",
                          "bodies.other.radius is 1e-40; expected a value from 1e-09 to "
                          "1e+09 m",
                          "bodies.other.velocity[1] is -10000000000; expected at most "
                          "1e+09 m/s"));
}

TEST(FaultsOfWorld, IncludeAnInertiaAForceAndAnImpulseThatEnginesCannotHold) {
  World world = TwoBalls();
  world.bodies[0].inertia = Eigen::Vector3d(1e-30, 1e-30, 1e-30);
  world.bodies[0].force_W = {0, 1e10, 0};
  world.pushes = {{1, 0, {0, 0, 0}, {1e12, 0, 0}}};
  const std::vector<std::string> texts = Texts(FaultsOf(world));
  ASSERT_EQ(texts.size(), 5U);
  EXPECT_EQ(
      texts[0],
      "bodies.ball.inertia[0] is 1e-30; expected a value from 1e-27 to 1e+27 kg m²");
  EXPECT_EQ(texts[3],
            "bodies.ball.force is 1e+10 N on 1 kg; expected at most 1e+09 m/s² times the "
            "mass");
  EXPECT_EQ(
      texts[4],
      "pushes[0].impulse is 1e+12 N s on 1 kg; expected at most 1e+09 m/s times the "
      "mass");
}

TEST(FaultsOfWorld, AllowMagnitudesAtTheEndsOfTheirRanges) {
  World world = TwoBalls();
  world.bodies[0].mass = 1e-9;
  world.bodies[1].mass = 1e9;
  world.bodies[0].placed.shape = Sphere{1e-9};
  world.bodies[1].v_WB = {0, -1e9, 0};
  world.bodies[1].inertia = Eigen::Vector3d(1e27, 1e27, 1e27);
  EXPECT_THAT(Texts(FaultsOf(world)), IsEmpty());
}

// A motion beyond 1e12 m counts as diverged, which would be the engine's fault.
TEST(FaultsOfWorld, IncludeAMotionThatLeavesTheRangeByItself) {
  World world = TwoBalls();
  world.dt = 1;
  world.steps = 1001;
  world.gravity_W.setZero();
  world.bodies[0].v_WB = {1e9, 0, 0};
  EXPECT_THAT(Texts(FaultsOf(world)),
              ElementsAre("bodies.ball.velocity and the acceleration of 0 m/s² may take "
                          "it to 1e+12 m in 1e+03 s; expected a motion within 1e+12 m "
                          "and 1e+12 m/s"));
  world.steps = 999;
  EXPECT_THAT(Texts(FaultsOf(world)), IsEmpty());
}

TEST(FaultsOfWorld, IncludeAWorldThatTakesMinutes) {
  World world = TwoBalls();
  world.steps = 1'000'000;
  EXPECT_THAT(Texts(FaultsOf(world)), IsEmpty());
  for (int i = 0; i < 5; ++i) {
    world.bodies.push_back(world.bodies[0]);
    world.bodies.back().name = "more" + std::to_string(i);
  }
  EXPECT_THAT(
      Texts(FaultsOf(world)),
      ElementsAre(
          "world.steps is 1000000 for 7 moving bodies, particles and "
          "nodes; expected at most 6e+06 steps × moving bodies, particles and nodes, "
          "about a minute of the slowest engine"));
}

TEST(FaultsOfWorld, AllowTheRoundedMomentsOfAFlatBody) {
  World world = TwoBalls();
  world.bodies[0].inertia = Eigen::Vector3d(0.1, 0.2, 0.1 + 0.2);
  EXPECT_THAT(Texts(FaultsOf(world)), IsEmpty());
  world.bodies[0].inertia = Eigen::Vector3d(0.1, 0.2, 0.301);
  EXPECT_EQ(FaultsOf(world).size(), 1U);
}

TEST(FaultsOfWorldScenario, IncludeClaimsAboutUnknownNames) {
  WorldScenario scenario;
  scenario.id = "world/a";
  scenario.title = "b";
  scenario.world = TwoBalls();
  scenario.claims = {{"ballistic", {"ball", "bal"}, {{"E", 1}}, ""}, {"", {}, {}, ""}};
  scenario.horizon = -1;
  EXPECT_THAT(
      Texts(FaultsOf(scenario)),
      ElementsAre("source is empty; expected a sentence",
                  "horizon is -1; expected a finite number >= 0",
                  "claims[0].numbers has a \"E\"; expected names of a-z, 0-9 and _",
                  "claims[0].about[1] is \"bal\", which the world does not have; "
                  "expected the name of a body, a particle or a cloth",
                  "claims[1].law is \"\"; expected a name of a-z, 0-9 and _"));
}

}  // namespace
}  // namespace touchstone
