#pragma once

#include <cmath>
#include <limits>

#include <boost/multiprecision/mpfr.hpp>

namespace touchstone::referee {

/** The high-precision real: 257 bits, rounded to nearest. The product of two doubles is
 exact in it, and the sum of such products almost always. */
using Precise = boost::multiprecision::number<
    boost::multiprecision::mpfr_float_backend<77, boost::multiprecision::allocate_stack>,
    boost::multiprecision::et_off>;

/** Bound on the relative error of one operation in the arithmetic of `Real`. [-] */
template <typename Real>
inline constexpr double kRoundoff = 0x1p-53;
template <>
inline constexpr double kRoundoff<Precise> = 0x1p-256;
static_assert(std::numeric_limits<Precise>::digits >= 256);

/** Returns a double no smaller than |x| and at most twice as large; infinity if x is not
 finite. */
inline double Magnitude(double x) {
  return std::abs(x);
}
inline double Magnitude(const Precise& x) {
  const auto& data = x.backend().data();
  if (mpfr_regular_p(data)) {
    return std::ldexp(1.0, static_cast<int>(mpfr_get_exp(data)));
  }
  return mpfr_zero_p(data) ? 0 : std::numeric_limits<double>::infinity();
}

inline bool IsNan(double x) {
  return std::isnan(x);
}
inline bool IsNan(const Precise& x) {
  return mpfr_nan_p(x.backend().data()) != 0;
}

/** Tells whether the operations in `Real` since its construction were all exact. Always
 false for doubles, whose inexact operations are not detected. */
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
inline double Nearest(const Precise& x) {
  return mpfr_get_d(x.backend().data(), MPFR_RNDN);
}

/** Returns a double at most `x - error`. */
inline double Below(double x, double error) {
  return error == 0 ? x
                    : std::nextafter(x - error, -std::numeric_limits<double>::infinity());
}
inline double Below(Precise x, double error) {
  mpfr_sub_d(x.backend().data(), x.backend().data(), error, MPFR_RNDD);
  return mpfr_get_d(x.backend().data(), MPFR_RNDD);
}

}  // namespace touchstone::referee
