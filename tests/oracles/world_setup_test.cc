#include "oracles/world_setup.h"

#include <cmath>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "oracles/function_simulator.h"
#include "oracles/oracle.h"

namespace touchstone {
namespace {

using testing::ElementsAre;

const std::vector<WorldParameter>& Parameters() {
  static const std::vector<WorldParameter> parameters = {{.name = "erp",
                                                          .here = 0,
                                                          .shipped = 0.2,
                                                          .least = 0,
                                                          .most = 1,
                                                          .whole = false,
                                                          .what = "error reduction",
                                                          .why = ""},
                                                         {.name = "iterations",
                                                          .here = 1000,
                                                          .shipped = 10,
                                                          .least = 1,
                                                          .most = 5000,
                                                          .whole = true,
                                                          .what = "iterations",
                                                          .why = ""}};
  return parameters;
}

TEST(WorldSetup, TakesTheValuesOfTheAdapterUnlessShippedOrChosenOnesAreAskedFor) {
  EXPECT_THAT(ValuesOf(Parameters(), {}), ElementsAre(0, 1000));
  EXPECT_THAT(ValuesOf(Parameters(), {.as_shipped = true, .chosen = {}}),
              ElementsAre(0.2, 10));
  EXPECT_THAT(ValuesOf(Parameters(), {.as_shipped = true, .chosen = {{"erp", 0.5}}}),
              ElementsAre(0.5, 10));
  EXPECT_THAT(
      ValuesOf(Parameters(), {.as_shipped = false, .chosen = {{"iterations", 7}}}),
      ElementsAre(0, 7));
}

TEST(WorldSetup, RefusesValuesOutOfRangeAndFractionsOfWholeNumbers) {
  EXPECT_EQ(Refusal(Parameters()[0], 1), "");
  EXPECT_EQ(Refusal(Parameters()[0], 1.01), "a number from 0 to 1");
  EXPECT_EQ(Refusal(Parameters()[0], NAN), "a number from 0 to 1");
  EXPECT_EQ(Refusal(Parameters()[1], 2.5), "a whole number from 1 to 5000");
}

TEST(WorldSetup, SaysWhatIsChosen) {
  EXPECT_EQ(ToString({}, Parameters()), "");
  EXPECT_EQ(ToString({.as_shipped = true, .chosen = {{"erp", 0.5}}}, Parameters()),
            "as shipped, erp = 0.5 (0 as set here, 0.2 as shipped)");
}

// A simulator that always answers: with no parameters, no setup changes it.
TEST(WithSetup, ChangesNothingInAnOracleWithoutSetups) {
  const auto mine = MakeSimulator(
      "mine", [](const World&) -> std::unique_ptr<Simulation> { return nullptr; }, {});
  EXPECT_FALSE(mine->info().HasSetups());
  const auto shipped = mine->SetUp({.as_shipped = true, .chosen = {}});
  EXPECT_EQ(shipped->info().name, "mine");
  EXPECT_TRUE(shipped->info().setup.as_shipped);
}

}  // namespace
}  // namespace touchstone
