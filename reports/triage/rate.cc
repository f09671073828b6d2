#include "reports/triage/rate.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace touchstone {

double ShareOf(const Rate& rate) {
  return rate.asked == 0
             ? 0
             : static_cast<double>(rate.failed) / static_cast<double>(rate.asked);
}

ShareInterval IntervalOf(const Rate& rate) {
  if (rate.asked == 0) return {};
  constexpr double kZ = 1.959963984540054;  // Of 97.5 % of the normal distribution.
  const auto n = static_cast<double>(rate.asked);
  const double p = ShareOf(rate);
  const double z2_n = kZ * kZ / n;
  const double middle = (p + z2_n / 2) / (1 + z2_n);
  const double half = kZ / (1 + z2_n) * std::sqrt(p * (1 - p) / n + z2_n / (4 * n));
  // If none or all failed, the end is 0 or 1: the formula only rounds it.
  return {rate.failed == 0 ? 0 : std::max(0.0, middle - half),
          rate.failed == rate.asked ? 1 : std::min(1.0, middle + half)};
}

std::string ToString(const Rate& rate) {
  const auto [lo, hi] = IntervalOf(rate);
  return fmt::format("{} of {}, {:.3g} % ({:.3g} % to {:.3g} %)", rate.failed, rate.asked,
                     100 * ShareOf(rate), 100 * lo, 100 * hi);
}

}  // namespace touchstone
