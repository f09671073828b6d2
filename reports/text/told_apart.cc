#include "reports/text/told_apart.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "reports/text/format_vector.h"

namespace touchstone {
namespace {

/** Returns `digits`, or as many more as numbers of the size `larger` need to show two
 digits of `difference`. */
int DigitsToTell(double larger, double difference, int digits) {
  constexpr int kAllOfADouble = 17;
  if (!std::isfinite(difference) || !(difference > 0)) return digits;
  const double leading =
      std::floor(std::log10(larger)) - std::floor(std::log10(difference));
  return std::clamp(static_cast<int>(leading) + 2, digits, kAllOfADouble);
}

}  // namespace

ToldApart TellApart(double a, double b, int digits) {
  const double difference = std::abs(a - b);
  const int shown = DigitsToTell(std::max(std::abs(a), std::abs(b)), difference, digits);
  return {fmt::format("{:.{}g}", a, shown), fmt::format("{:.{}g}", b, shown),
          fmt::format("{:.3g}", difference)};
}

ToldApart TellApart(const Eigen::Vector3d& a, const Eigen::Vector3d& b, int digits) {
  const double larger = std::max(a.cwiseAbs().maxCoeff(), b.cwiseAbs().maxCoeff());
  const double difference = (a - b).norm();
  const int shown = DigitsToTell(larger, difference, digits);
  return {FormatVector(a, shown), FormatVector(b, shown),
          fmt::format("{:.3g}", difference)};
}

}  // namespace touchstone
