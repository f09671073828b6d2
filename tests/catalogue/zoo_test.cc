#include <fstream>
#include <iterator>
#include <set>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/catalogue/the_catalogue.h"
#include "tests/source_tree.h"

namespace touchstone {
namespace {

using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::IsSupersetOf;

constexpr std::string_view kZoo = "contact/zoo/";

/** Reported cases that are not scenarios; docs/catalogue.md states the reason. */
const std::set<std::string> kNotAsked = {"bullet-2646", "fcl-503", "mj-1857",
                                         "mj-8655446f", "ncollide-157-mj"};

/** Reported cases that are world scenarios. */
const std::set<std::string> kAskedOfMotion = {"dart_1193", "mj_3553", "mj_420"};

/** Reported cases that are contact scenarios. */
const std::set<std::string> kAsked = {
    "boxbox_fudge_395",
    "bullet_1703",
    "bullet_1703b",
    "bullet_889",
    "ccd_17",
    "ccd_25",
    "ccd_49",
    "ccd_7",
    "ccd_71b",
    "ccd_parry70",
    "coal_351",
    "drake_1668",
    "drake_21234",
    "drake_21234_cv8",
    "drake_21673_box",
    "drake_21673_cv1",
    "drake_21673_cv2",
    "drake_21673_cv3",
    "drake_21673_cv4",
    "drake_21673_cv6",
    "drake_21673_cv7",
    "drake_7656",
    "fcl_127",
    "fcl_275",
    "fcl_319a",
    "fcl_375",
    "fcl_390b",
    "fcl_391",
    "fcl_395",
    "fcl_398",
    "fcl_399",
    "fcl_415a",
    "fcl_428",
    "fcl_493",
    "fcl_495",
    "fcl_508y",
    "fcl_508z",
    "fcl_529",
    "fcl_529_mpr",
    "fcl_545",
    "fcl_545b",
    "fcl_568",
    "fcl_568_indep",
    "fcl_623",
    "jolt_1008",
    "jolt_tri_capsule",
    "jolt_tri_capsule2",
    "mj_2206",
    "mj_2206cap",
    "mj_7942fe95_bad0",
    "mj_fb07_1",
    "mj_longbox",
    "mjw_657",
    "ncollide_157_fcl",
    "ode_parry70",
    "ode_parry70b",
    "parry_253",
    "pyfcl_68",
};

TEST(Zoo, ContainsEveryReportedContactCase) {
  std::set<std::string> names;
  for (const auto& [id, scenario] : Below(kZoo)) names.insert(id.substr(kZoo.size()));
  EXPECT_EQ(names, kAsked);
}

TEST(Zoo, ContainsEveryReportedCaseOfMotion) {
  constexpr std::string_view kWorldZoo = "world/zoo/";
  std::set<std::string> names;
  for (const WorldScenario& world : TheCatalogue().worlds) {
    if (world.id.starts_with(kWorldZoo)) names.insert(world.id.substr(kWorldZoo.size()));
  }
  EXPECT_EQ(names, kAskedOfMotion);
}

TEST(Zoo, ListsTheOmittedCasesInTheDocument) {
  std::ifstream file(InSourceTree("docs/catalogue.md"));
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  for (const std::string& name : kNotAsked)
    EXPECT_THAT(text, HasSubstr("`" + name + "`"));
}

TEST(Zoo, LinksEveryCaseToItsThreadOrFile) {
  for (const auto& [id, scenario] : Below(kZoo)) {
    EXPECT_THAT(scenario->source,
                ContainsRegex("[A-Za-z-]+/[A-Za-z0-9_-]+[#:@][A-Za-z0-9]+"))
        << id;
  }
}

TEST(Zoo, KeepsEveryPoseAsAMatrix) {
  for (const auto& [id, scenario] : Below(kZoo)) {
    EXPECT_FALSE(scenario->contact.A.X_WB.q_WB.has_value()) << id;
    EXPECT_FALSE(scenario->contact.B.X_WB.q_WB.has_value()) << id;
  }
}

TEST(Zoo, IndictsOnlyKnownOracles) {
  const std::set<std::string> oracles = {"fcl/collide",
                                         "fcl/collide_indep",
                                         "fcl/distance",
                                         "fcl/distance_indep",
                                         "fcl/signed_distance",
                                         "fcl/signed_distance_indep",
                                         "bullet",
                                         "bullet/gjk",
                                         "bullet_float",
                                         "bullet_float/gjk",
                                         "dart",
                                         "mujoco",
                                         "ode",
                                         "libccd/epa",
                                         "libccd/mpr"};
  std::set<std::string> indicted;
  for (const auto& [id, scenario] : Below(kZoo)) {
    for (const Indictment& indictment : scenario->indicts) {
      indicted.insert(indictment.oracle);
      EXPECT_FALSE(indictment.anomaly.empty()) << id;
    }
  }
  EXPECT_THAT(oracles, IsSupersetOf(indicted));
  EXPECT_FALSE(indicted.empty());
}

TEST(Zoo, IndictsAnOracleInEveryCaseExceptTheOneAboutAnEngineThatIsNotTested) {
  for (const auto& [id, scenario] : Below(kZoo)) {
    EXPECT_EQ(scenario->indicts.empty(), id == "contact/zoo/parry_253") << id;
  }
}

}  // namespace
}  // namespace touchstone
