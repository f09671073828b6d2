#include "reports/writers/plot.h"

#include <set>
#include <string>

#include <gtest/gtest.h>

namespace touchstone {
namespace {

TEST(LineClass, IsUniqueForTheSubjectAndOneOfEightForTheOthersPlainOrDashed) {
  EXPECT_EQ(LineClass(0), "line0");
  std::set<std::string> others;
  for (std::size_t oracle = 1; oracle <= 8; ++oracle) others.insert(LineClass(oracle));
  EXPECT_EQ(others, (std::set<std::string>{"line1", "line2", "line3", "line4", "line5",
                                           "line6", "line7", "line8"}));
  for (std::size_t oracle = 9; oracle < 40; ++oracle) {
    EXPECT_EQ(LineClass(oracle), LineClass((oracle - 1) % 8 + 1) + " again");
  }
}

// Neighbours in a table have different colours.
TEST(LineClass, DiffersWithinEight) {
  for (std::size_t oracle = 1; oracle < 40; ++oracle) {
    for (std::size_t next = oracle + 1; next < oracle + 8; ++next) {
      EXPECT_NE(LineClass(oracle), LineClass(next));
    }
  }
}

CurveSet CurveOf(double first, double last) {
  CurveSet set{"energy", "J", MeasureKind::kEnergyDrift, {}, {}};
  Curve& curve = set.of_oracle.emplace_back();
  curve.times = {0.0, 1.0};
  curve.values = {first, last};
  return set;
}

TEST(Plot, LabelsTheExtremesOfItsValues) {
  const std::string plot = Plot(CurveOf(0.5, 0.25), 0);
  EXPECT_NE(plot.find(">0.5</text>"), std::string::npos) << plot;
  EXPECT_NE(plot.find(">0.25</text>"), std::string::npos) << plot;
}

// Otherwise variation by rounding would look like a total loss.
TEST(Plot, LabelsExtremesThatPrintAlikeByTheirDifference) {
  const std::string plot = Plot(CurveOf(0.5, 0.5 - 0x1p-25), 0);
  EXPECT_NE(plot.find(">0.5</text>"), std::string::npos) << plot;
  EXPECT_NE(plot.find(">0.5 − 3e-08</text>"), std::string::npos) << plot;
}

}  // namespace
}  // namespace touchstone
