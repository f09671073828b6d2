#include "reports/text/format_vector.h"

#include <cstdio>

#include <gtest/gtest.h>

namespace touchstone {
namespace {

TEST(FormatVector, WritesTheFewestDigitsThatReadBack) {
  EXPECT_EQ(FormatVector({0.1, -2, 1.0 / 3}), "(0.1, -2, 0.3333333333333333)");
}

// With six digits a point would be 1e-6 off, while its proof speaks of 1e-12.
TEST(FormatVector, ReadsBackExactly) {
  for (const Eigen::Vector3d& v : {Eigen::Vector3d(1.0 / 3, -2e-17, 3e300),
                                   Eigen::Vector3d(0.1 + 0.2, -1 / 7.0, 5)}) {
    Eigen::Vector3d back;
    ASSERT_EQ(std::sscanf(FormatVector(v).c_str(), "(%lf, %lf, %lf)", &back[0], &back[1],
                          &back[2]),
              3);
    EXPECT_EQ(back, v);
  }
}

TEST(FormatVector, WritesAsManyDigitsAsAsked) {
  EXPECT_EQ(FormatVector({1.0 / 3, 1, 2e-7}, 3), "(0.333, 1, 2e-07)");
}

TEST(FormatVector, WritesZeroWithoutASign) {
  EXPECT_EQ(FormatVector({-0.0, 0, -0.0}), "(0, 0, 0)");
  EXPECT_EQ(FormatVector({-0.0, 0, -0.0}, 6), "(0, 0, 0)");
}

}  // namespace
}  // namespace touchstone
