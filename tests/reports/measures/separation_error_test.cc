#include "reports/measures/separation_error.h"

#include <cmath>

#include <gtest/gtest.h>

namespace touchstone {
namespace {

ContactTruth Truth(double lo, double hi) {
  ContactTruth truth;
  truth.separation = {lo, hi};
  return truth;
}

TEST(SeparationError, OfAHalvedDepthIsHalfTheDepth) {
  EXPECT_DOUBLE_EQ(SeparationError(Truth(-0.02, -0.02), -0.01), 0.01);
}

TEST(SeparationError, OfASwappedSignIsTwiceTheDepth) {
  EXPECT_DOUBLE_EQ(SeparationError(Truth(-0.02, -0.02), 0.02), 0.04);
}

TEST(SeparationError, IsNoneAnywhereInsideTheEnclosure) {
  for (const double separation : {-0.03, -0.021, -0.01}) {
    EXPECT_EQ(SeparationError(Truth(-0.03, -0.01), separation), 0);
  }
}

TEST(SeparationError, CountsFromTheNearerEndOfTheEnclosure) {
  // A difference of numbers near 0.035 is off by at most half their last bits, 2^-57.
  EXPECT_NEAR(SeparationError(Truth(-0.03, -0.01), -0.035), 0.005, 0x1p-57);
  EXPECT_EQ(SeparationError(Truth(-0.03, -0.01), 0.0), 0.01);
}

TEST(SeparationError, OfNanIsNanWhichNoToleranceAdmits) {
  EXPECT_TRUE(std::isnan(SeparationError(Truth(-0.03, -0.01), NAN)));
}

}  // namespace
}  // namespace touchstone
