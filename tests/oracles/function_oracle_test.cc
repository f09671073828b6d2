#include "oracles/function_oracle.h"

#include <limits>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace touchstone {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

std::unique_ptr<Oracle> Routine(const Promises& promises) {
  return MakeOracle(
      "mine", {{ShapeKind::kBox, ShapeKind::kBox}},
      [](const ContactQuery&) { return ContactAnswer(); }, promises);
}

TEST(MakeOracle, ComputesInDoubleAndIsGrantedNothingUnlessItSaysSo) {
  const auto oracle = Routine({});
  EXPECT_EQ(oracle->info().unit_roundoff, 0x1p-53);
  EXPECT_TRUE(oracle->info().tolerance.IsZero());
  for (const Setting& setting : oracle->info().settings)
    EXPECT_NE(setting.name, "tolerance");
}

TEST(MakeOracle, ComputesInFloatIfItSaysSo) {
  EXPECT_EQ(Routine({.precision = Precision::kFloat})->info().unit_roundoff, 0x1p-24);
}

TEST(MakeOracle, ShowsAStatedToleranceWithItsOrigin) {
  const auto oracle = Routine(
      {.tolerance = {.length = 1e-4, .share = 1e-6}, .documented_by = "section 4"});
  EXPECT_EQ(oracle->info().tolerance.length, 1e-4);
  EXPECT_EQ(oracle->info().tolerance.share, 1e-6);
  EXPECT_EQ(oracle->info().tolerance.by, "section 4");
  const Setting& shown = oracle->info().settings.back();
  EXPECT_EQ(shown.name, "tolerance");
  EXPECT_EQ(shown.value, "0.0001 m and 1e-06 of the scene's size");
  EXPECT_THAT(shown.why, HasSubstr("stated by section 4"));
}

TEST(MakeOracle, RefusesAToleranceThatNobodyStatesOrThatIsNoLength) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(Routine({.tolerance = {.length = 1e-4}}), std::invalid_argument);
  EXPECT_THROW(Routine({.tolerance = {.share = 1e-4}}), std::invalid_argument);
  for (const double part : {-1e-4, kInfinity, kNan}) {
    EXPECT_THROW(Routine({.tolerance = {.length = part}, .documented_by = "me"}),
                 std::invalid_argument);
    EXPECT_THROW(Routine({.tolerance = {.share = part}, .documented_by = "me"}),
                 std::invalid_argument);
  }
}

TEST(WithTolerance, ReplacesTheToleranceAndKeepsTheAnswers) {
  const auto mine =
      Routine({.tolerance = {.length = 1e-4}, .documented_by = "section 4"});
  const auto granted = WithTolerance(*mine, {.share = 1e-3, .by = "the test"});
  EXPECT_EQ(granted->info().name, "mine");
  EXPECT_EQ(granted->info().tolerance.length, 0);
  EXPECT_EQ(granted->info().tolerance.share, 1e-3);
  int shown = 0;
  for (const Setting& setting : granted->info().settings)
    shown += setting.name == "tolerance";
  EXPECT_EQ(shown, 1);
  const ContactQuery query{{Box{{1, 1, 1}}, {}}, {Box{{1, 1, 1}}, {}}};
  EXPECT_EQ(granted->Answer(query).status, mine->Answer(query).status);
  EXPECT_EQ(mine->info().tolerance.length, 1e-4);
}

}  // namespace
}  // namespace touchstone
