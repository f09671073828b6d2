#include "reports/text/format_vector.h"

#include <gtest/gtest.h>

namespace touchstone {
namespace {

TEST(FormatVector, WritesTheFewestDigitsThatReadBack) {
  EXPECT_EQ(FormatVector({0.1, -2, 1.0 / 3}), "(0.1, -2, 0.3333333333333333)");
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
