// An oracle that is served by the protocol is the same oracle.

#include <algorithm>
#include <cctype>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "oracles/isolation/answer_wire.h"
#include "oracles/oracle_registry.h"
#include "oracles/protocol/external_oracle.h"
#include "scenarios/generators/generate.h"
#include "scenarios/generators/worlds/world_family.h"
#include "tests/conformance/touchstone_program.h"

namespace touchstone {
namespace {

const OracleRegistry& Registry() {
  static const OracleRegistry registry = OracleRegistry::BuiltIn();
  return registry;
}

std::vector<std::string> NamesWhere(
    const std::function<bool(const OracleInfo&)>& wanted) {
  std::vector<std::string> names;
  for (const Oracle* oracle : Registry().All()) {
    if (wanted(oracle->info())) names.push_back(oracle->info().name);
  }
  return names;
}

std::string TestName(const testing::TestParamInfo<std::string>& instance) {
  std::string name = instance.param;
  std::ranges::replace_if(
      name, [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return name;
}

// Everything in an answer but the time that it took.
template <typename Answer>
std::string BytesOf(Answer answer) {
  answer.seconds = 0;
  return ToWire(answer);
}

class ServedOracle : public testing::TestWithParam<std::string> {
 protected:
  const Oracle& oracle() const { return *Registry().Find(GetParam()); }
  const Oracle& served() const { return *served_; }

 private:
  std::unique_ptr<Oracle> served_ =
      MakeExternalOracle("", {TouchstoneProgram() + " serve " + GetParam()});
};

TEST_P(ServedOracle, DescribesItselfAlike) {
  const OracleInfo& one = oracle().info();
  const OracleInfo& other = served().info();
  EXPECT_EQ(other.name, one.name);
  EXPECT_EQ(other.library, one.library);
  EXPECT_EQ(other.version, one.version);
  EXPECT_EQ(other.unit_roundoff, one.unit_roundoff);
  EXPECT_EQ(other.subtracts_first, one.subtracts_first);
  EXPECT_EQ(other.slop, one.slop);
  EXPECT_EQ(other.sleep_speed, one.sleep_speed);
  EXPECT_EQ(other.documented_rotation_error, one.documented_rotation_error);
  EXPECT_EQ(other.stated_order, one.stated_order);
  EXPECT_EQ(other.softness, one.softness);
  EXPECT_EQ(other.parameters.size(), one.parameters.size());
  EXPECT_EQ(other.simulates, one.simulates);
  for (int i = 0; i < kShapeKinds; ++i) {
    for (int j = 0; j < kShapeKinds; ++j) {
      const auto a = static_cast<ShapeKind>(i);
      const auto b = static_cast<ShapeKind>(j);
      const Capability& stated = one.For(a, b);
      const Capability& received = other.For(a, b);
      EXPECT_EQ(received.supported, stated.supported);
      EXPECT_EQ(received.family, stated.family);
      EXPECT_EQ(received.depth, stated.depth);
      EXPECT_EQ(received.distance, stated.distance);
      EXPECT_EQ(received.normal, stated.normal);
      EXPECT_EQ(received.manifold, stated.manifold);
      EXPECT_EQ(received.witnesses, stated.witnesses);
      EXPECT_EQ(received.penetrating_witnesses, stated.penetrating_witnesses);
      EXPECT_EQ(received.documented_error, stated.documented_error);
      EXPECT_EQ(received.documented_relative_error, stated.documented_relative_error);
      EXPECT_EQ(received.documented_by, stated.documented_by);
    }
  }
  for (int i = 0; i < kWorldFeatures; ++i) {
    const auto feature = static_cast<WorldFeature>(i);
    EXPECT_EQ(other.For(feature).supported, one.For(feature).supported);
    if (one.simulates) {
      EXPECT_EQ(other.For(feature).reason, one.For(feature).reason);
    }
  }
}

TEST_P(ServedOracle, AnswersContactQuestionsBitForBitAlike) {
  std::vector<ContactQuery> queries;
  for (int i = 0; i < kShapeKinds; ++i) {
    for (int j = 0; j < kShapeKinds; ++j) {
      const auto A = static_cast<ShapeKind>(i);
      const auto B = static_cast<ShapeKind>(j);
      if (!oracle().info().For(A, B).supported) continue;
      for (std::uint64_t index = 0; index < 4; ++index)
        queries.push_back(Generate(Family::kRandom, A, B, 5, index));
    }
  }
  std::vector<ContactAnswer> answers(queries.size());
  std::vector<ContactAnswer> received(queries.size());
  oracle().Answer(queries, answers);
  served().Answer(queries, received);
  for (std::size_t i = 0; i < queries.size(); ++i)
    EXPECT_EQ(BytesOf(received[i]), BytesOf(answers[i])) << i << received[i].reason;
}

class ServedSimulator : public ServedOracle {};

TEST_P(ServedSimulator, SimulatesWorldsBitForBitAlike) {
  int simulated = 0;
  for (const WorldFamily family : AllWorldFamilies()) {
    const World world = GenerateWorld(family, 5, 0).world;
    const Trajectory trajectory = oracle().Simulate(world);
    const Trajectory received = served().Simulate(world);
    EXPECT_EQ(received.status, trajectory.status) << received.reason;
    EXPECT_EQ(received.reason, trajectory.reason);
    if (trajectory.status != AnswerStatus::kAnswered) continue;
    ++simulated;
    EXPECT_EQ(BytesOf(received), BytesOf(trajectory)) << NameOf(family);
  }
  EXPECT_GT(simulated, 0);
}

class ServedOracleWithSetups : public ServedOracle {};

TEST_P(ServedOracleWithSetups, TakesTheSetupOfTheOracle) {
  const World world = GenerateWorld(WorldFamily::kDrops, 5, 1).world;
  WorldSetup setup;
  setup.as_shipped = true;
  const Trajectory trajectory = oracle().SetUp(setup)->Simulate(world);
  const Trajectory received = served().SetUp(setup)->Simulate(world);
  EXPECT_EQ(trajectory.status, AnswerStatus::kAnswered) << trajectory.reason;
  EXPECT_EQ(BytesOf(received), BytesOf(trajectory));
}

INSTANTIATE_TEST_SUITE_P(
    , ServedOracle, testing::ValuesIn(NamesWhere([](const OracleInfo&) { return true; })),
    TestName);

INSTANTIATE_TEST_SUITE_P(, ServedSimulator,
                         testing::ValuesIn(NamesWhere([](const OracleInfo& of) {
                           return of.simulates;
                         })),
                         TestName);

INSTANTIATE_TEST_SUITE_P(, ServedOracleWithSetups,
                         testing::ValuesIn(NamesWhere([](const OracleInfo& of) {
                           return of.HasSetups();
                         })),
                         TestName);

}  // namespace
}  // namespace touchstone
