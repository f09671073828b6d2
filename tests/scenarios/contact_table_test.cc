#include "scenarios/contact_table.h"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include "scenarios/validate_scenario.h"
#include "tests/scenarios/any_parts.h"
#include "tests/scenarios/contact_table_text.h"
#include "tests/scenarios/same_bits.h"

namespace touchstone {
namespace {

/** Returns the error of a table as it is printed; empty if there is none. */
std::string ErrorOf(const std::string& text) {
  const ContactTable table = ReadContactTable(text, "poses.csv");
  EXPECT_EQ(table.errors.empty(), !table.scenarios.empty());
  EXPECT_LE(table.errors.size(), 1U);
  return table.errors.empty() ? "" : ToString(table.errors.front());
}

/** Two balls, with `row` as the second line below the names. */
std::string Balls(const std::string& row) {
  return "A.shape,A.radius,B.shape,B.radius,B.position.x,B.position.y,B.position.z\n"
         "sphere,1,sphere,1,1.9,0,0\n" +
         row + '\n';
}

RC_GTEST_PROP(ContactTable, IsReadBackBitForBit, ()) {
  std::vector<Scenario> scenarios;
  const int rows = *rc::gen::inRange(1, 5);
  for (int i = 0; i < rows; ++i) {
    const auto any_pose = [] {
      Pose pose = AnyPose();
      return pose.q_WB ? pose
                       : Pose::FromQuaternion(pose.p_WB, Eigen::Quaterniond::Identity());
    };
    Scenario& scenario = scenarios.emplace_back();
    scenario.contact.A = {AnyShape(false), any_pose()};
    const bool bounded = KindOf(scenario.contact.A.shape) == ShapeKind::kHalfSpace;
    scenario.contact.B = {AnyShape(bounded), any_pose()};
  }
  const std::string text = ContactTableText(scenarios);
  RC_LOG() << text;
  const ContactTable table = ReadContactTable(text, "poses.csv");
  for (const Diagnostic& error : table.errors) RC_LOG() << ToString(error);
  RC_ASSERT(table.scenarios.size() == scenarios.size());
  for (std::size_t i = 0; i < scenarios.size(); ++i) {
    RC_ASSERT(SameBits(table.scenarios[i].contact, scenarios[i].contact));
    RC_ASSERT(FaultsOf(table.scenarios[i]).empty());
  }
}

TEST(ContactTable, HasAQuestionForEachRow) {
  const ContactTable table = ReadContactTable(
      "\xEF\xBB\xBF"
      "B.shape,B.half_extents.x,B.half_extents.y,B.half_extents.z,A.shape,A.radius,"
      "B.quaternion.w,B.quaternion.x,B.quaternion.y,B.quaternion.z\r\n"
      "\r\n"
      "box,1,2,3,sphere,0.5,0.6,0,0.8,0\r\n"
      "half_space,,,,sphere,.25,1,0,0,0",
      "logs/poses.csv");
  ASSERT_TRUE(table.errors.empty()) << ToString(table.errors.front());
  ASSERT_EQ(table.scenarios.size(), 2U);
  const Scenario& first = table.scenarios[0];
  EXPECT_EQ(first.title, "Line 3 of poses.csv");
  EXPECT_EQ(first.source, "logs/poses.csv:3");
  EXPECT_EQ(std::get<Sphere>(first.contact.A.shape).radius, 0.5);
  EXPECT_EQ(std::get<Box>(first.contact.B.shape).half_extents, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(first.contact.B.X_WB.q_WB->y(), 0.8);
  EXPECT_EQ(first.contact.A.X_WB.R_WB, Eigen::Matrix3d::Identity());
  EXPECT_EQ(KindOf(table.scenarios[1].contact.B.shape), ShapeKind::kHalfSpace);
}

TEST(ContactTable, NormalisesQuaternionsOfSevenDigitsWithOneNote) {
  const std::string header =
      "A.shape,A.radius,A.quaternion.w,A.quaternion.x,A.quaternion.y,A.quaternion.z,"
      "B.shape\n";
  const std::string row = "sphere,1,0.7071068,0.7071068,0,0,half_space\n";
  const ContactTable table = ReadContactTable(header + row + row, "poses.csv");
  ASSERT_EQ(table.scenarios.size(), 2U);
  EXPECT_TRUE(FaultsOf(table.scenarios[0]).empty());
  ASSERT_TRUE(table.note);
  EXPECT_THAT(
      ToNote(*table.note),
      testing::StartsWith("poses.csv:2:1: note: A.quaternion has norm 1.00000002"));
  EXPECT_THAT(ToNote(*table.note), testing::EndsWith(", and so were 1 more"));
  EXPECT_EQ(
      ErrorOf(header + "sphere,1,1,1,1,1,half_space"),
      "poses.csv:2:10: A.quaternion has norm 2; expected a unit quaternion w, x, y, "
      "z: of norm 1 to 1e-06 in a file, to 1e-12 in a program");
}

TEST(ContactTable, RefusesAHeaderThatIsNotOne) {
  EXPECT_EQ(ErrorOf(""),
            "poses.csv: is empty; expected a line that names the columns, e.g. "
            "A.shape,A.radius,…");
  EXPECT_EQ(ErrorOf("A.shape,B.shape\n"),
            "poses.csv: has no rows; expected a question in each line below the names of "
            "the columns");
  EXPECT_EQ(ErrorOf("A.shape,A.radius\n"),
            "poses.csv:1:1: there is no column B.shape; expected one");
  EXPECT_EQ(ErrorOf("A.shape,A.radios,B.shape\n"),
            "poses.csv:1:9: there is no column \"A.radios\" (did you mean A.radius?); "
            "expected name, or columns of A and B: shape, sizes, position.x … z, "
            "quaternion.w … z");
  EXPECT_EQ(ErrorOf("A.shape,B.shape,A.shape\n"),
            "poses.csv:1:17: A.shape is there twice; expected each column once");
  EXPECT_EQ(ErrorOf("A.shape,B.shape,A.position.x,A.position.y\n"),
            "poses.csv:1:1: there is no column A.position.z; expected one");
  EXPECT_EQ(ErrorOf("A.shape,B.shape,B.quaternion.x,B.quaternion.y,B.quaternion.z\n"),
            "poses.csv:1:1: there is no column B.quaternion.w; expected one");
  EXPECT_EQ(ErrorOf("\"A.shape\",B.shape\n"),
            "poses.csv:1:1: there is a quotation mark; expected cells without any");
}

TEST(ContactTable, RefusesARowWithItsPlace) {
  EXPECT_EQ(ErrorOf(Balls("sphere,1,sphere,1,1.9,0")),
            "poses.csv:3:1: has 6 cells; expected 7, as the first line names columns");
  EXPECT_EQ(
      ErrorOf(Balls("sphere,1,spere,1,1.9,0,0")),
      "poses.csv:3:10: B.shape is \"spere\" (did you mean sphere?); expected one of "
      "sphere, box, capsule, cylinder, cone, convex_hull, half_space");
  EXPECT_EQ(ErrorOf(Balls("sphere,1,box,1,1.9,0,0")),
            "poses.csv:3:14: B.radius is 1, but B.shape is box; expected an empty cell");
  EXPECT_EQ(ErrorOf(Balls("sphere,1,box,,1.9,0,0")),
            "poses.csv:3:10: B.shape is box, and there is no column B.half_extents.x; "
            "expected one");
  EXPECT_EQ(
      ErrorOf(Balls("half_space,,half_space,,0,0,0")),
      "poses.csv:3:13: B.shape is a half_space, and so is the other body's; expected "
      "at most one half_space");
}

TEST(ContactTable, TellsTheFirstErrorOfEachOfFiveRows) {
  std::string text = "A.shape,A.radius,B.shape\n";
  for (int row = 0; row < 7; ++row) {
    text += "sphere,1,half_space\n";
    text += "sphere,0,half_place\n";
  }
  const ContactTable table = ReadContactTable(text, "poses.csv");
  EXPECT_TRUE(table.scenarios.empty());
  ASSERT_EQ(table.errors.size(), 5U);
  for (int row = 0; row < 5; ++row) {
    EXPECT_EQ(table.errors[static_cast<std::size_t>(row)].line, 3 + 2 * row);
    EXPECT_THAT(ToString(table.errors[static_cast<std::size_t>(row)]),
                testing::HasSubstr("B.shape is \"half_place\""));
  }
}

TEST(ContactTable, NamesARowInItsTitle) {
  const std::string header = "A.shape,A.radius,name,B.shape\n";
  const ContactTable table = ReadContactTable(
      header + "sphere,1,left wheel,half_space\nsphere,1,,half_space\n", "poses.csv");
  ASSERT_EQ(table.scenarios.size(), 2U);
  EXPECT_EQ(table.scenarios[0].title, "left wheel: Line 2 of poses.csv");
  EXPECT_EQ(table.scenarios[1].title, "Line 3 of poses.csv");
  EXPECT_EQ(ErrorOf(header + "sphere,1,tab\there,half_space\n"),
            "poses.csv:2:10: name has a character that is not printable ASCII; expected "
            "letters, digits, spaces and signs of ASCII");
}

TEST(ContactTable, RefusesNumbersThatAreNotFiniteOrOutOfRange) {
  for (const char* number :
       {"nan", "inf", "-inf", "1e999", "", " 1", "1 ", "0x1", "+1"}) {
    EXPECT_EQ(ErrorOf(Balls(std::string("sphere,1,sphere,1,") + number + ",0,0")),
              std::string("poses.csv:3:19: B.position.x is \"") + number +
                  "\"; expected a finite number, without spaces");
  }
  EXPECT_EQ(ErrorOf(Balls("sphere,-1,sphere,1,1.9,0,0")),
            "poses.csv:3:8: A.radius is -1; expected a finite length > 0");
  EXPECT_EQ(ErrorOf(Balls("sphere,1,sphere,1,1.9,1e200,0")),
            "poses.csv:3:23: B.position.y is 1e+200; expected 0 m, or a magnitude from "
            "1e-100 to 1e+100 m");
}

TEST(ContactTable, ReadsTheVerticesOfAHullFromOneCell) {
  const auto hull = [](const std::string& vertices) {
    return "A.shape,A.vertices,B.shape\nconvex_hull," + vertices + ",half_space\n";
  };
  const ContactTable table = ReadContactTable(hull("0 0 1 -1 0.5 2"), "poses.csv");
  ASSERT_EQ(table.scenarios.size(), 1U);
  EXPECT_THAT(
      std::get<ConvexHull>(table.scenarios[0].contact.A.shape).vertices,
      testing::ElementsAre(Eigen::Vector3d(0, 0, 1), Eigen::Vector3d(-1, 0.5, 2)));
  EXPECT_EQ(ErrorOf(hull("0 0 1 2")),
            "poses.csv:2:13: A.vertices has 4 numbers; expected three for each vertex");
  EXPECT_EQ(ErrorOf(hull("")),
            "poses.csv:2:13: A.vertices has 0 numbers; expected three for each vertex");
  EXPECT_EQ(ErrorOf(hull("0 0 z")),
            "poses.csv:2:17: A.vertices has \"z\"; expected finite numbers, one space "
            "between two");
  EXPECT_EQ(
      ErrorOf(hull("0 0 1e150")),
      "poses.csv:2:13: A.vertices[0][2] is 1e+150; expected 0 m, or a magnitude from "
      "1e-100 to 1e+100 m");
}

TEST(ContactTable, CountsColumnsInCodePoints) {
  EXPECT_EQ(
      ErrorOf(Balls("sphère,1,sphere,1,1.9,0,0")),
      "poses.csv:3:1: A.shape is \"sphère\" (did you mean sphere?); expected one of "
      "sphere, box, capsule, cylinder, cone, convex_hull, half_space");
  EXPECT_THAT(ErrorOf("A.shape,ö,ü\n"), testing::StartsWith("poses.csv:1:9: "));
}

TEST(ContactTableFile, ThatIsNotThereIsAnError) {
  const ContactTable table = ReadContactTableFile("/nowhere/poses.csv");
  ASSERT_EQ(table.errors.size(), 1U);
  EXPECT_EQ(ToString(table.errors.front()),
            "/nowhere/poses.csv: cannot be read; expected a CSV file");
}

}  // namespace
}  // namespace touchstone
