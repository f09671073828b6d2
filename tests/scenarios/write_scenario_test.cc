#include <string>

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include "scenarios/scenario_file.h"
#include "scenarios/validate_scenario.h"
#include "tests/scenarios/any_parts.h"
#include "tests/scenarios/same_bits.h"

namespace touchstone {
namespace {

Scenario AnyScenario() {
  Scenario scenario;
  scenario.id = *rc::gen::element<std::string>("a", "contact/box_box/edge_1");
  scenario.title = AnyText();
  scenario.source = AnyText();
  scenario.name_A = *rc::gen::element<std::string>("post", "Z-9", "3");
  scenario.name_B = *rc::gen::element<std::string>("ball", "_", "0x1");
  scenario.contact.A = {AnyShape(false), AnyPose()};
  const bool bounded = KindOf(scenario.contact.A.shape) == ShapeKind::kHalfSpace;
  scenario.contact.B = {AnyShape(bounded), AnyPose()};
  if (*rc::gen::arbitrary<bool>()) scenario.expect.separation = AnyNumber();
  if (*rc::gen::arbitrary<bool>()) {
    scenario.expect.touching = scenario.expect.separation
                                   ? *scenario.expect.separation <= 0
                                   : *rc::gen::arbitrary<bool>();
  }
  const int normals = *rc::gen::inRange(0, 3);
  for (int i = 0; i < normals; ++i) {
    scenario.expect.normals.push_back(
        Eigen::Vector3d(AnyComponent(), AnyComponent(), 0.1).normalized());
  }
  if (*rc::gen::arbitrary<bool>()) scenario.expect.contacts = *rc::gen::inRange(0, 9);
  if (*rc::gen::arbitrary<bool>()) scenario.tolerance = {AnyLength(), AnyText()};
  const int indictments = *rc::gen::inRange(0, 3);
  for (int i = 0; i < indictments; ++i) {
    scenario.indicts.push_back(
        {AnyText(), AnyMeasures(), AnyText(), *rc::gen::arbitrary<bool>()});
  }
  return scenario;
}

RC_GTEST_PROP(WriteScenario, IsReadBackBitForBit, ()) {
  const Scenario scenario = AnyScenario();
  RC_ASSERT(FaultsOf(scenario).empty());
  RC_CLASSIFY(scenario.contact.A.X_WB.q_WB.has_value(), "quaternion");
  RC_CLASSIFY(KindOf(scenario.contact.A.shape) == ShapeKind::kConvexHull, "hull");
  const std::string text = WriteScenario(scenario);
  RC_LOG() << text;
  const ReadResult read = ReadScenario(text, "f.toml");
  for (const Diagnostic& diagnostic : read.diagnostics) RC_LOG() << ToString(diagnostic);
  RC_ASSERT(read.scenario.has_value());
  RC_ASSERT(SameBits(*read.scenario, scenario));
  RC_ASSERT(WriteScenario(*read.scenario) == text);
}

TEST(WriteScenario, UsesTheShortestDecimalThatReadsBack) {
  Scenario scenario;
  scenario.id = "a";
  scenario.title = "b";
  scenario.source = "c";
  scenario.name_A = "post";
  scenario.name_B = "ball";
  scenario.contact.A = {HalfSpace{},
                        Pose::FromQuaternion({0.1, -0.0, 1e16}, {0.6, 0, 0.8, 0})};
  scenario.contact.B = {Sphere{1.0 / 3}, Pose{}};
  EXPECT_EQ(WriteScenario(scenario), R"(id = "a"
title = "b"
source = "c"

[bodies.post]
shape = "half_space"
position = [0.1, -0.0, 1e+16]
quaternion = [0.6, 0.0, 0.8, 0.0]

[bodies.ball]
shape = "sphere"
radius = 0.3333333333333333
position = [0.0, 0.0, 0.0]
rotation = [
  [1.0, 0.0, 0.0],
  [0.0, 1.0, 0.0],
  [0.0, 0.0, 1.0],
]

[contact]
A = "post"
B = "ball"
)");
}

TEST(WriteScenario, IsStableForAFileWrittenByHand) {
  constexpr std::string_view kByHand = R"(
contact = {A = "b", B = "a"}
source = """
Two lines,
one "quoted"."""
title = 'a literal \n'
id = "x"
bodies.a = {shape = "capsule", radius = 1_0, half_length = 0x10}
[bodies.b]
shape = "convex_hull"
vertices = [[0, 0, 9007199254740993], [0.10000000000000000555, 1e-400, -0]]
)";
  const ReadResult by_hand = ReadScenario(kByHand, "f.toml");
  ASSERT_TRUE(by_hand.scenario) << ToString(by_hand.diagnostics.at(0));
  EXPECT_EQ(by_hand.scenario->source, "Two lines,\none \"quoted\".");
  EXPECT_EQ(by_hand.scenario->title, "a literal \\n");
  const auto& hull = std::get<ConvexHull>(by_hand.scenario->contact.A.shape);
  // Halfway between two doubles, rounded to even; a long form of 0.1; a number below the
  // smallest double.
  EXPECT_EQ(hull.vertices.at(0), Eigen::Vector3d(0, 0, 9007199254740992));
  EXPECT_EQ(hull.vertices.at(1), Eigen::Vector3d(0.1, 0, 0));
  const std::string written = WriteScenario(*by_hand.scenario);
  const ReadResult again = ReadScenario(written, "f.toml");
  ASSERT_TRUE(again.scenario) << written;
  EXPECT_TRUE(SameBits(*again.scenario, *by_hand.scenario));
  EXPECT_EQ(WriteScenario(*again.scenario), written);
}

}  // namespace
}  // namespace touchstone
