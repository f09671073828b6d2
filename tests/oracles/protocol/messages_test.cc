// What is sent is what is received, bit for bit, in both forms.

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "oracles/isolation/answer_wire.h"
#include "oracles/protocol/answer_message.h"
#include "oracles/protocol/hello_message.h"
#include "oracles/protocol/query_message.h"
#include "oracles/protocol/trajectory_message.h"
#include "oracles/protocol/world_message.h"
#include "oracles/simulation.h"
#include "scenarios/generators/generate.h"
#include "scenarios/generators/worlds/world_family.h"
#include "tests/scenarios/same_bits.h"

namespace touchstone {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

// Sends a message and receives it.
Message Sent(const Message& message) {
  const std::string bytes = BytesOf(message);
  const std::size_t end = bytes.find('\n');
  Message received{LineFrom(std::string_view(bytes).substr(0, end)), {}};
  const std::size_t size = FrameSizeOf(received.line, bytes.size());
  EXPECT_EQ(bytes.size(), end + 1 + size);
  received.frame = FrameFrom(std::string_view(bytes).substr(end + 1));
  return received;
}

std::vector<ContactQuery> QuestionsOfAllPairs() {
  std::vector<ContactQuery> queries;
  for (int a = 0; a < kShapeKinds; ++a) {
    for (int b = 0; b < kShapeKinds; ++b) {
      const auto A = static_cast<ShapeKind>(a);
      const auto B = static_cast<ShapeKind>(b);
      if (A == ShapeKind::kHalfSpace && B == A) continue;
      for (std::uint64_t i = 0; i < 3; ++i)
        queries.push_back(Generate(Family::kRandom, A, B, 1, i));
    }
  }
  return queries;
}

class Forms : public testing::TestWithParam<bool> {};

TEST_P(Forms, OfQuestionsKeepEveryBit) {
  const std::vector<ContactQuery> queries = QuestionsOfAllPairs();
  Message message;
  PutQueries(queries, GetParam(), message);
  const std::vector<ContactQuery> received = QueriesFrom(Sent(message));
  ASSERT_EQ(received.size(), queries.size());
  for (std::size_t i = 0; i < queries.size(); ++i)
    EXPECT_TRUE(SameBits(received[i], queries[i])) << i;
}

TEST_P(Forms, OfQuestionsKeepAMatrixThatIsNoQuaternion) {
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  R(0, 1) = 1e-9;
  const ContactQuery query{
      {Sphere{1}, Pose::FromMatrix({1, -0.0, 1e-100}, R)},
      {Box{{1, 2, 3}}, Pose::FromQuaternion({0, 0, 0}, {1, 0, 0, 0})}};
  Message message;
  PutQueries(std::span(&query, 1), GetParam(), message);
  EXPECT_TRUE(SameBits(QueriesFrom(Sent(message)).front(), query));
}

std::vector<ContactAnswer> AnswersOfAllKinds() {
  std::vector<ContactAnswer> answers(5);
  answers[0].status = AnswerStatus::kAnswered;
  answers[1].status = AnswerStatus::kAnswered;
  answers[1].touching = true;
  answers[1].n_AB_W = {0.1, -0.0, kNaN};
  answers[1].separation = -std::numeric_limits<double>::infinity();
  answers[1].points = {{{1, 2, 3}, 1.0 / 3, {}}, {{4, 5, 6}, -0.1, {{0, 0, 1}}}};
  answers[2].status = AnswerStatus::kAnswered;
  answers[2].separation = 5e-324;
  answers[2].witnesses = WitnessPoints{{1, 2, 3}, {4, 5, 6}};
  answers[3].reason = "no cones";
  answers[4].status = AnswerStatus::kCrashed;
  answers[4].reason = "threw \"x\"\n\xff";
  return answers;
}

TEST_P(Forms, OfAnswersKeepEveryBit) {
  std::vector<ContactAnswer> answers = AnswersOfAllKinds();
  Message message;
  PutAnswers(answers, GetParam(), message);
  const std::vector<ContactAnswer> received = AnswersFrom(Sent(message), answers.size());
  ASSERT_EQ(received.size(), answers.size());
  answers[4].reason = "threw \"x\"\n\xEF\xBF\xBD";  // What is not UTF-8 is replaced.
  for (std::size_t i = 0; i < answers.size(); ++i)
    EXPECT_EQ(ToWire(received[i]), ToWire(answers[i])) << i;
}

INSTANTIATE_TEST_SUITE_P(, Forms, testing::Bool(), [](const auto& instance) {
  return instance.param ? "Frame" : "Line";
});

// Every orientation is sent as a matrix and as a quaternion, so that one that was stated
// as a matrix may arrive as the quaternion from which exactly that matrix follows.
void StateQuaternions(World& world) {
  for (RigidBody& body : world.bodies) {
    Pose& pose = body.placed.X_WB;
    if (pose.q_WB) continue;
    const Pose turned =
        Pose::FromQuaternion(pose.p_WB, Eigen::Quaterniond(pose.R_WB).normalized());
    if (turned.R_WB == pose.R_WB) pose = turned;
  }
}

TEST(WorldMessage, KeepsEveryBitOfAllFamilies) {
  for (const WorldFamily family : AllWorldFamilies()) {
    for (std::uint64_t i = 0; i < 5; ++i) {
      WorldScenario scenario = GenerateWorld(family, 1, i);
      StateQuaternions(scenario.world);
      const Json json = Json::parse(OneLine(ToJson(scenario.world)));
      WorldScenario received = scenario;
      received.world = WorldFrom(Received(json, "world"));
      // The moments of a uniform solid are sent, and not a stated inertia again.
      EXPECT_TRUE(SameBits(received, scenario)) << scenario.id;
    }
  }
}

TEST(WorldMessage, RefusesAWorldThatIsNone) {
  WorldScenario scenario = GenerateWorld(WorldFamily::kDrops, 1, 0);
  scenario.world.dt = -1;
  const Json json = ToJson(scenario.world);
  EXPECT_THAT([&] { WorldFrom(Received(json, "world")); },
              ThrowsMessage<ProtocolError>(HasSubstr("dt")));
}

RigidBody Ball() {
  RigidBody ball;
  ball.name = "ball";
  ball.placed.shape = Sphere{1};
  return ball;
}

TEST(WorldMessage, RefusesAnAnchorOnNothing) {
  World world;
  world.bodies.push_back(Ball());
  world.joints.push_back({{}, {AnchorKind::kBody, 7}, 1});
  const Json json = ToJson(world);
  EXPECT_THAT([&] { WorldFrom(Received(json, "world")); },
              ThrowsMessage<ProtocolError>(HasSubstr(
                  "world.joints[0].B.index: 7; expected a whole number from 0 to 0")));
}

World BallWorld() {
  World world;
  world.bodies.push_back(Ball());
  world.particles.push_back({"speck"});
  world.dt = 0.1;
  world.steps = 4;
  world.sample_every = 2;
  return world;
}

Trajectory BallMotion(const World& world) {
  Trajectory trajectory;
  trajectory.status = AnswerStatus::kAnswered;
  for (int step = 0; step <= world.steps; step += world.sample_every) {
    const double t = step * world.dt;
    trajectory.times.push_back(t);
    WorldState state;
    state.bodies.push_back({{t, -0.0, 1.0 / 3},
                            Eigen::Quaterniond(0.5, 0.5, -0.5, 0.5),
                            {1, 2, 3},
                            {4, 5, 6}});
    state.particles.push_back({{t, t, t}, {1, 1, 1}});
    trajectory.samples.push_back(state);
  }
  return trajectory;
}

class MotionForms : public testing::TestWithParam<bool> {};

TEST_P(MotionForms, KeepEveryBit) {
  const World world = BallWorld();
  for (const bool has_impulses : {false, true}) {
    Trajectory trajectory = BallMotion(world);
    trajectory.gives_impulses = has_impulses;
    if (has_impulses) {
      trajectory.impulses.push_back(
          {3, 0, 0, {1, 2, 3}, {0, 1, 0}, {0, 0.1, 0}, -0.2, {1, 0, 0}});
    }
    Message message;
    PutTrajectory(trajectory, GetParam(), message);
    EXPECT_EQ(ToWire(TrajectoryFrom(Sent(message), world)), ToWire(trajectory));
  }
}

TEST_P(MotionForms, EndBeforeTheFirstNumberThatIsNone) {
  const World world = BallWorld();
  Trajectory trajectory = BallMotion(world);
  trajectory.samples[1].bodies[0].v_WB.x() = kNaN;
  Message message;
  PutTrajectory(trajectory, GetParam(), message);
  const Trajectory received = TrajectoryFrom(Sent(message), world);
  EXPECT_EQ(received.diverged_at_step, 2);
  EXPECT_EQ(received.samples.size(), 1U);
}

TEST_P(MotionForms, WithTooFewSamplesAreRefused) {
  const World world = BallWorld();
  Trajectory trajectory = BallMotion(world);
  trajectory.samples.pop_back();
  trajectory.times.pop_back();
  Message message;
  PutTrajectory(trajectory, GetParam(), message);
  EXPECT_THAT([&] { TrajectoryFrom(Sent(message), world); },
              ThrowsMessage<ProtocolError>(HasSubstr("2 samples; expected 3")));
}

TEST_P(MotionForms, WithOtherTimesAreRefused) {
  const World world = BallWorld();
  Trajectory trajectory = BallMotion(world);
  trajectory.times[1] = 0.1;
  Message message;
  PutTrajectory(trajectory, GetParam(), message);
  EXPECT_THAT([&] { TrajectoryFrom(Sent(message), world); },
              ThrowsMessage<ProtocolError>(HasSubstr("times[1]: 0.1 s; expected 0.2 s")));
}

TEST_P(MotionForms, HaveTheirImpulsesInTheOrderOfSteps) {
  const World world = BallWorld();
  Trajectory trajectory = BallMotion(world);
  trajectory.gives_impulses = true;
  for (const int step : {3, 1, 2}) {
    ContactImpulse& impulse = trajectory.impulses.emplace_back();
    impulse.step = step;
    impulse.p_WC.setZero();
    impulse.n_AB_W.setZero();
    impulse.J_B_W.setZero();
  }
  Message message;
  PutTrajectory(trajectory, GetParam(), message);
  const Trajectory received = TrajectoryFrom(Sent(message), world);
  for (int i = 0; i < 3; ++i)
    EXPECT_EQ(received.impulses[static_cast<std::size_t>(i)].step, i + 1);
}

TEST_P(MotionForms, WithAnOrientationThatIsNoneAreRefused) {
  const World world = BallWorld();
  Trajectory trajectory = BallMotion(world);
  trajectory.samples[2].bodies[0].q_WB.coeffs().setZero();
  Message message;
  PutTrajectory(trajectory, GetParam(), message);
  EXPECT_THAT([&] { TrajectoryFrom(Sent(message), world); },
              ThrowsMessage<ProtocolError>(
                  HasSubstr("has the length 0; expected a unit quaternion")));
}

INSTANTIATE_TEST_SUITE_P(, MotionForms, testing::Bool(), [](const auto& instance) {
  return instance.param ? "Frame" : "Line";
});

Json HelloLine() {
  return Json::parse(R"({"protocol": 1, "name": "mine", "library": "Mine", "version": "2",
    "precision": "float", "contact": [{"shapes": ["sphere", "box"], "family": "sat",
    "gives": ["depth"], "documented_error": {"length": 1e-4, "share": 0, "by": "manual"}}],
    "world": {"supports": ["sphere"], "slop": {"length": 0.01, "by": "manual"}}})");
}

std::string RefusalOf(const Json& line) {
  try {
    HelloFrom({line, {}});
  } catch (const ProtocolError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(HelloMessage, DescribesAnOracle) {
  const OracleInfo info = HelloFrom({HelloLine(), {}}).info;
  EXPECT_EQ(info.unit_roundoff, 0x1p-24);
  EXPECT_TRUE(info.For(ShapeKind::kBox, ShapeKind::kSphere).depth);
  EXPECT_FALSE(info.For(ShapeKind::kBox, ShapeKind::kSphere).normal);
  EXPECT_EQ(info.For(ShapeKind::kBox, ShapeKind::kBox).documented_error, 1e-4);
  EXPECT_FALSE(info.For(ShapeKind::kBox, ShapeKind::kCone).supported);
  EXPECT_TRUE(info.simulates);
  EXPECT_TRUE(info.For(WorldFeature::kSphere).supported);
  EXPECT_EQ(info.For(WorldFeature::kBox).reason, "not among what mine simulates");
  EXPECT_EQ(info.slop, 0.01);
}

TEST(HelloMessage, GrantsNothingWithoutASource) {
  Json line = HelloLine();
  line["contact"][0]["documented_error"]["by"] = "";
  EXPECT_EQ(
      RefusalOf(line),
      "hello.contact[0].documented_error.by: \"\"; expected the source of the number");
  line = HelloLine();
  line["world"]["slop"].erase("by");
  EXPECT_EQ(RefusalOf(line), "hello.world.slop: expected \"by\" in it");
  line = HelloLine();
  line["contact"][0]["documented_error"]["length"] = "Infinity";
  EXPECT_THAT(RefusalOf(line), HasSubstr("expected a finite number >= 0"));
}

TEST(LineFrom, RefusesALineThatIsTooDeepOrHasTooManyKeys) {
  const std::string deep(200'000, '[');
  EXPECT_THAT([&] { LineFrom("{\"id\":" + deep); },
              ThrowsMessage<ProtocolError>(HasSubstr("too many nested lists")));
  std::string wide = "{\"a\":0";
  for (int i = 0; i < 200'000; ++i) wide += ",\"a\":0";
  EXPECT_THAT([&] { LineFrom(wide + "}"); },
              ThrowsMessage<ProtocolError>(HasSubstr("too many keys")));
  // Those in a string do not count.
  EXPECT_EQ(LineFrom("{\"a\":\"" + deep + "\\\"[\"}").size(), 1U);
}

TEST(HelloMessage, SaysWhatIsWrongWithIt) {
  Json line = HelloLine();
  line.erase("version");
  EXPECT_EQ(RefusalOf(line), "hello: expected \"version\" in it");
  line = HelloLine();
  line["contact"][0]["gives"] = {"dept"};
  EXPECT_THAT(RefusalOf(line),
              HasSubstr("hello.contact[0].gives[0]: \"dept\"; expected"));
  line = HelloLine();
  line["world"]["supports"] = {"spheres"};
  EXPECT_EQ(RefusalOf(line),
            "hello.world.supports[0]: \"spheres\"; expected the name of a feature of a "
            "world");
  line.erase("contact");
  line.erase("world");
  EXPECT_THAT(RefusalOf(line), HasSubstr("expected \"contact\" or \"world\" in it"));
}

}  // namespace
}  // namespace touchstone
