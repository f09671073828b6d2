#include "oracles/cookbook/printed_oracle.h"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace touchstone {
namespace {

// Two unit spheres 1.9 m apart: the depth is 0.1 m.
const ContactQuery kSpheres = {
    {Sphere{1}, Pose::FromMatrix({0.3, -0.2, 0.7}, Eigen::Matrix3d::Identity())},
    {Sphere{1}, Pose::FromMatrix({0.3, -0.2, 2.6}, Eigen::Matrix3d::Identity())}};

double DepthFrom(std::string_view name) {
  return -*MakePrintedOracle(name)->Answer(kSpheres).separation;
}

TEST(PrintedOracle, NameSelectsTheErrata) {
  EXPECT_NEAR(DepthFrom("printed"), 0.5, 1e-15);  // E-03, halved by E-04.
  EXPECT_NEAR(DepthFrom("printed:none"), 0.1, 1e-15);
  EXPECT_NEAR(DepthFrom("printed:E-03"), 1.0, 1e-15);  // |1 − 2|, not halved.
  EXPECT_NEAR(DepthFrom("printed:E-04"), 0.05, 1e-15);
  EXPECT_NEAR(DepthFrom("printed:E-03+E-04"), 0.5, 1e-15);
  EXPECT_NEAR(DepthFrom("printed:E-26"), 0.1, 1e-15);
}

std::vector<std::string> SettingsOf(std::string_view name) {
  const std::unique_ptr<Oracle> oracle = MakePrintedOracle(name);
  std::vector<std::string> settings;
  settings.reserve(oracle->info().settings.size());
  for (const Setting& setting : oracle->info().settings)
    settings.push_back(setting.name + " = " + setting.value);
  return settings;
}

TEST(PrintedOracle, DescribesEachEnabledErratumInItsSettings) {
  const std::string separation = "separation of a contact = minus the depth";
  EXPECT_THAT(SettingsOf("printed:none"),
              testing::ElementsAre("errata = none", separation));
  EXPECT_THAT(SettingsOf("printed:E-04+E-13"),
              testing::ElementsAre("E-04 = depths of spheres are halved",
                                   "E-13 = spheres do not turn", separation));
  EXPECT_THAT(
      SettingsOf("printed"),
      testing::AllOf(testing::SizeIs(31),
                     testing::Contains("E-25 = no friction of less than 0.005 N s"),
                     testing::Contains("E-26 = depth along an axis is the common "
                                       "length of the intervals")));
}

TEST(PrintedOracle, UnknownNamesReturnNull) {
  for (const char* name :
       {"", "print", "cookbook", "printed:", "printed:E-31", "printed:E-4", "printed:all",
        "printed:E-03+", "printed:+E-03", "printedE-03"}) {
    EXPECT_EQ(MakePrintedOracle(name), nullptr) << name;
  }
}

TEST(PrintedOracle, ReturnsOnlyTheVerdictForShapesApart) {
  ContactQuery query = kSpheres;
  query.B.X_WB.p_WB[2] += 1;
  const ContactAnswer answer = MakePrintedOracle("printed:none")->Answer(query);
  EXPECT_EQ(answer.status, AnswerStatus::kAnswered);
  EXPECT_FALSE(answer.touching);
  EXPECT_FALSE(answer.n_AB_W.has_value());
  EXPECT_FALSE(answer.separation.has_value());
  EXPECT_TRUE(answer.points.empty());
}

TEST(PrintedOracle, SupportsSpheresAndBoxesOnly) {
  const std::unique_ptr<Oracle> oracle = MakePrintedOracle("printed");
  EXPECT_EQ(oracle->info().name, "printed");
  EXPECT_TRUE(oracle->info().For(ShapeKind::kBox, ShapeKind::kSphere).supported);
  EXPECT_FALSE(oracle->info().For(ShapeKind::kBox, ShapeKind::kCone).supported);
  ContactQuery query = kSpheres;
  query.A.shape = Cone{1, 1};
  EXPECT_EQ(oracle->Answer(query).status, AnswerStatus::kUnsupported);
}

}  // namespace
}  // namespace touchstone
