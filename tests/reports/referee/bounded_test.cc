// Tests of the arithmetic that every proof uses.

#include "reports/referee/bounded.h"

#include <cmath>
#include <limits>
#include <vector>

#include <boost/multiprecision/gmp.hpp>
#include <gtest/gtest.h>

#include "tests/reports/referee/random_scene.h"

namespace touchstone::referee {
namespace {

using Rational = boost::multiprecision::mpq_rational;

template <typename Real>
bool Holds(const Bounded<Real>& number, const Rational& exact) {
  const Enclosure e = number.enclosure();
  return Rational(e.lo) <= exact && exact <= Rational(e.hi);
}

/** Returns one polynomial and quotient of awkward magnitudes, in any arithmetic. */
template <typename T>
T Expression(const T& a, const T& b, const T& c, const T& d) {
  return (a * b - c * d) / (a * a + b * b) + (a - c) * (b + d);
}

/** Expects enclosures that hold the exact value, although the value alone is wrong. */
template <typename Real>
void ExpectToHoldThroughCancellation() {
  RandomScene random(1);
  int missed_without_bound = 0;
  for (int i = 0; i < 2000; ++i) {
    const double a = random.Uniform(-1, 1) * random.Power(-8, 8);
    const double b = random.Uniform(-1, 1) * random.Power(-8, 8);
    // These are so near that the differences lose almost all digits.
    const double c = a * (1 + random.Uniform(-1, 1) * random.Power(-17, -1));
    const double d = -b * (1 + random.Uniform(-1, 1) * random.Power(-17, -1));
    using Number = Bounded<Real>;
    const Number computed = Expression(Number(a), Number(b), Number(c), Number(d));
    const Rational exact = Expression(Rational(a), Rational(b), Rational(c), Rational(d));
    EXPECT_TRUE(Holds(computed, exact)) << a << " " << b << " " << c << " " << d;
    // The error bound is what makes it pass: without it the value alone is wrong.
    missed_without_bound += !Holds(Number(computed.value()), exact);
  }
  EXPECT_GT(missed_without_bound, 1900);
}

TEST(Bounded, HoldsTheExactValueThroughCancellation) {
  ExpectToHoldThroughCancellation<double>();
}

TEST(NextBelow, IsThatOfTheLibrary) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  RandomScene random(3);
  std::vector<double> all = {0.0, -0.0, 1.0, -1.0, 0x1p-1022, -0x1p-1022, kInfinity};
  for (const double x :
       {std::numeric_limits<double>::denorm_min(), std::numeric_limits<double>::max()}) {
    all.push_back(x);
    all.push_back(-x);
  }
  for (int i = 0; i < 100; ++i)
    all.push_back(random.Uniform(-1, 1) * random.Power(-300, 300));
  for (const double x : all) EXPECT_EQ(NextBelow(x), std::nextafter(x, -kInfinity)) << x;
  EXPECT_EQ(NextBelow(-kInfinity), -kInfinity);
  EXPECT_TRUE(std::isnan(NextBelow(std::numeric_limits<double>::quiet_NaN())));
}

TEST(Bounded, HoldsTheRootOfAnUncertainNumber) {
  RandomScene random(2);
  for (int i = 0; i < 2000; ++i) {
    const double root = random.Power(-10, 3);
    const Rational square = Rational(root) * Rational(root);
    const double off = random.Uniform(-1, 1) * random.Power(-25, 2);
    // Two roundings, each of at most 2^-53 of root² + |off|.
    const Bounded<double> computed(root * root + off,
                                   std::abs(off) * (1 + 0x1p-51) + root * root * 0x1p-51);
    EXPECT_TRUE(Holds(Sqrt(computed), Rational(root)));
  }
}

TEST(Bounded, IsUnboundedForAQuotientByAPossibleZero) {
  const Bounded<double> quotient = Bounded<double>(1.0) / Bounded<double>(1e-17, 2e-17);
  EXPECT_EQ(quotient.enclosure().lo, -INFINITY);
  EXPECT_EQ(quotient.enclosure().hi, INFINITY);
}

template <typename Number>
void ExpectUnknown(const Number& number) {
  EXPECT_EQ(number.enclosure().lo, -INFINITY);
  EXPECT_EQ(number.enclosure().hi, INFINITY);
}

template <typename Number>
void ExpectOverflowToBeUnknown() {
  const Number infinite(std::numeric_limits<double>::infinity());
  const Number nothing = infinite - infinite;
  const Number one(1.0);
  ExpectUnknown(nothing);
  ExpectUnknown(Number(NAN));
  ExpectUnknown(Number(0.0) * infinite);
  ExpectUnknown(one + nothing);
  ExpectUnknown(one / nothing);
  ExpectUnknown(-Abs(nothing));
  // The order does not matter: a comparison with a NaN must not select the other.
  ExpectUnknown(Max(one, nothing));
  ExpectUnknown(Max(nothing, one));
  ExpectUnknown(Min(one, nothing));
  ExpectUnknown(Min(nothing, one));
  EXPECT_EQ(Sqrt(nothing).enclosure().hi, INFINITY);
}

TEST(Bounded, IsUnboundedAfterAnOverflow) {
  ExpectOverflowToBeUnknown<Bounded<double>>();
  ExpectOverflowToBeUnknown<Bounded<DoubleDouble>>();
  ExpectOverflowToBeUnknown<Bounded<Precise>>();
  const Bounded<double> large(1e200, 1e190);
  ExpectUnknown(large * large - large * large);
  ExpectUnknown(Max(Bounded<double>(1.0), large * large));
}

TEST(Bounded, EnclosesAThirdBetweenNeighbouringDoublesInHighPrecision) {
  using Number = Bounded<Precise>;
  const Number third = Number(1.0) / Number(3.0);
  EXPECT_LT(third.enclosure().lo, third.enclosure().hi);
  EXPECT_EQ(std::nextafter(third.enclosure().lo, 1), third.enclosure().hi);
}

// Every operation here is exact in 257 bits, though not in a double.
TEST(Bounded, KnowsAnExactResultOfHighPrecisionExactly) {
  using Number = Bounded<Precise>;
  const Number a(0.1);
  const Number b(0x1p-60);
  EXPECT_EQ((a * a + b - a * a).error(), 0);
  EXPECT_EQ((a * a + b - a * a).value(), 0x1p-60);
  EXPECT_EQ((a * b / b).error(), 0);
  EXPECT_EQ(Sqrt(a * a).error(), 0);
  EXPECT_EQ(((a - a) / Sqrt(a)).error(), 0);  // Zero, whatever the root is.
}

TEST(Bounded, BoundsTheRoundingOfHighPrecision) {
  using Number = Bounded<Precise>;
  const Number one(1.0);
  EXPECT_GT((one / Number(3.0)).error(), 0);
  EXPECT_GT(Sqrt(Number(2.0)).error(), 0);
  EXPECT_GT((one + Number(0x1p-300)).error(), 0);
  EXPECT_GT((Number(0.1) * Number(0.1) * Number(0.1) * Number(0.1) * Number(0.1)).error(),
            0);
  // An exact operation carries the errors of its operands.
  EXPECT_GE((one + Number(Precise(1), 0x1p-20)).error(), 0x1p-20);
  EXPECT_GE((one * Number(Precise(1), 0x1p-20)).error(), 0x1p-20);
}

TEST(Bounded, RoundsAnExactNumberToItself) {
  const Enclosure e = Bounded<Precise>(0.1).enclosure();
  EXPECT_EQ(e.lo, 0.1);
  EXPECT_EQ(e.hi, 0.1);
}

}  // namespace
}  // namespace touchstone::referee
