#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include <boost/multiprecision/mpfr.hpp>

#include "reports/referee/double_double.h"

namespace touchstone::referee {

/** The high-precision real, where double-double has too few digits: 257 bits, rounded to
 nearest. The product of two doubles is exact in it, and the sum of such products almost
 always. */
using Precise = boost::multiprecision::number<
    boost::multiprecision::mpfr_float_backend<77, boost::multiprecision::allocate_stack>,
    boost::multiprecision::et_off>;

/** Bound on the relative error of one operation in the arithmetic of `Real`. [-] */
template <typename Real>
inline constexpr double kRoundoff = 0x1p-53;
template <>
inline constexpr double kRoundoff<DoubleDouble> = 0x1p-100;
template <>
inline constexpr double kRoundoff<Precise> = 0x1p-256;
static_assert(std::numeric_limits<Precise>::digits >= 256);

/** Bound on the absolute error that an operation adds where it underflows. A product of
 doubles loses at most half the least of them. In `DoubleDouble` a product is the sum of
 seven products, each of which can underflow. */
template <typename Real>
inline constexpr double kUnderflow = 4 * std::numeric_limits<double>::denorm_min();
template <>
inline constexpr double kUnderflow<DoubleDouble> = 0x1p-1060;

/** Returns a double no smaller than |x| and at most twice as large; infinity if x is not
 finite. */
inline double Magnitude(double x) {
  return std::abs(x);
}
inline double Magnitude(const DoubleDouble& x) {
  // The rest is at most half a rounding. The factor adds a whole one.
  return std::abs(x.hi()) * (1 + std::numeric_limits<double>::epsilon());
}
inline double Magnitude(const Precise& x) {
  const auto& data = x.backend().data();
  if (mpfr_regular_p(data)) {
    // The power underflows to zero, which the number is not.
    return std::max(std::ldexp(1.0, static_cast<int>(mpfr_get_exp(data))),
                    std::numeric_limits<double>::denorm_min());
  }
  return mpfr_zero_p(data) ? 0 : std::numeric_limits<double>::infinity();
}

inline bool IsNan(double x) {
  return std::isnan(x);
}
inline bool IsNan(const DoubleDouble& x) {
  return std::isnan(x.hi()) || std::isnan(x.lo());
}
inline bool IsNan(const Precise& x) {
  return mpfr_nan_p(x.backend().data()) != 0;
}

/** Tells whether the operations in `Real` since its construction were all exact. Only
 MPFR detects it; otherwise always false. */
template <typename Real>
class Exactness {
 public:
  bool Holds() const { return false; }
};
template <>
class Exactness<Precise> {
 public:
  Exactness() { mpfr_clear_inexflag(); }  // A flag of this thread.
  bool Holds() const { return mpfr_inexflag_p() == 0; }
};

/** Returns the double nearest to `x`. */
inline double Nearest(double x) {
  return x;
}
inline double Nearest(const DoubleDouble& x) {
  return x.hi();
}
inline double Nearest(const Precise& x) {
  return mpfr_get_d(x.backend().data(), MPFR_RNDN);
}

/** Returns the double next below `x`, x itself if there is none: std::nextafter() without
 a call. Without their signs the bits of doubles count up as the doubles do. */
inline double NextBelow(double x) {
  const auto bits = std::bit_cast<std::int64_t>(x);
  if (x > 0) return std::bit_cast<double>(bits - 1);
  if (x == 0) return -std::numeric_limits<double>::denorm_min();
  return x >= std::numeric_limits<double>::lowest() ? std::bit_cast<double>(bits + 1) : x;
}

/** Returns a double at most `x - error`. */
inline double Below(double x, double error) {
  return error == 0 ? x : NextBelow(x - error);
}
inline double Below(const DoubleDouble& x, double error) {
  // Both sums are exact, and what their second parts lack from below is rounded down.
  const auto round_down = [](const DoubleDouble& sum) {
    return sum.lo() < 0 ? NextBelow(sum.hi()) : sum.hi();
  };
  const DoubleDouble first = DoubleDouble::TwoSum(x.hi(), -error);
  const double rest = round_down(DoubleDouble::TwoSum(first.lo(), x.lo()));
  const double below = round_down(DoubleDouble::TwoSum(first.hi(), rest));
  // A sum that overflows has no second part.
  return std::isnan(below) ? -std::numeric_limits<double>::infinity() : below;
}
inline double Below(Precise x, double error) {
  mpfr_sub_d(x.backend().data(), x.backend().data(), error, MPFR_RNDD);
  return mpfr_get_d(x.backend().data(), MPFR_RNDD);
}

}  // namespace touchstone::referee
