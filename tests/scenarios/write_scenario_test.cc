#include <bit>
#include <cmath>
#include <cstdint>
#include <string>

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include "scenarios/scenario_file.h"
#include "scenarios/validate_scenario.h"
#include "tests/scenarios/same_bits.h"

namespace touchstone {
namespace {

/** Any finite double: every exponent is as likely, denormals and -0 among them. */
double AnyNumber() {
  const auto bits = *rc::gen::arbitrary<std::uint64_t>();
  // rc's integers grow with the size of the test, so that they are mixed to fill the
  // exponent.
  const auto value = std::bit_cast<double>(bits * 0x9e3779b97f4a7c15U);
  const double special =
      *rc::gen::element(-0.0, 0.1, 5e-324, 1e16, 0x1.fffffffffffffp1023);
  return std::isfinite(value) && *rc::gen::inRange(0, 4) != 0 ? value : special;
}

double AnyLength() {
  const double value = std::abs(AnyNumber());
  return value > 0 ? value : 1.0 / 3;
}

Eigen::Vector3d AnyPoint() {
  return {AnyNumber(), AnyNumber(), AnyNumber()};
}

/** A component of a direction, dense enough to need 17 digits. */
double AnyComponent() {
  return *rc::gen::inRange(-1000, 1000) / 997.0;
}

std::string AnyText() {
  const std::string text =
      *rc::gen::nonEmpty(rc::gen::container<std::string>(rc::gen::map(
          rc::gen::inRange(0, 128), [](int c) { return static_cast<char>(c); })));
  return *rc::gen::element<std::string>("", "π ≈ 3", "\"\"\"", "\\u0041",
                                        "# no comment") +
         text;
}

Pose AnyPose() {
  const Eigen::Vector4d wxyz(AnyComponent(), AnyComponent(), AnyComponent(), 0.1);
  const Eigen::Quaterniond q_WB(wxyz.normalized());
  if (*rc::gen::arbitrary<bool>()) return Pose::FromQuaternion(AnyPoint(), q_WB);
  return Pose::FromMatrix(AnyPoint(), q_WB.toRotationMatrix());
}

Shape AnyShape(bool bounded) {
  // At full size, since rc's small tests would hardly leave the first kinds.
  switch (static_cast<ShapeKind>(*rc::gen::resize(
      rc::kNominalSize, rc::gen::inRange(0, kShapeKinds - (bounded ? 1 : 0))))) {
    case ShapeKind::kSphere:
      return Sphere{AnyLength()};
    case ShapeKind::kBox:
      return Box{{AnyLength(), AnyLength(), AnyLength()}};
    case ShapeKind::kCapsule:
      return Capsule{AnyLength(), AnyLength()};
    case ShapeKind::kCylinder:
      return Cylinder{AnyLength(), AnyLength()};
    case ShapeKind::kCone:
      return Cone{AnyLength(), AnyLength()};
    case ShapeKind::kConvexHull: {
      ConvexHull hull;
      const int vertices = *rc::gen::inRange(1, 9);
      for (int i = 0; i < vertices; ++i) hull.vertices.push_back(AnyPoint());
      return hull;
    }
    case ShapeKind::kHalfSpace:
      return HalfSpace{};
  }
  return HalfSpace{};
}

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
  if (*rc::gen::arbitrary<bool>()) scenario.expect.touching = *rc::gen::arbitrary<bool>();
  if (*rc::gen::arbitrary<bool>()) scenario.expect.separation = AnyNumber();
  const int normals = *rc::gen::inRange(0, 3);
  for (int i = 0; i < normals; ++i) {
    scenario.expect.normals.push_back(
        Eigen::Vector3d(AnyComponent(), AnyComponent(), 0.1).normalized());
  }
  if (*rc::gen::arbitrary<bool>()) scenario.expect.contacts = *rc::gen::inRange(0, 9);
  if (*rc::gen::arbitrary<bool>()) scenario.tolerance = {AnyLength(), AnyText()};
  const int indictments = *rc::gen::inRange(0, 3);
  for (int i = 0; i < indictments; ++i) {
    scenario.indicts.push_back({AnyText(), AnyText(), *rc::gen::arbitrary<bool>()});
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
  // Halfway between two doubles, to even; the shortest form of 0.1; less than the least
  // double.
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
