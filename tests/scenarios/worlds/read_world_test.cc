#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scenarios/scenario_file.h"

namespace touchstone {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr std::string_view kGood = R"(id = "world/free/two"
title = "A ball and a bob above a floor"
source = "Made up."
horizon = 0.5

[world]
gravity = [0, -9.81, 0]
dt = 0.001
duration = 0.5
sample_every = 10

[bodies.floor]
shape = "half_space"
mass = 0

[bodies.ball]
shape = "sphere"
radius = 0.5
position = [0, 2, 0]
mass = 3
inertia = [0.1, 0.2, 0.3]
velocity = [1, 0, 0]
spin = [0, 0, 7]
restitution = 1
friction = 0
force = [0, 1, 0]
collides = false

[particles.bob]
position = [1, 2, 0]
velocity = [0, 0, 4]
mass = 0.5
damping = 0.25
bounce = 0.125

[[springs]]
A = "bob"
B = {on = "ball", point = [0.5, 0, 0]}
stiffness = 100
damping = 2
rest_length = 0.75

[[joints]]
A = [0, 5, 0]
B = "ball"

[cloths.net]
n = 5
spacing = 0.1
centre = [0, 9, 0]
node_mass = 0.01
damping = 0.2
bounce = 0.3
structural = {stiffness = 10, damping = 1}
shear = {stiffness = 20}
bend = {stiffness = 30}
pinned = [[0, 0], [0, 4]]

[[pushes]]
body = "ball"
time = 0.25
point = [0, 0.5, 0]
impulse = [1, 0, 0]

[[claims]]
law = "pushed"
about = ["ball", "net"]
numbers = {speed = 1.5}
because = "J = m v."

[ensemble]
members = 3
jitter = 1e-6
seed = 7

[[indicts]]
oracle = "ode"
measures = ["rest_motion"]
anomaly = "It sinks."
reproduces = false
)";

/** Returns `text` with `old_part`, which must occur once, replaced by `new_part`. */
std::string With(std::string_view old_part, std::string_view new_part,
                 std::string_view text = kGood) {
  std::string changed(text);
  const std::size_t at = changed.find(old_part);
  EXPECT_NE(at, std::string::npos) << old_part;
  EXPECT_EQ(changed.find(old_part, at + 1), std::string::npos) << old_part;
  return changed.replace(at, old_part.size(), new_part);
}

std::vector<std::string> ErrorsOf(std::string_view text) {
  const ReadResult result = ReadScenario(text, "f.toml");
  EXPECT_FALSE(result.scenario);
  EXPECT_EQ(result.world.has_value(), result.diagnostics.empty());
  std::vector<std::string> errors;
  for (const Diagnostic& diagnostic : result.diagnostics) {
    errors.push_back(ToString(diagnostic));
  }
  return errors;
}

TEST(ReadWorld, ReturnsTheContentsOfTheFile) {
  const ReadResult result = ReadScenario(kGood, "f.toml");
  ASSERT_TRUE(result.world) << ToString(result.diagnostics.at(0));
  const WorldScenario& s = *result.world;
  EXPECT_EQ(s.id, "world/free/two");
  EXPECT_EQ(s.title, "A ball and a bob above a floor");
  EXPECT_EQ(s.source, "Made up.");
  EXPECT_EQ(s.horizon, 0.5);
  EXPECT_EQ(s.world.gravity_W, Eigen::Vector3d(0, -9.81, 0));
  EXPECT_EQ(s.world.dt, 0.001);
  EXPECT_EQ(s.world.steps, 500);
  EXPECT_EQ(s.world.sample_every, 10);
  ASSERT_EQ(s.claims.size(), 1U);
  EXPECT_EQ(s.claims[0].law, "pushed");
  EXPECT_THAT(s.claims[0].about, ElementsAre("ball", "net"));
  EXPECT_THAT(s.claims[0].numbers, ElementsAre(std::pair("speed", 1.5)));
  EXPECT_EQ(s.claims[0].because, "J = m v.");
  ASSERT_TRUE(s.ensemble);
  EXPECT_EQ(s.ensemble->members, 3);
  EXPECT_EQ(s.ensemble->jitter, 1e-6);
  EXPECT_EQ(s.ensemble->seed, 7U);
  ASSERT_EQ(s.indicts.size(), 1U);
  EXPECT_EQ(s.indicts[0].oracle, "ode");
}

TEST(ReadWorld, ReturnsTheBodies) {
  const ReadResult result = ReadScenario(kGood, "f.toml");
  ASSERT_TRUE(result.world) << ToString(result.diagnostics.at(0));
  const std::vector<RigidBody>& bodies = result.world->world.bodies;
  ASSERT_EQ(bodies.size(), 2U);
  EXPECT_EQ(bodies[0].name, "floor");
  EXPECT_EQ(bodies[0].mass, 0);
  EXPECT_EQ(KindOf(bodies[0].placed.shape), ShapeKind::kHalfSpace);
  const RigidBody& ball = bodies[1];
  EXPECT_EQ(ball.name, "ball");
  EXPECT_EQ(std::get<Sphere>(ball.placed.shape).radius, 0.5);
  EXPECT_EQ(ball.placed.X_WB.p_WB, Eigen::Vector3d(0, 2, 0));
  EXPECT_EQ(ball.mass, 3);
  ASSERT_TRUE(ball.inertia);
  EXPECT_EQ(*ball.inertia, Eigen::Vector3d(0.1, 0.2, 0.3));
  EXPECT_EQ(ball.v_WB, Eigen::Vector3d(1, 0, 0));
  EXPECT_EQ(ball.w_WB, Eigen::Vector3d(0, 0, 7));
  EXPECT_EQ(ball.restitution, 1);
  EXPECT_EQ(ball.friction, 0);
  EXPECT_EQ(ball.force_W, Eigen::Vector3d(0, 1, 0));
  EXPECT_FALSE(ball.collides);
}

TEST(ReadWorld, ReturnsParticlesSpringsJointsClothsAndPushes) {
  const ReadResult result = ReadScenario(kGood, "f.toml");
  ASSERT_TRUE(result.world) << ToString(result.diagnostics.at(0));
  const World& world = result.world->world;
  ASSERT_EQ(world.particles.size(), 1U);
  EXPECT_EQ(world.particles[0].name, "bob");
  EXPECT_EQ(world.particles[0].p_W, Eigen::Vector3d(1, 2, 0));
  EXPECT_EQ(world.particles[0].v_W, Eigen::Vector3d(0, 0, 4));
  EXPECT_EQ(world.particles[0].mass, 0.5);
  EXPECT_EQ(world.particles[0].damping, 0.25);
  EXPECT_EQ(world.particles[0].bounce, 0.125);
  ASSERT_EQ(world.springs.size(), 1U);
  EXPECT_EQ(world.springs[0].A.on, AnchorKind::kParticle);
  EXPECT_EQ(world.springs[0].A.index, 0);
  EXPECT_EQ(world.springs[0].B.on, AnchorKind::kBody);
  EXPECT_EQ(world.springs[0].B.index, 1);
  EXPECT_EQ(world.springs[0].B.point, Eigen::Vector3d(0.5, 0, 0));
  EXPECT_EQ(world.springs[0].stiffness, 100);
  EXPECT_EQ(world.springs[0].damping, 2);
  EXPECT_EQ(world.springs[0].rest_length, 0.75);
  ASSERT_EQ(world.joints.size(), 1U);
  EXPECT_EQ(world.joints[0].A.on, AnchorKind::kWorld);
  EXPECT_EQ(world.joints[0].A.point, Eigen::Vector3d(0, 5, 0));
  EXPECT_EQ(world.joints[0].B.index, 1);
  ASSERT_EQ(world.cloths.size(), 1U);
  const Cloth& net = world.cloths[0];
  EXPECT_EQ(net.name, "net");
  EXPECT_EQ(net.n, 5);
  EXPECT_EQ(net.spacing, 0.1);
  EXPECT_EQ(net.centre, Eigen::Vector3d(0, 9, 0));
  EXPECT_EQ(net.node_mass, 0.01);
  EXPECT_EQ(net.damping, 0.2);
  EXPECT_EQ(net.bounce, 0.3);
  EXPECT_EQ(net.structural.stiffness, 10);
  EXPECT_EQ(net.structural.damping, 1);
  EXPECT_EQ(net.shear.stiffness, 20);
  EXPECT_EQ(net.bend.stiffness, 30);
  EXPECT_THAT(net.pinned, ElementsAre(std::pair(0, 0), std::pair(0, 4)));
  ASSERT_EQ(world.pushes.size(), 1U);
  EXPECT_EQ(world.pushes[0].body, 1);
  EXPECT_EQ(world.pushes[0].time, 0.25);
  EXPECT_EQ(world.pushes[0].p_BoP, Eigen::Vector3d(0, 0.5, 0));
  EXPECT_EQ(world.pushes[0].J_W, Eigen::Vector3d(1, 0, 0));
}

TEST(ReadWorld, KeepsTheOrderOfTheFile) {
  const ReadResult result = ReadScenario(
      "id = \"a\"\ntitle = \"b\"\nsource = \"c\"\nworld = {dt = 1, steps = 2}\n"
      "particles.z = {position = [0, 0, 0]}\nparticles.a = {position = [1, 0, 0]}\n",
      "f.toml");
  ASSERT_TRUE(result.world) << ToString(result.diagnostics.at(0));
  EXPECT_EQ(result.world->world.particles.at(0).name, "z");
  EXPECT_EQ(result.world->world.particles.at(1).name, "a");
}

TEST(ReadWorld, UsesTheInitialDistanceForAMissingLength) {
  // The ball is at (0, 2, 0), the joint's world anchor at (0, 5, 0). The bob is 0.5 from
  // the side of the ball.
  const ReadResult result = ReadScenario(With("rest_length = 0.75\n", ""), "f.toml");
  ASSERT_TRUE(result.world) << ToString(result.diagnostics.at(0));
  EXPECT_EQ(result.world->world.joints[0].length, 3);
  EXPECT_EQ(result.world->world.springs[0].rest_length, 0.5);
}

TEST(ReadWorld, RefusesAKeyOfTheOtherKindOfFile) {
  EXPECT_THAT(
      ErrorsOf(With("horizon = 0.5", "contact = {A = \"ball\", B = \"floor\"}")),
      ElementsAre("f.toml:4:1: \"contact\" is not allowed in a file with [world]; "
                  "expected one question per file"));
}

TEST(ReadWorld, SuggestsTheNearestKeyOfAMovingBody) {
  EXPECT_THAT(ErrorsOf(With("spin = ", "spinn = ")),
              ElementsAre("f.toml:23:1: unknown key \"spinn\" in bodies.ball; "
                          "expected \"spin\""));
}

TEST(ReadWorld, RefusesInvalidNumbers) {
  EXPECT_THAT(ErrorsOf(With("mass = 3", "mass = -3")),
              ElementsAre("f.toml:20:8: bodies.ball.mass is -3; "
                          "expected a finite number >= 0"));
  EXPECT_THAT(ErrorsOf(With("[0, 0, 7]", "[0, nan, inf]")),
              ElementsAre("f.toml:23:12: bodies.ball.spin[1] is nan; "
                          "expected a finite number",
                          "f.toml:23:17: bodies.ball.spin[2] is inf; "
                          "expected a finite number"));
  EXPECT_THAT(ErrorsOf(With("restitution = 1", "restitution = 1.5")),
              ElementsAre("f.toml:24:15: bodies.ball.restitution is 1.5; "
                          "expected a number from 0 to 1"));
  EXPECT_THAT(ErrorsOf(With("position = [0, 2, 0]", "quaternion = [1, 0, 0, 1]")),
              ElementsAre("f.toml:19:14: bodies.ball.quaternion has norm "
                          "1.4142135623730951; expected a unit quaternion w, x, y, z: "
                          "of norm 1 to 1e-06 in a file, to 1e-12 in a program"));
  EXPECT_THAT(ErrorsOf(With("members = 3", "members = 1")),
              ElementsAre("f.toml:72:11: ensemble.members is 1; "
                          "expected 2 worlds or more"));
  EXPECT_THAT(ErrorsOf(With("horizon = 0.5", "horizon = -0.5")),
              ElementsAre("f.toml:4:11: horizon is -0.5; expected a finite number >= 0"));
}

TEST(ReadWorld, RefusesAnInertiaThatNoSolidCanHave) {
  EXPECT_THAT(ErrorsOf(With("[0.1, 0.2, 0.3]", "[0.1, 0.2, 0.4]")),
              ElementsAre("f.toml:21:11: bodies.ball.inertia has a moment that exceeds "
                          "the sum of the others; expected moments that a solid can "
                          "have"));
}

TEST(ReadWorld, RefusesAMovingHalfSpace) {
  EXPECT_THAT(ErrorsOf(With("mass = 0\n", "mass = 1\n")),
              ElementsAre("f.toml:13:9: bodies.floor.shape is \"half_space\", which "
                          "moves; expected mass = 0"));
}

TEST(ReadWorld, RefusesMotionOfAStaticBody) {
  EXPECT_THAT(ErrorsOf(With("mass = 0\n", "mass = 0\nspin = [0, 0, 1]\n")),
              ElementsAre("f.toml:15:8: bodies.floor.spin is not 0, but the mass is; "
                          "expected zero, since mass 0 means that it never moves"));
}

TEST(ReadWorld, RefusesAnInconsistentClock) {
  EXPECT_THAT(
      ErrorsOf(With("duration = 0.5", "duration = 0.5005", With("time = 0.25\n", ""))),
      ElementsAre("f.toml:9:12: world.duration is 0.5005; "
                  "expected a multiple of dt = 0.001"));
  EXPECT_THAT(ErrorsOf(With("sample_every = 10", "sample_every = 7")),
              ElementsAre("f.toml:10:16: world.sample_every is 7; "
                          "expected a divisor of the 500 steps"));
  EXPECT_THAT(ErrorsOf(With("duration = 0.5", "duration = 0.5\nsteps = 500")),
              ElementsAre("f.toml:9:12: world has steps and a duration; "
                          "expected one of the two"));
  EXPECT_THAT(ErrorsOf(With("duration = 0.5\n", "")),
              ElementsAre("f.toml:6:1: world.steps is missing; "
                          "expected a count, 1 or more, or a duration"));
}

TEST(ReadWorld, RefusesAnchorsOnUnknownNames) {
  EXPECT_THAT(ErrorsOf(With("A = \"bob\"", "A = \"bobb\"")),
              ElementsAre("f.toml:37:5: springs[0].A is \"bobb\", which is not a body or "
                          "particle; expected \"bob\""));
  EXPECT_THAT(
      ErrorsOf(With("on = \"ball\"", "on = \"net\"")),
      ElementsAre("f.toml:38:11: springs[0].B.on is \"net\", which is not a body or "
                  "particle; expected one of ball, bob, floor"));
}

TEST(ReadWorld, RefusesATieOfABodyToItself) {
  EXPECT_THAT(
      ErrorsOf(With("A = [0, 5, 0]", "A = {on = \"ball\", point = [0, 1, 0]}")),
      ElementsAre("f.toml:45:5: joints[0].B is on the same body or particle as A; "
                  "expected another body or particle, or the world"));
}

TEST(ReadWorld, RefusesATieBetweenStaticThings) {
  EXPECT_THAT(
      ErrorsOf(With("B = \"ball\"", "B = \"floor\"")),
      ElementsAre("f.toml:45:5: joints[0].B is on something that never moves, and so "
                  "is A; expected one end that can move"));
}

TEST(ReadWorld, RefusesATieWhoseEndsAreAtOnePoint) {
  EXPECT_THAT(ErrorsOf(With("A = [0, 5, 0]", "A = [0, 2, 0]")),
              ElementsAre("f.toml:45:5: joints[0].B is at the same point as A; "
                          "expected two ends at different points"));
}

TEST(ReadWorld, RefusesAnAnchorPointOnAParticle) {
  EXPECT_THAT(ErrorsOf(With("A = \"bob\"", "A = {on = \"bob\", point = [1, 0, 0]}")),
              ElementsAre("f.toml:37:26: springs[0].A.point is not 0; "
                          "expected zero, since a particle has no size"));
}

TEST(ReadWorld, RefusesAnInvalidCloth) {
  EXPECT_THAT(ErrorsOf(With("n = 5", "n = 2")),
              ElementsAre("f.toml:48:5: cloths.net.n is 2; expected 3 nodes or more"));
  EXPECT_THAT(ErrorsOf(With("[0, 4]]", "[0, 5]]")),
              ElementsAre("f.toml:57:19: cloths.net.pinned[1] is [0, 5]; "
                          "expected a row and a column from 0 to 4"));
  EXPECT_THAT(ErrorsOf(With("[0, 4]]", "[0, 0]]")),
              ElementsAre("f.toml:57:19: cloths.net.pinned[1] is [0, 0] again; "
                          "expected each node once"));
}

TEST(ReadWorld, RefusesAPushThatIsNotBetweenTwoSteps) {
  EXPECT_THAT(ErrorsOf(With("time = 0.25", "time = 0.2503")),
              ElementsAre("f.toml:61:8: pushes[0].time is 0.2503; "
                          "expected a multiple of dt = 0.001"));
  EXPECT_THAT(ErrorsOf(With("time = 0.25", "time = 0.5")),
              ElementsAre("f.toml:61:8: pushes[0].time is 0.5; "
                          "expected a time before the end at 0.5 s"));
}

TEST(ReadWorld, RefusesAPushOfAStaticBody) {
  EXPECT_THAT(ErrorsOf(With("body = \"ball\"", "body = \"floor\"")),
              ElementsAre("f.toml:60:8: pushes[0].body has mass 0; "
                          "expected a body that can move"));
  EXPECT_THAT(ErrorsOf(With("body = \"ball\"", "body = \"bob\"")),
              ElementsAre("f.toml:60:8: pushes[0].body is \"bob\", which is not a body; "
                          "expected one of ball, floor"));
}

TEST(ReadWorld, RefusesANameThatIsTaken) {
  EXPECT_THAT(ErrorsOf(With("[cloths.net]", "[cloths.bob]",
                            With("\"ball\", \"net\"", "\"ball\""))),
              ElementsAre("f.toml:47:9: cloths.bob has the name of particles.bob; "
                          "expected a unique name"));
}

TEST(ReadWorld, RefusesAClaimAboutAnUnknownName) {
  EXPECT_THAT(ErrorsOf(With("\"net\"]", "\"nett\"]")),
              ElementsAre("f.toml:67:18: claims[0].about[1] is \"nett\", which is not a "
                          "body, particle or cloth; expected \"net\""));
  EXPECT_THAT(ErrorsOf(With("speed = 1.5", "speed = nan")),
              ElementsAre("f.toml:68:20: claims[0].numbers.speed is nan; "
                          "expected a finite number"));
}

TEST(ReadWorld, RefusesAWorldWhereNothingMoves) {
  EXPECT_THAT(ErrorsOf("id = \"a\"\ntitle = \"b\"\nsource = \"c\"\n"
                       "world = {dt = 1, steps = 2}\n"),
              ElementsAre("f.toml:4:9: world has nothing that moves; "
                          "expected a body, a particle or a cloth that can move"));
}

TEST(ReadWorld, TreatsAFileWithTablesOfAWorldAsAWorld) {
  EXPECT_THAT(ErrorsOf("id = \"a\"\ntitle = \"b\"\nsource = \"c\"\n"
                       "particles.a = {position = [0, 0, 0]}\n"),
              ElementsAre("f.toml:1:1: world is missing; expected a table"));
}

TEST(ReadWorld, ReportsNoConsequencesOfAnotherError) {
  // Without dt no time can be checked against the step; without the bob the spring has no
  // length.
  EXPECT_THAT(ErrorsOf(With("dt = 0.001", "dt = \"fast\"",
                            With("particles.bob", "particles.blob"))),
              ElementsAre("f.toml:8:6: world.dt is a string; "
                          "expected a finite number > 0",
                          "f.toml:37:5: springs[0].A is \"bob\", which is not a body or "
                          "particle; expected \"blob\""));
}

TEST(ReadWorld, AllowsACountOfStepsInsteadOfADuration) {
  EXPECT_THAT(ErrorsOf(With("duration = 0.5", "steps = 500")), IsEmpty());
}

}  // namespace
}  // namespace touchstone
