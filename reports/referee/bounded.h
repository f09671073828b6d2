#pragma once

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <limits>

#include "reports/referee/contact_truth.h"
#include "reports/referee/precise.h"
#include "reports/referee/vector.h"

// Every error bound assumes that each operation is rounded once, to a double.
#ifdef __FAST_MATH__
#error "The referee's proofs need IEEE arithmetic: compile without -ffast-math."
#endif
static_assert(std::numeric_limits<double>::is_iec559);
static_assert(FLT_EVAL_METHOD == 0, "Doubles must be rounded at every operation.");

namespace touchstone::referee {

/** A computed number with a running bound on its error: |true value − value| <= error.
 Each operation adds the propagated errors of its operands, by the exact formula, to the
 rounding of its own result, u |result|. The bound itself is computed in double with a
 handful of roundings to nearest, each at most 2^-53 of a sum of positive terms:
 `kInflation` covers them. Products that underflow lose at most 2^-1075 each: `kUnderflow`
 covers those. An operation of `Precise` that MPFR finds exact adds no error, so the
 sign of an exactly zero separation is known. If doubles overflow, nothing is known: the
 error is infinite. It is never a NaN, which comparisons would drop. */
template <typename Real>
class Bounded {
 public:
  Bounded() : value_(0) {}
  /** Makes a number without error. */
  explicit Bounded(const Real& exact) : Bounded(exact, 0) {}
  explicit Bounded(double exact) requires(!std::is_same_v<Real, double>)
      : Bounded(Real(exact), 0) {}
  /** Makes a number with an error bound, which is infinite if either argument is a NaN.
   */
  Bounded(const Real& value, double error)
      : value_(value),
        // Written so that a NaN leaves the error unbounded.
        error_(!IsNan(value) && error >= 0 ? error
                                           : std::numeric_limits<double>::infinity()) {}

  const Real& value() const { return value_; }
  double error() const { return error_; }

  /** Returns the tightest interval of doubles that certainly contains the true value. */
  Enclosure enclosure() const {
    // Infinity minus infinity is a NaN, and so is a NaN minus anything.
    if (error_ == std::numeric_limits<double>::infinity()) return {-error_, error_};
    return {Below(value_, error_), -Below(Real(-value_), error_)};
  }

  friend Bounded operator+(const Bounded& a, const Bounded& b) {
    const Exactness<Real> exactness;
    const Real sum = a.value_ + b.value_;
    return Rounded(sum, a.error_ + b.error_, exactness.Holds());
  }
  friend Bounded operator-(const Bounded& a, const Bounded& b) {
    const Exactness<Real> exactness;
    const Real difference = a.value_ - b.value_;
    return Rounded(difference, a.error_ + b.error_, exactness.Holds());
  }
  friend Bounded operator-(const Bounded& a) {
    return Bounded(Real(-a.value_), a.error_);
  }

  friend Bounded operator*(const Bounded& a, const Bounded& b) {
    const Exactness<Real> exactness;
    const Real product = a.value_ * b.value_;
    const bool is_exact = exactness.Holds();
    if (is_exact && a.error_ == 0 && b.error_ == 0) return Rounded(product, 0, true);
    return Rounded(product,
                   Magnitude(a.value_) * b.error_ + Magnitude(b.value_) * a.error_ +
                       a.error_ * b.error_ + kUnderflow<Real>,
                   is_exact);
  }

  /** Divides by x/y − a/b = ((x − a) − (a/b)(y − b)) / y with |y| >= |b| − e_b. The error
   is unbounded if the divisor may be zero. */
  friend Bounded operator/(const Bounded& a, const Bounded& b) {
    const double least = Below(Real(abs(b.value_)), b.error_);
    if (!(least > 0)) return Bounded(Real(0), std::numeric_limits<double>::infinity());
    const Exactness<Real> exactness;
    const Real quotient = a.value_ / b.value_;
    const bool is_exact = exactness.Holds();
    // The quotient 0 is exact even if the divisor has an error, since that is not 0.
    if (is_exact && a.error_ == 0 && (b.error_ == 0 || quotient == 0))
      return Rounded(quotient, 0, true);
    const double carried =
        (a.error_ + Magnitude(quotient) * b.error_ * kInflation) / least +
        kUnderflow<Real>;
    return Rounded(quotient, carried, is_exact);
  }

  /** Takes the root by |√x − √a| = |x − a| / (√x + √a) <= e / √a. Where a itself may have
   the wrong sign, both roots lie in [0, √(a + e)]. @pre The true value is >= 0. */
  friend Bounded Sqrt(const Bounded& a) {
    using std::sqrt;
    if (!(Below(a.value_, a.error_) > 0)) {
      const double most = a.enclosure().hi;
      return Bounded(Real(0), std::sqrt(std::max(most, 0.0)) * kInflation);
    }
    const Exactness<Real> exactness;
    const Real root = sqrt(a.value_);
    const bool is_exact = exactness.Holds();
    const double least_root = std::max(Below(root, kRoundoff<Real> * Magnitude(root)),
                                       std::numeric_limits<double>::min());
    const double carried = a.error_ == 0 ? 0 : a.error_ / least_root + kUnderflow<Real>;
    return Rounded(root, carried, is_exact);
  }

  friend Bounded Abs(const Bounded& a) { return Bounded(Real(abs(a.value_)), a.error_); }
  /** Returns the larger number. max and min are 1-Lipschitz in the larger of the two
   errors. */
  friend Bounded Max(const Bounded& a, const Bounded& b) {
    return Bounded(a.value_ < b.value_ ? b.value_ : a.value_,
                   std::max(a.error_, b.error_));
  }
  friend Bounded Min(const Bounded& a, const Bounded& b) {
    return Bounded(a.value_ < b.value_ ? a.value_ : b.value_,
                   std::max(a.error_, b.error_));
  }

 private:
  static constexpr double kInflation = 1 + 0x1p-49;

  static Real abs(const Real& x) { return x < 0 ? Real(-x) : x; }
  /** Adds the rounding of the result to `carried`, with `kUnderflow`, because a value of
   `Precise` can be smaller than any double. */
  static Bounded Rounded(const Real& value, double carried, bool is_exact) {
    const double magnitude = Magnitude(value);
    // An infinite value is no result, even of an operation without a rounding.
    const double rounding = is_exact && std::isfinite(magnitude)
                                ? 0
                                : kRoundoff<Real> * magnitude + kUnderflow<Real>;
    return Bounded(value, (carried + rounding) * kInflation);
  }

  Real value_;
  double error_ = 0;
};

template <typename Real>
Bounded<Real> Norm(const Vector<Bounded<Real>>& a) {
  return Sqrt(Dot(a, a));
}

}  // namespace touchstone::referee
