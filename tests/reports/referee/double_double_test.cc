// Tests of the double-double arithmetic and of its error bounds, against rationals.

#include "reports/referee/double_double.h"

#include <cmath>
#include <limits>

#include <boost/multiprecision/gmp.hpp>
#include <gtest/gtest.h>

#include "reports/referee/bounded.h"
#include "tests/reports/referee/random_scene.h"

namespace touchstone::referee {
namespace {

using Rational = boost::multiprecision::mpq_rational;

Rational Exact(const DoubleDouble& x) {
  return Rational(x.hi()) + Rational(x.lo());
}

/** Returns |x − exact| in units of the last of 100 bits of `exact`. */
double Roundings(const DoubleDouble& x, const Rational& exact) {
  if (exact == 0) return x == 0 ? 0 : std::numeric_limits<double>::infinity();
  const Rational relative = abs(Rational((Exact(x) - exact) / exact));
  return static_cast<double>(relative) / kRoundoff<DoubleDouble>;
}

/** Returns a number with two random parts. The second is as large as it may be, or far
 smaller. */
DoubleDouble AnyNumber(RandomScene& random, int least, int most) {
  const double hi = random.Uniform(-1, 1) * random.Power(least, most);
  const double lo = hi * 0x1p-54 * random.Uniform(-1, 1) * random.Power(-9, 0);
  return DoubleDouble::TwoSum(hi, lo);
}

bool IsNormalised(const DoubleDouble& x) {
  return x.hi() + x.lo() == x.hi();
}

TEST(DoubleDouble, ErrsByLessThanItsRoundoff) {
  RandomScene random(1);
  double worst = 0;
  for (int i = 0; i < 20000; ++i) {
    const DoubleDouble a = AnyNumber(random, -9, 9);
    // Nearly equal numbers cancel all but the last digits of a sum.
    const bool is_near = i % 2 == 0;
    const DoubleDouble b =
        is_near ? DoubleDouble::TwoSum(-a.hi(), a.lo() * random.Uniform(-1, 1))
                : AnyNumber(random, -9, 9);
    for (const auto& [computed, exact] :
         {std::pair<DoubleDouble, Rational>{a + b, Exact(a) + Exact(b)},
          {a - b, Exact(a) - Exact(b)},
          {a * b, Exact(a) * Exact(b)},
          {a / b, Exact(a) / Exact(b)}}) {
      EXPECT_TRUE(IsNormalised(computed));
      const double roundings = Roundings(computed, exact);
      EXPECT_LE(roundings, 15.1 / 64);
      worst = std::max(worst, roundings);
    }
  }
  EXPECT_GT(worst, 1.0 / 64);  // The numbers are hard enough to be rounded.
}

TEST(DoubleDouble, TakesRootsWithinItsRoundoff) {
  RandomScene random(2);
  for (int i = 0; i < 20000; ++i) {
    const DoubleDouble a = abs(AnyNumber(random, -9, 9));
    const DoubleDouble root = sqrt(a);
    // |r² − a| / a is twice the relative error of r, and a little more.
    const Rational square = Exact(root) * Exact(root);
    EXPECT_LE(Roundings(root * 1, Exact(root)), 0);
    const Rational relative = abs(Rational((square - Exact(a)) / Exact(a)));
    EXPECT_LE(static_cast<double>(relative), 2.01 * 3.125 * 0x1p-106);
  }
}

TEST(DoubleDouble, MultipliesAndAddsDoublesExactlyWhereTheyFit) {
  RandomScene random(3);
  for (int i = 0; i < 5000; ++i) {
    const double a = random.Uniform(-1, 1) * random.Power(-9, 9);
    const double b = random.Uniform(-1, 1) * random.Power(-9, 9);
    EXPECT_EQ(Exact(DoubleDouble(a) * b), Rational(a) * Rational(b));
    EXPECT_EQ(Exact(DoubleDouble(a) + b), Rational(a) + Rational(b));
    // A difference of products is zero only if it is zero in truth.
    const double c = std::nextafter(a, 2);
    EXPECT_FALSE(DoubleDouble(a) * b - DoubleDouble(c) * b == 0);
    EXPECT_TRUE(DoubleDouble(a) * b - DoubleDouble(b) * a == 0);
  }
}

TEST(DoubleDouble, IsNoNumberWhereItsRootsAndQuotientsLoseDigits) {
  EXPECT_TRUE(IsNan(DoubleDouble(1) / 0x1p-901));
  EXPECT_TRUE(IsNan(DoubleDouble(0x1p-901) / 3));
  EXPECT_TRUE(IsNan(DoubleDouble(1) / 0));
  EXPECT_TRUE(IsNan(DoubleDouble(1) / 0x1p901));
  EXPECT_TRUE(IsNan(sqrt(DoubleDouble(0x1p-901))));
  EXPECT_TRUE(IsNan(sqrt(DoubleDouble(-1))));
  EXPECT_EQ(DoubleDouble(0) / 3, 0);
  EXPECT_EQ(sqrt(DoubleDouble(0)), 0);
}

TEST(DoubleDouble, LosesNoMoreToUnderflowThanIsGranted) {
  RandomScene random(4);
  int lossy = 0;
  for (int i = 0; i < 5000; ++i) {
    const DoubleDouble a = AnyNumber(random, -165, -150);
    const DoubleDouble b = AnyNumber(random, -165, -150);
    const Bounded<DoubleDouble> product =
        Bounded<DoubleDouble>(a) * Bounded<DoubleDouble>(b);
    const Rational off = abs(Rational(Exact(product.value()) - Exact(a) * Exact(b)));
    EXPECT_LE(off, Rational(kUnderflow<DoubleDouble>));
    EXPECT_LE(off, Rational(product.error()));
    lossy += off > 0;
  }
  EXPECT_GT(lossy, 2500);
}

TEST(DoubleDouble, IsRoundedDownToTheNextDouble) {
  RandomScene random(5);
  int inexact = 0;
  for (int i = 0; i < 20000; ++i) {
    const DoubleDouble x = AnyNumber(random, -9, 9);
    const double error = i % 3 == 0 ? 0 : std::abs(x.hi()) * random.Power(-40, 1);
    const double below = Below(x, error);
    const Rational exact = Exact(x) - Rational(error);
    EXPECT_LE(Rational(below), exact);
    // Two exact sums are each rounded down: no more than two doubles are lost.
    const double above = std::nextafter(std::nextafter(below, INFINITY), INFINITY);
    EXPECT_GT(Rational(above), exact);
    inexact += Rational(below) != exact;
  }
  EXPECT_GT(inexact, 10000);
}

TEST(DoubleDouble, IsNoLargerThanItsMagnitude) {
  RandomScene random(6);
  for (int i = 0; i < 5000; ++i) {
    const DoubleDouble x = AnyNumber(random, -320, 9);
    EXPECT_LE(abs(Exact(x)), Rational(Magnitude(x)));
    EXPECT_GE(2 * abs(Exact(x)), Rational(Magnitude(x)));
  }
}

// 1/7 is no double, and its neighbours enclose it.
TEST(DoubleDouble, EnclosesAFractionBetweenNeighbouringDoubles) {
  using Number = Bounded<DoubleDouble>;
  const Enclosure e = (Number(1.0) / Number(7.0)).enclosure();
  EXPECT_LT(Rational(e.lo), Rational(1) / 7);
  EXPECT_GT(Rational(e.hi), Rational(1) / 7);
  EXPECT_EQ(std::nextafter(e.lo, 1), e.hi);
}

}  // namespace
}  // namespace touchstone::referee
