#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scenarios/scenario_file.h"

namespace touchstone {
namespace {

using ::testing::ElementsAre;

constexpr std::string_view kGood = R"(id = "contact/sphere_box/face"
title = "A ball on a post"
source = "Derived by hand."

[bodies.post]
shape = "box"
half_extents = [1, 2.5, 3.0]
position = [0.1, 0.2, -0.0]
quaternion = [0.6, 0.0, 0.8, 0]

[bodies.ball]
shape = "sphere"
radius = 0.3333333333333333

[contact]
A = "post"
B = "ball"

[expect]
touching = true
separation = -0.1
normals = [[0.6, 0.0, 0.8]]
contacts = 1

[tolerance]
separation = 1e-9
because = "The source prints nine digits."

[[indicts]]
oracle = "fcl/signed_distance"
measures = ["separation_error", "excess"]
anomaly = "The distance is positive."
reproduces = true
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
  EXPECT_EQ(result.scenario.has_value(), result.diagnostics.empty());
  std::vector<std::string> errors;
  for (const Diagnostic& diagnostic : result.diagnostics) {
    errors.push_back(ToString(diagnostic));
  }
  return errors;
}

TEST(ReadScenario, ReturnsTheContentsOfTheFile) {
  const ReadResult result = ReadScenario(kGood, "f.toml");
  ASSERT_TRUE(result.scenario) << ToString(result.diagnostics.at(0));
  const Scenario& s = *result.scenario;
  EXPECT_EQ(s.id, "contact/sphere_box/face");
  EXPECT_EQ(s.title, "A ball on a post");
  EXPECT_EQ(s.source, "Derived by hand.");
  EXPECT_EQ(s.name_A, "post");
  EXPECT_EQ(s.name_B, "ball");
  EXPECT_EQ(std::get<Box>(s.contact.A.shape).half_extents, Eigen::Vector3d(1, 2.5, 3));
  EXPECT_EQ(s.contact.A.X_WB.p_WB, Eigen::Vector3d(0.1, 0.2, 0));
  EXPECT_TRUE(std::signbit(s.contact.A.X_WB.p_WB.z()));
  ASSERT_TRUE(s.contact.A.X_WB.q_WB);
  EXPECT_EQ(s.contact.A.X_WB.q_WB->coeffs(), Eigen::Vector4d(0, 0.8, 0, 0.6));  // x y z w
  EXPECT_EQ(std::get<Sphere>(s.contact.B.shape).radius, 0.3333333333333333);
  EXPECT_EQ(s.expect.touching, true);
  EXPECT_EQ(s.expect.separation, -0.1);
  EXPECT_THAT(s.expect.normals, ElementsAre(Eigen::Vector3d(0.6, 0, 0.8)));
  EXPECT_EQ(s.expect.contacts, 1);
  EXPECT_EQ(s.tolerance.value().separation, 1e-9);
  EXPECT_EQ(s.tolerance.value().because, "The source prints nine digits.");
  ASSERT_EQ(s.indicts.size(), 1U);
  EXPECT_EQ(s.indicts[0].oracle, "fcl/signed_distance");
  EXPECT_THAT(s.indicts[0].measures,
              ElementsAre(MeasureKind::kSeparationError, MeasureKind::kExcess));
  EXPECT_EQ(s.indicts[0].anomaly, "The distance is positive.");
  EXPECT_TRUE(s.indicts[0].reproduces);
}

TEST(ReadScenario, PlacesABodyWithoutAPoseAtTheOrigin) {
  const ReadResult result = ReadScenario(kGood, "f.toml");
  ASSERT_TRUE(result.scenario);
  const Pose& X_WB = result.scenario->contact.B.X_WB;
  EXPECT_EQ(X_WB.p_WB, Eigen::Vector3d::Zero());
  EXPECT_EQ(X_WB.R_WB, Eigen::Matrix3d::Identity());
}

TEST(ReadScenario, KeepsARotationMatrixAsItIs) {
  // A third of a turn about (1, 1, 1) maps x to y, y to z and z to x.
  const ReadResult result =
      ReadScenario(With("quaternion = [0.6, 0.0, 0.8, 0]",
                        "rotation = [[0, 0, 1], [1, 0, 0], [0, 1, 0]]"),
                   "f.toml");
  ASSERT_TRUE(result.scenario) << ToString(result.diagnostics.at(0));
  const Pose& X_WB = result.scenario->contact.A.X_WB;
  EXPECT_FALSE(X_WB.q_WB);
  EXPECT_EQ(X_WB.R_WB * Eigen::Vector3d(1, 2, 3), Eigen::Vector3d(3, 1, 2));
}

TEST(ReadScenario, NormalisesAQuaternionOfSevenDigitsWithANote) {
  const auto with = [](std::string_view quaternion) {
    return ReadScenario(With("[0.6, 0.0, 0.8, 0]", quaternion), "f.toml");
  };
  const ReadResult seven = with("[0.9486833, 0.3162277, 0, 0]");
  ASSERT_TRUE(seven.scenario) << ToString(seven.diagnostics.at(0));
  const Eigen::Quaterniond& q = *seven.scenario->contact.A.X_WB.q_WB;
  EXPECT_NEAR(q.norm(), 1, 1e-15);
  EXPECT_NEAR(q.x() / q.w(), 0.3162277 / 0.9486833, 1e-15);
  ASSERT_EQ(seven.notes.size(), 1U);
  EXPECT_EQ(ToNote(seven.notes[0]).substr(0, 50),
            "f.toml:9:14: note: the quaternion has norm 0.99999");
  // Off by 4e-6, so more than seven digits can be.
  EXPECT_EQ(with("[0.9486833, 0.31624, 0, 0]").diagnostics.size(), 1U);
  EXPECT_TRUE(with("[0.6, 0.0, 0.8, 0]").notes.empty());
}

TEST(ReadScenario, RefusesAKeyOfTooManyLevels) {
  const auto key = [](int levels) {
    std::string text = "\n[expect.more]\n\"a.b\"";  // A quoted name is one level.
    for (int i = 1; i < levels; ++i) text += " . a";
    return std::string(kGood) + text + " = 1.5 # a.b.c.d.e.f.g.h.i.j.k.l.m.n.o.p.q.r\n";
  };
  EXPECT_THAT(ErrorsOf(key(50'000)),
              ElementsAre("f.toml:36:68: the key has more than 16 levels; expected at "
                          "most 16 names with dots between them"));
  EXPECT_THAT(ErrorsOf(key(17)), ElementsAre(testing::HasSubstr("more than 16 levels")));
  for (const std::string& error : ErrorsOf(key(16)))
    EXPECT_THAT(error, testing::Not(testing::HasSubstr("levels")));
}

TEST(ReadScenario, DoesNotTakeDotsInStringsForLevels) {
  const std::string dots(100, '.');
  const std::string three(3, '\'');
  for (const std::string& text :
       {"\"a " + dots + "\"", "'a " + dots + "'", "\"\"\"a\n" + dots + "\"\"\"",
        three + "a\n" + dots + three, "\"\\\"" + dots + "\""}) {
    EXPECT_THAT(ErrorsOf(With("\"Derived by hand.\"", text)), ElementsAre()) << text;
  }
}

TEST(ReadScenario, RefusesAHullOfTooManyPoints) {
  const auto hull = [](int points) {
    std::string vertices;
    for (int i = 0; i < points; ++i) vertices += fmt::format("[{}, {}, 1.5],", i, i % 7);
    return With("shape = \"sphere\"\nradius = 0.3333333333333333",
                fmt::format("shape = \"convex_hull\"\nvertices = [{}]", vertices));
  };
  EXPECT_THAT(ErrorsOf(hull(1000)), ElementsAre());
  EXPECT_THAT(
      ErrorsOf(hull(160'000)),
      ElementsAre("f.toml:13:12: bodies.ball.vertices has 160000 points; expected "
                  "at most 1000"));
}

TEST(ReadScenario, SuggestsTheNearestKeyForAnUnknownOne) {
  EXPECT_THAT(ErrorsOf(With("radius", "raduis")),
              ElementsAre("f.toml:13:1: unknown key \"raduis\" in bodies.ball; "
                          "expected \"radius\""));
}

TEST(ReadScenario, ListsTheKnownKeysIfNoneIsNear) {
  EXPECT_THAT(
      ErrorsOf(With("radius = ", "radius = 1\nmass = ")),
      ElementsAre("f.toml:14:1: unknown key \"mass\" in bodies.ball; expected one of "
                  "shape, position, quaternion, rotation, radius"));
}

TEST(ReadScenario, RefusesAKeyOfAnotherShape) {
  EXPECT_THAT(
      ErrorsOf(With("radius = ", "radius = 1\nhalf_height = ")),
      ElementsAre("f.toml:14:1: unknown key \"half_height\" in bodies.ball; expected "
                  "one of shape, position, quaternion, rotation, radius"));
}

TEST(ReadScenario, RefusesNaN) {
  EXPECT_THAT(ErrorsOf(With("0.2, -0.0", "nan, -0.0")),
              ElementsAre("f.toml:8:18: bodies.post.position[1] is nan; "
                          "expected a finite number"));
}

TEST(ReadScenario, RefusesInfinity) {
  EXPECT_THAT(ErrorsOf(With("radius = 0.3333333333333333", "radius = inf")),
              ElementsAre("f.toml:13:10: bodies.ball.radius is inf; "
                          "expected a finite length > 0"));
}

TEST(ReadScenario, RefusesASizeThatIsNotPositive) {
  EXPECT_THAT(ErrorsOf(With("[1, 2.5, 3.0]", "[1, 0, -2.5]")),
              ElementsAre("f.toml:7:20: bodies.post.half_extents[1] is 0; "
                          "expected a finite length > 0",
                          "f.toml:7:23: bodies.post.half_extents[2] is -2.5; "
                          "expected a finite length > 0"));
}

TEST(ReadScenario, RefusesAQuaternionThatIsNotUnit) {
  EXPECT_THAT(
      ErrorsOf(With("0.8, 0]", "0.8, 1]")),
      ElementsAre("f.toml:9:14: bodies.post.quaternion has norm 1.4142135623730951; "
                  "expected a unit quaternion w, x, y, z: of norm 1 to 1e-06 in a file, "
                  "to 1e-12 in a program"));
}

TEST(ReadScenario, RefusesARotationThatMirrors) {
  EXPECT_THAT(
      ErrorsOf(With("quaternion = [0.6, 0.0, 0.8, 0]",
                    "rotation = [[1, 0, 0], [0, 1, 0], [0, 0, -1]]")),
      ElementsAre("f.toml:9:12: bodies.post.rotation mirrors: its determinant is -1; "
                  "expected three orthonormal rows of determinant +1"));
}

TEST(ReadScenario, RefusesAMatrixThatIsNotARotation) {
  // The first row is (1, 0.5, 0): RᵀR has 0.5 off its diagonal, and 1 + 0.25 on it.
  EXPECT_THAT(
      ErrorsOf(With("quaternion = [0.6, 0.0, 0.8, 0]",
                    "rotation = [[1, 0.5, 0], [0, 1, 0], [0, 0, 1]]")),
      ElementsAre("f.toml:9:12: bodies.post.rotation deviates from orthonormal by "
                  "0.5; expected three orthonormal rows of determinant +1, to "
                  "1e-06"));
}

TEST(ReadScenario, RefusesAQuaternionTogetherWithARotation) {
  EXPECT_THAT(ErrorsOf(With("radius = ",
                            "quaternion = [1, 0, 0, 0]\n"
                            "rotation = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]\nradius = ")),
              ElementsAre("f.toml:14:12: bodies.ball has a quaternion and a rotation; "
                          "expected one of the two"));
}

TEST(ReadScenario, RefusesAnUnknownBodyName) {
  EXPECT_THAT(ErrorsOf(With("B = \"ball\"", "B = \"bal\"")),
              ElementsAre("f.toml:17:5: contact.B is \"bal\", which is not a body; "
                          "expected \"ball\""));
}

TEST(ReadScenario, RefusesABodyThatTouchesItself) {
  EXPECT_THAT(ErrorsOf(With("B = \"ball\"", "B = \"post\"")),
              ElementsAre("f.toml:11:1: bodies.ball is not in the question; "
                          "expected two bodies, contact.A and contact.B",
                          "f.toml:17:5: contact.B is \"post\", the same as contact.A; "
                          "expected another body"));
}

TEST(ReadScenario, RefusesAThirdBody) {
  EXPECT_THAT(
      ErrorsOf(With("[contact]", "[bodies.idle]\nshape = \"half_space\"\n[contact]")),
      ElementsAre("f.toml:15:1: bodies.idle is not in the question; "
                  "expected two bodies, contact.A and contact.B"));
}

TEST(ReadScenario, RefusesABodyNameThatNeedsQuotes) {
  EXPECT_THAT(ErrorsOf(With("[bodies.ball]", "[bodies.\"a ball\"]",
                            With("B = \"ball\"", "B = \"a ball\""))),
              ElementsAre("f.toml:11:9: a body is named \"a ball\"; "
                          "expected a name of A-Z, a-z, 0-9, _ and -"));
}

TEST(ReadScenario, RefusesAValueOfTheWrongType) {
  EXPECT_THAT(ErrorsOf(With("radius = 0.3333333333333333", "radius = \"small\"")),
              ElementsAre("f.toml:13:10: bodies.ball.radius is a string; "
                          "expected a finite length > 0"));
  EXPECT_THAT(ErrorsOf(With("[1, 2.5, 3.0]", "2")),
              ElementsAre("f.toml:7:16: bodies.post.half_extents is an integer; "
                          "expected three finite lengths > 0"));
  EXPECT_THAT(ErrorsOf(With("[1, 2.5, 3.0]", "[1, true, 3.0]")),
              ElementsAre("f.toml:7:20: bodies.post.half_extents[1] is a boolean; "
                          "expected a finite number"));
  EXPECT_THAT(
      ErrorsOf(With("touching = true", "touching = 1979-05-27")),
      ElementsAre("f.toml:20:12: expect.touching is a date; expected true or false"));
  EXPECT_THAT(ErrorsOf(With("contacts = 1", "contacts = 1.0")),
              ElementsAre("f.toml:23:12: expect.contacts is a floating-point number; "
                          "expected a count, 0 or more"));
  EXPECT_THAT(ErrorsOf(With("[[indicts]]", "[indicts]")),
              ElementsAre("f.toml:29:1: indicts is a table; expected a list of tables"));
  EXPECT_THAT(ErrorsOf(With("[0.6, 0.0, 0.8, 0]", "[0.6, 0.0, 0.8, \"0\"]")),
              ElementsAre("f.toml:9:30: bodies.post.quaternion[3] is a string; "
                          "expected a finite number"));
}

TEST(ReadScenario, RefusesAListOfTheWrongLength) {
  EXPECT_THAT(ErrorsOf(With("[0.6, 0.0, 0.8, 0]", "[0.6, 0.0, 0.8]")),
              ElementsAre("f.toml:9:14: bodies.post.quaternion has 3 elements; "
                          "expected four numbers w, x, y, z"));
}

TEST(ReadScenario, ReportsOneErrorForAnUnknownShape) {
  EXPECT_THAT(
      ErrorsOf(With("\"sphere\"", "\"ball\"")),
      ElementsAre("f.toml:12:9: bodies.ball.shape is \"ball\"; expected one of "
                  "sphere, box, capsule, cylinder, cone, convex_hull, half_space"));
}

TEST(ReadScenario, RefusesAHullWithoutVertices) {
  EXPECT_THAT(ErrorsOf(With("shape = \"sphere\"\nradius = 0.3333333333333333",
                            "shape = \"convex_hull\"\nvertices = []")),
              ElementsAre("f.toml:13:12: bodies.ball.vertices is empty; "
                          "expected at least one vertex"));
}

TEST(ReadScenario, RefusesTwoHalfSpaces) {
  EXPECT_THAT(
      ErrorsOf(With("shape = \"sphere\"\nradius = 0.3333333333333333",
                    "shape = \"half_space\"",
                    With("shape = \"box\"\nhalf_extents = [1, 2.5, 3.0]",
                         "shape = \"half_space\""))),
      ElementsAre("f.toml:11:9: bodies.ball.shape is \"half_space\", like that of "
                  "bodies.post; expected at most one half_space"));
}

TEST(ReadScenario, RefusesAFileWithoutARequiredKey) {
  EXPECT_THAT(ErrorsOf(With("[contact]\nA = \"post\"\nB = \"ball\"\n", "")),
              ElementsAre("f.toml:1:1: neither [contact] nor [world] is present; "
                          "expected one of the two"));
  EXPECT_THAT(ErrorsOf(With("reproduces = true\n", "")),
              ElementsAre("f.toml:29:1: indicts[0].reproduces is missing; "
                          "expected true or false"));
}

TEST(ReadScenario, RefusesAnIndictmentWithoutAKnownMeasure) {
  const std::string measures = "measures = [\"separation_error\", \"excess\"]";
  EXPECT_THAT(ErrorsOf(With(measures + "\n", "")),
              ElementsAre("f.toml:29:1: indicts[0].measures is missing; expected a list "
                          "of measures, e.g. [\"separation_error\"]"));
  EXPECT_THAT(ErrorsOf(With(measures, "measures = []")),
              ElementsAre("f.toml:31:12: indicts[0].measures is empty; expected a list "
                          "of measures, e.g. [\"separation_error\"]"));
  EXPECT_THAT(ErrorsOf(With(measures, "measures = \"excess\"")),
              ElementsAre("f.toml:31:12: indicts[0].measures is a string; expected a "
                          "list of measures, e.g. [\"separation_error\"]"));
  EXPECT_THAT(ErrorsOf(With("\"excess\"]", "\"exces\", 1]")),
              ElementsAre("f.toml:31:33: indicts[0].measures[1] is \"exces\"; expected "
                          "\"excess\"",
                          "f.toml:31:42: indicts[0].measures[2] is an integer; expected "
                          "a non-empty string"));
  EXPECT_THAT(ErrorsOf(With("\"excess\"]", "\"it is wrong\"]")),
              ElementsAre(testing::StartsWith(
                  "f.toml:31:33: indicts[0].measures[1] is \"it is wrong\"; expected one "
                  "of touching, separation_error, ")));
}

TEST(ReadScenario, RefusesAnIdThatIsNotAPath) {
  for (const char* id : {"", "/a", "a/", "a//b", "A", "a b", "a.b", "a-b"}) {
    EXPECT_THAT(ErrorsOf(With("contact/sphere_box/face", id)),
                ElementsAre("f.toml:1:6: id is \"" + std::string(id) +
                            "\"; expected a string: levels of a-z, 0-9 and _ joined by "
                            "slashes"));
  }
}

TEST(ReadScenario, RefusesAnEmptyText) {
  EXPECT_THAT(ErrorsOf(With("A ball on a post", "")),
              ElementsAre("f.toml:2:9: title is empty; expected a non-empty string"));
}

TEST(ReadScenario, RefusesAnExpectedNormalThatIsNotUnit) {
  EXPECT_THAT(ErrorsOf(With("[[0.6, 0.0, 0.8]]", "[[0.6, 0.0, 0.8], [0, 3, 4]]")),
              ElementsAre("f.toml:22:29: expect.normals[1] has norm 5; "
                          "expected a unit vector, to 1e-09"));
}

TEST(ReadScenario, RefusesANegativeCountOfContacts) {
  EXPECT_THAT(
      ErrorsOf(With("contacts = 1", "contacts = -1")),
      ElementsAre("f.toml:23:12: expect.contacts is -1; expected a count, 0 or more"));
}

TEST(ReadScenario, RefusesACountBeyondAnInt) {
  EXPECT_THAT(ErrorsOf(With("contacts = 1", "contacts = 3000000000")),
              ElementsAre("f.toml:23:12: expect.contacts is 3000000000; "
                          "expected a count, 0 or more"));
}

TEST(ReadScenario, RefusesAToleranceOfZero) {
  EXPECT_THAT(ErrorsOf(With("separation = 1e-9", "separation = 0")),
              ElementsAre("f.toml:26:14: tolerance.separation is 0; "
                          "expected a finite length > 0"));
}

TEST(ReadScenario, GivesThePositionOfASyntaxError) {
  EXPECT_THAT(
      ErrorsOf("id = \"a\"\ntitle = [1, \n"),
      ElementsAre("f.toml:2:14: Error while parsing array: encountered end-of-file; "
                  "expected valid TOML 1.0"));
}

TEST(ReadScenario, RefusesAKeyGivenTwice) {
  EXPECT_THAT(
      ErrorsOf("id = \"a\"\nid = \"b\"\n"),
      ElementsAre("f.toml:2:6: Error while parsing key-value pair: cannot redefine "
                  "existing string 'id'; expected valid TOML 1.0"));
}

TEST(ReadScenario, ReportsEveryErrorInTheOrderOfLines) {
  EXPECT_THAT(
      ErrorsOf(With("radius = ", "raduis = 1\nposition = [inf, \"left\", 0]\nradius = -",
                    With("title", "tilte", With("A = \"post\"", "A = \"past\"")))),
      ElementsAre(
          "f.toml:2:1: unknown key \"tilte\"; expected \"title\"",
          "f.toml:13:1: unknown key \"raduis\" in bodies.ball; expected \"radius\"",
          "f.toml:14:13: bodies.ball.position[0] is inf; expected a finite number",
          "f.toml:14:18: bodies.ball.position[1] is a string; expected a finite number",
          "f.toml:15:10: bodies.ball.radius is -0.3333333333333333; "
          "expected a finite length > 0",
          "f.toml:18:5: contact.A is \"past\", which is not a body; expected \"post\""));
}

}  // namespace
}  // namespace touchstone
