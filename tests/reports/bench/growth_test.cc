#include "reports/bench/growth.h"

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace touchstone {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

// A time of 0.7 n^k µs.
TimeOfSize OnPowerLaw(const std::string& oracle, int bodies, double k) {
  return {oracle, bodies, 0.7 * std::pow(bodies, k)};
}

TEST(GrowthExponent, IsTheExponentOfAPowerLawInEitherOrderOfSizes) {
  for (const double k : {-0.5, 0.0, 1.0, 1.12, 3.0}) {
    const TimeOfSize less = OnPowerLaw("x", 700, k);
    const TimeOfSize greater = OnPowerLaw("x", 30000, k);
    // Each time has a relative error of a few roundings, and so the logarithm of their
    // ratio an absolute error of that size. The logarithm of the ratio of the sizes
    // is 3.8.
    EXPECT_NEAR(GrowthExponent(less, greater), k, 1e-14);
    EXPECT_NEAR(GrowthExponent(greater, less), k, 1e-14);
  }
}

TEST(GrowthExponent, IsThreeHalvesForEightTimesTheTimeAndFourTimesTheSize) {
  // 4^1.5 = 8.
  EXPECT_NEAR(GrowthExponent({"x", 100, 3}, {"x", 400, 24}), 1.5, 1e-15);
}

// "bent" grows linearly to 1,000, quadratically to 10,000, then linearly again.
TEST(GrowthTable, HasNeighbouringSizesAndTheWholeRangeFromAThousandOn) {
  std::vector<TimeOfSize> times;
  for (const auto& [bodies, time] :
       {std::pair{100, 1.0}, {1000, 10.0}, {10000, 1000.0}, {30000, 3000.0}}) {
    times.push_back({"bent", bodies, time});
    times.push_back(OnPowerLaw("straight", bodies, 1.25));
  }
  // ln(300)/ln(30) = 1.677.
  EXPECT_EQ(GrowthTable("boxes", times), R"(growth of µs/step with the number n of boxes
  oracle                        100 to 1,000   1,000 to 10,000  10,000 to 30,000   1,000 to 30,000
  bent                                n^1.00            n^2.00            n^1.00            n^1.68
  straight                            n^1.25            n^1.25            n^1.25            n^1.25
)");
}

TEST(GrowthTable, OmitsTheWholeRangeOfTwoSizesAndTimesOfStoppedOracles) {
  const std::vector<TimeOfSize> times = {
      OnPowerLaw("whole", 100, 1), OnPowerLaw("stopped", 100, 1),
      OnPowerLaw("whole", 1000, 1), OnPowerLaw("stopped", 1000, 1),
      OnPowerLaw("whole", 10000, 1)};
  EXPECT_THAT(
      GrowthTable("boxes", times),
      AllOf(
          HasSubstr("1,000 to 10,000\n"),
          HasSubstr("  whole                               n^1.00            n^1.00\n"),
          HasSubstr("  stopped                             n^1.00                 -\n")));
}

TEST(GrowthTable, IsEmptyIfNoOracleHasTwoSizes) {
  EXPECT_EQ(GrowthTable("boxes", std::vector<TimeOfSize>{}), "");
  const std::vector<TimeOfSize> times = {OnPowerLaw("a", 100, 1),
                                         OnPowerLaw("b", 1000, 1)};
  EXPECT_EQ(GrowthTable("boxes", times), "");
}

}  // namespace
}  // namespace touchstone
