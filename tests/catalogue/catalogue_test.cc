#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/catalogue/the_catalogue.h"

namespace touchstone {
namespace {

using ::testing::EndsWith;
using ::testing::SizeIs;

constexpr std::string_view kSwapped = "_swapped";

TEST(Catalogue, LoadsWithoutADiagnostic) {
  for (const Diagnostic& diagnostic : TheCatalogue().diagnostics) {
    ADD_FAILURE() << ToString(diagnostic);
  }
  EXPECT_FALSE(TheCatalogue().scenarios.empty());
}

TEST(Catalogue, StatesASeparationAndTheSourceOfItsNumbers) {
  // A derivation or a citation cannot be shorter than this.
  constexpr std::size_t kShortestSource = 40;
  for (const Scenario& scenario : TheCatalogue().scenarios) {
    EXPECT_GE(scenario.source.size(), kShortestSource) << scenario.id;
    EXPECT_THAT(scenario.source, EndsWith(".")) << scenario.id;
    EXPECT_NE(scenario.source, scenario.title) << scenario.id;
    EXPECT_TRUE(scenario.expect.separation.has_value()) << scenario.id;
  }
}

TEST(Catalogue, KeepsEachPairInTheFolderOfItsKinds) {
  for (const auto& [pair, scenarios] : ByPairFolder()) {
    for (const Scenario* scenario : scenarios) {
      const ContactQuery& query = scenario->contact;
      EXPECT_EQ(PairFolder(KindOf(query.A.shape), KindOf(query.B.shape)), pair)
          << scenario->id;
    }
  }
}

// Zeros and ones in a rotation hide errors of transposition, sign and rounding. Reports
// from users are exempt: their poses are given.
TEST(Catalogue, HasNoAxisAlignedPoseOutsideTheZoo) {
  constexpr double kAligned = 1e-9;  // Far below the smallest tilt of any scenario.
  for (const Scenario& scenario : TheCatalogue().scenarios) {
    if (scenario.id.starts_with("contact/zoo/")) continue;
    if (scenario.title.find("axis-aligned") != std::string::npos) continue;
    for (const Body* body : {&scenario.contact.A, &scenario.contact.B}) {
      const Eigen::Matrix3d& R = body->X_WB.R_WB;
      EXPECT_GT((R - R.array().round().matrix()).cwiseAbs().maxCoeff(), kAligned)
          << scenario.id;
      EXPECT_GT(body->X_WB.p_WB.cwiseAbs().minCoeff(), 0) << scenario.id;
    }
  }
}

TEST(Catalogue, ContainsTheOriginalOfEverySwappedScenarioBitForBit) {
  int swapped = 0;
  for (const Scenario& scenario : TheCatalogue().scenarios) {
    if (!scenario.id.ends_with(kSwapped)) continue;
    ++swapped;
    const std::string id = scenario.id.substr(0, scenario.id.size() - kSwapped.size());
    const auto found = Below(id);
    ASSERT_TRUE(found.contains(id)) << scenario.id;
    const Scenario& original = *found.at(id);
    EXPECT_EQ(scenario.name_A, original.name_B) << scenario.id;
    EXPECT_EQ(scenario.contact.A.X_WB.R_WB, original.contact.B.X_WB.R_WB) << scenario.id;
    EXPECT_EQ(scenario.contact.B.X_WB.R_WB, original.contact.A.X_WB.R_WB) << scenario.id;
    EXPECT_EQ(scenario.contact.A.X_WB.p_WB, original.contact.B.X_WB.p_WB) << scenario.id;
    EXPECT_EQ(scenario.contact.B.X_WB.p_WB, original.contact.A.X_WB.p_WB) << scenario.id;
    EXPECT_EQ(scenario.expect.separation, original.expect.separation) << scenario.id;
    ASSERT_THAT(scenario.expect.normals, SizeIs(original.expect.normals.size()));
    for (std::size_t i = 0; i < original.expect.normals.size(); ++i) {
      EXPECT_EQ(scenario.expect.normals[i], -original.expect.normals[i]) << scenario.id;
    }
  }
  EXPECT_GT(swapped, 0);
}

}  // namespace
}  // namespace touchstone
