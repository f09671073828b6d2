#include "reports/text/told_apart.h"

#include <limits>

#include <gtest/gtest.h>

namespace touchstone {
namespace {

TEST(TellApart, WritesTheRequestedDigitsWhereTheseDiffer) {
  const auto [a, b, difference] = TellApart(0.0134911746, 0.0134086138, 9);
  EXPECT_EQ(a, "0.0134911746");
  EXPECT_EQ(b, "0.0134086138");
  EXPECT_EQ(difference, "8.26e-05");
}

TEST(TellApart, WritesTwoDigitsOfTheDifferenceOfNumbersThatLookEqual) {
  const auto [a, b, difference] = TellApart(0.1, 0.1 + 1.25e-13, 9);
  EXPECT_EQ(a, "0.1");
  EXPECT_EQ(b, "0.10000000000013");
  EXPECT_EQ(difference, "1.25e-13");
}

TEST(TellApart, DistinguishesNeighbouringDoubles) {
  const double one_up = 0.3 * (1 + std::numeric_limits<double>::epsilon());
  const auto [a, b, difference] = TellApart(0.3, one_up, 9);
  EXPECT_NE(a, b);
  EXPECT_NE(difference, "0");
}

TEST(TellApart, WritesTwoDigitsOfTheDifferenceOfVectorsThatLookEqual) {
  const Eigen::Vector3d a{-0.0003, 3.5e-05, -0.031};
  const auto told = TellApart(a, Eigen::Vector3d(a + Eigen::Vector3d{0, 0, 3.5e-14}), 9);
  EXPECT_EQ(told.a, "(-0.0003, 3.5e-05, -0.031)");
  EXPECT_EQ(told.b, "(-0.0003, 3.5e-05, -0.030999999999965)");
  EXPECT_EQ(told.difference, "3.5e-14");
}

TEST(TellApart, WritesNumbersWithoutDigits) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(TellApart(kInfinity, 0.1, 9).a, "inf");
  EXPECT_EQ(TellApart(0.1, std::numeric_limits<double>::quiet_NaN(), 9).b, "nan");
  EXPECT_EQ(TellApart(0.25, 0.25, 3).difference, "0");
  EXPECT_EQ(TellApart(0, -1e-300, 3).b, "-1e-300");
}

}  // namespace
}  // namespace touchstone
