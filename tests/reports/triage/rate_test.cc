#include "reports/triage/rate.h"

#include <gtest/gtest.h>

namespace touchstone {
namespace {

// Wilson's interval solves (p − f)² = z² p (1 − p) / n for p.
TEST(Rate, HasAnIntervalWhoseEndsAreOnTheEdgeOfTheTest) {
  constexpr double kZ = 1.959963984540054;
  for (const Rate rate : {Rate{17, 256}, Rate{1, 1000}, Rate{255, 256}}) {
    const auto [lo, hi] = IntervalOf(rate);
    const double f = ShareOf(rate);
    EXPECT_LT(lo, f);
    EXPECT_GT(hi, f);
    const auto n = static_cast<double>(rate.asked);
    for (const double p : {lo, hi})
      EXPECT_NEAR((p - f) * (p - f), kZ * kZ * p * (1 - p) / n, 1e-15);
  }
}

TEST(Rate, StaysWithinZeroAndOne) {
  EXPECT_EQ(IntervalOf({0, 10}).lo, 0);
  EXPECT_GT(IntervalOf({0, 10}).hi, 0.2);
  EXPECT_DOUBLE_EQ(IntervalOf({10, 10}).hi, 1);
  EXPECT_LT(IntervalOf({10, 10}).lo, 0.8);
  EXPECT_EQ(ShareOf(Rate{}), 0);
  EXPECT_EQ(IntervalOf({}).hi, 1);
}

TEST(Rate, SaysCountsAndInterval) {
  EXPECT_EQ(ToString(Rate{17, 256}), "17 of 256, 6.64 % (4.19 % to 10.4 %)");
}

}  // namespace
}  // namespace touchstone
