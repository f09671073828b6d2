#include "reports/text/told_apart.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace touchstone {

ToldApart TellApart(double a, double b, int digits) {
  constexpr int kAllOfADouble = 17;
  const double difference = std::abs(a - b);
  if (std::isfinite(difference) && difference > 0) {
    const double larger = std::max(std::abs(a), std::abs(b));
    const double leading =
        std::floor(std::log10(larger)) - std::floor(std::log10(difference));
    digits = std::clamp(static_cast<int>(leading) + 2, digits, kAllOfADouble);
  }
  return {fmt::format("{:.{}g}", a, digits), fmt::format("{:.{}g}", b, digits),
          fmt::format("{:.3g}", difference)};
}

}  // namespace touchstone
