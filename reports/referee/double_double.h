#pragma once

#include <cmath>
#include <limits>

namespace touchstone::referee {

/** A real number as the unevaluated sum of two doubles, hi + lo with |lo| at most half a
 rounding of hi: 106 bits at a tenth of the cost of `Precise`. The product of two doubles
 is exact in it.

 Each operation has a relative error below 15.1 u² with u = 2^-53, for which `kRoundoff`
 (precise.h) allows 2^-100 = 64 u². The algorithms and their bounds are those of Joldes,
 Muller and Popescu, "Tight and rigorous error bounds for basic building blocks of
 double-word arithmetic", ACM TOMS 44 (2017): sums 3 u² + 13 u³ (algorithm 6), products
 7 u² (algorithm 10), quotients 15 u² + 56 u³ (algorithm 17). The root is the one of
 Lefèvre, Louvet, Muller, Picot and Rideau, "Accurate calculation of Euclidean norms using
 double-word arithmetic", ACM TOMS 49 (2023): 25/8 u².

 The bounds hold without overflow and underflow. An overflow gives an infinity or a NaN. A
 sum, and a product that underflows, is off by less than `kUnderflow` in addition. A
 quotient or root of a number below 2^-900 or above 2^900 is a NaN, and so is a quotient
 that is.
 @pre The rounding mode is to nearest. */
class DoubleDouble {
 public:
  DoubleDouble() = default;
  /** Makes a number without error. Implicit, as a double is one of these numbers. */
  DoubleDouble(double exact) : hi_(exact) {}  // NOLINT(google-explicit-constructor)

  double hi() const { return hi_; }  ///< The double nearest to the number.
  double lo() const { return lo_; }  ///< The rest.

  friend DoubleDouble operator-(const DoubleDouble& a) { return {-a.hi_, -a.lo_}; }

  friend DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) {
    const DoubleDouble s = TwoSum(a.hi_, b.hi_);
    const DoubleDouble t = TwoSum(a.lo_, b.lo_);
    const DoubleDouble v = FastTwoSum(s.hi_, s.lo_ + t.hi_);
    return FastTwoSum(v.hi_, t.lo_ + v.lo_);
  }

  friend DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) {
    return a + -b;
  }

  friend DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) {
    const DoubleDouble c = TwoProduct(a.hi_, b.hi_);
    return FastTwoSum(c.hi_, c.lo_ + (a.hi_ * b.lo_ + a.lo_ * b.hi_));
  }

  friend DoubleDouble operator/(const DoubleDouble& a, const DoubleDouble& b) {
    if (!IsInRange(b.hi_)) return std::numeric_limits<double>::quiet_NaN();
    if (a.hi_ == 0) return 0;
    if (!IsInRange(a.hi_)) return std::numeric_limits<double>::quiet_NaN();
    const double quotient = a.hi_ / b.hi_;
    if (!IsInRange(quotient)) return std::numeric_limits<double>::quiet_NaN();
    const DoubleDouble c = TwoProduct(b.hi_, quotient);
    const DoubleDouble t = FastTwoSum(c.hi_, b.lo_ * quotient);
    const DoubleDouble r = FastTwoSum(t.hi_, t.lo_ + c.lo_);
    const double rest = (a.hi_ - r.hi_) + (a.lo_ - r.lo_);
    return FastTwoSum(quotient, rest / b.hi_);
  }

  /** Returns the root of `a`, a NaN if it is negative. */
  friend DoubleDouble sqrt(const DoubleDouble& a) {
    if (a.hi_ == 0) return 0;
    if (!IsInRange(a.hi_)) return std::numeric_limits<double>::quiet_NaN();
    const double root = std::sqrt(a.hi_);
    const DoubleDouble square = TwoProduct(root, root);
    // The remainder of a root is a double, so both differences are exact.
    const double rest = ((a.hi_ - square.hi_) - square.lo_) + a.lo_;
    return FastTwoSum(root, rest / (2 * root));
  }

  friend DoubleDouble abs(const DoubleDouble& a) { return a.hi_ < 0 ? -a : a; }

  friend bool operator==(const DoubleDouble& a, const DoubleDouble& b) {
    return a.hi_ == b.hi_ && a.lo_ == b.lo_;
  }
  friend bool operator<(const DoubleDouble& a, const DoubleDouble& b) {
    return a.hi_ < b.hi_ || (a.hi_ == b.hi_ && a.lo_ < b.lo_);
  }
  friend bool operator>(const DoubleDouble& a, const DoubleDouble& b) { return b < a; }
  friend bool operator<=(const DoubleDouble& a, const DoubleDouble& b) {
    return a.hi_ < b.hi_ || (a.hi_ == b.hi_ && a.lo_ <= b.lo_);
  }
  friend bool operator>=(const DoubleDouble& a, const DoubleDouble& b) { return b <= a; }

  /** Returns the exact sum of two doubles (Knuth). */
  static DoubleDouble TwoSum(double a, double b) {
    const double sum = a + b;
    const double b_part = sum - a;
    return {sum, (a - (sum - b_part)) + (b - b_part)};
  }

  /** Returns the product of two doubles, exact unless it underflows (Dekker and
   Veltkamp). */
  static DoubleDouble TwoProduct(double a, double b) {
    constexpr double kSplit = 0x1p27 + 1;
    const double a_split = kSplit * a;
    const double a_hi = a_split - (a_split - a);
    const double a_lo = a - a_hi;
    const double b_split = kSplit * b;
    const double b_hi = b_split - (b_split - b);
    const double b_lo = b - b_hi;
    const double product = a * b;
    return {product, ((a_hi * b_hi - product) + a_hi * b_lo + a_lo * b_hi) + a_lo * b_lo};
  }

 private:
  DoubleDouble(double hi, double lo) : hi_(hi), lo_(lo) {}

  /** Returns the exact sum of two doubles with |a| >= |b|, or a = 0 (Dekker). */
  static DoubleDouble FastTwoSum(double a, double b) {
    const double sum = a + b;
    return {sum, b - (sum - a)};
  }

  static bool IsInRange(double x) {
    return std::abs(x) >= 0x1p-900 && std::abs(x) <= 0x1p900;
  }

  double hi_ = 0;
  double lo_ = 0;
};

}  // namespace touchstone::referee
