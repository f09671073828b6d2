#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "oracles/cookbook/cookbook_oracle.h"
#include "oracles/cookbook/printed_oracle.h"
#include "reports/contacts/judge_answer.h"
#include "reports/referee/referee.h"
#include "tests/catalogue/the_catalogue.h"

namespace touchstone {
namespace {

constexpr std::string_view kErrata = "contact/errata/";

/** Returns "E-04" for "contact/errata/e04_full_depth_of_spheres". */
std::string ErratumOf(const Scenario& scenario) {
  return "E-" + scenario.id.substr(kErrata.size() + 1, 2);
}

/** Returns whether `oracle` is proved wrong in `scenario`. */
bool IsWrong(const Oracle& oracle, const Scenario& scenario) {
  const std::vector<Finding> findings =
      JudgeAnswer(scenario, ComputeContactTruth(scenario.contact), oracle.info(),
                  oracle.Answer(scenario.contact));
  return std::any_of(findings.begin(), findings.end(), [](const Finding& finding) {
    return finding.verdict == Verdict::kFail || finding.verdict == Verdict::kInvalid;
  });
}

TEST(ErrataScenarios, ProveTheSpecimenWithOnlyThatErratumWrong) {
  for (const auto& [id, scenario] : Below(kErrata)) {
    const auto specimen = MakePrintedOracle("printed:" + ErratumOf(*scenario));
    ASSERT_NE(specimen, nullptr) << id;
    EXPECT_TRUE(IsWrong(*specimen, *scenario)) << id;
  }
}

TEST(ErrataScenarios, FindNoFaultWithTheCorrectedEngine) {
  const CookbookOracle cookbook;
  for (const auto& [id, scenario] : Below(kErrata)) {
    EXPECT_FALSE(IsWrong(cookbook, *scenario)) << id;
  }
}

}  // namespace
}  // namespace touchstone
