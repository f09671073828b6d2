#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "tests/catalogue/the_catalogue.h"

namespace touchstone {
namespace {

/** Returns the bounding radius of the smaller body, the unit for depths. [m] */
double SmallerRadius(const ContactQuery& query) {
  const double a = BoundingRadius(query.A.shape);
  const double b = BoundingRadius(query.B.shape);
  if (KindOf(query.A.shape) == ShapeKind::kHalfSpace) return b;
  if (KindOf(query.B.shape) == ShapeKind::kHalfSpace) return a;
  return std::min(a, b);
}

int CountIn(const std::vector<const Scenario*>& scenarios, double lo, double hi) {
  return static_cast<int>(std::count_if(
      scenarios.begin(), scenarios.end(), [lo, hi](const Scenario* scenario) {
        const double share =
            *scenario->expect.separation / SmallerRadius(scenario->contact);
        return lo <= share && share <= hi;
      }));
}

TEST(CatalogueCoverage, HasAtLeastThreeHundredContactScenarios) {
  EXPECT_GE(Below("contact/").size(), 300u);
}

TEST(CatalogueCoverage, HasTheTwentySevenPairs) {
  EXPECT_EQ(ByPairFolder().size(), 27u);
}

TEST(CatalogueCoverage, HasEveryPairAtLeastSixTimes) {
  for (const auto& [pair, scenarios] : ByPairFolder()) {
    EXPECT_GE(scenarios.size(), 6u) << pair;
  }
}

TEST(CatalogueCoverage, HasThePairsOfTheCookbookMostOften) {
  EXPECT_GE(ByPairFolder().at("sphere_sphere").size(), 14u);
  EXPECT_GE(ByPairFolder().at("sphere_box").size(), 20u);
  EXPECT_GE(ByPairFolder().at("box_box").size(), 40u);
}

// Separations are fractions of the smaller body's radius.
TEST(CatalogueCoverage, HasEveryPairSeparatedTouchingShallowAndDeep) {
  constexpr double kShallow = 0.05;
  constexpr double kDeep = 0.5;
  constexpr double kAnything = 1e300;
  for (const auto& [pair, scenarios] : ByPairFolder()) {
    EXPECT_GT(CountIn(scenarios, 1e-12, kAnything), 0) << pair << ": separated";
    EXPECT_GT(CountIn(scenarios, 0, 0), 0) << pair << ": touching";
    EXPECT_GT(CountIn(scenarios, -kShallow, -1e-12), 0) << pair << ": shallow";
    EXPECT_GT(CountIn(scenarios, -kAnything, -kDeep), 0) << pair << ": deep";
  }
}

TEST(CatalogueCoverage, HasEveryPairInBothOrders) {
  for (const auto& [pair, scenarios] : ByPairFolder()) {
    EXPECT_TRUE(std::any_of(
        scenarios.begin(), scenarios.end(),
        [](const Scenario* scenario) { return scenario->id.ends_with("_swapped"); }))
        << pair;
  }
}

TEST(CatalogueCoverage, HasTwoScenariosForEveryContactErratum) {
  for (const char* erratum :
       {"e01", "e02", "e03", "e04", "e05", "e06", "e07", "e08", "e09", "e26"}) {
    EXPECT_GE(Below("contact/errata/" + std::string(erratum) + "_").size(), 2u)
        << erratum;
  }
}

}  // namespace
}  // namespace touchstone
