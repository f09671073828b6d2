#include "reports/text/si_quantity.h"

#include <array>
#include <cmath>

#include <fmt/format.h>

namespace touchstone {
namespace {

struct Prefix {
  double size;
  std::string_view unit;
};

/** Returns two digits, or three from 100 on, without an exponent where that is short. */
std::string TwoDigits(double value) {
  const double size = std::abs(value);
  if (size >= 99.5 && size < 1e6) {
    const double unit = std::pow(10, std::floor(std::log10(size)) - 2);
    return fmt::format("{:.0f}", std::round(value / unit) * unit);
  }
  std::string text = fmt::format("{:.2g}", value);
  // "2e-06" and "1.8e+06" as people write them: "2e-6", "1.8e6".
  const std::size_t e = text.find('e');
  if (e == std::string::npos) return text;
  if (text[e + 1] == '+') text.erase(e + 1, 1);
  const std::size_t zero = text[e + 1] == '-' ? e + 2 : e + 1;
  if (text[zero] == '0') text.erase(zero, 1);
  return text;
}

}  // namespace

std::string SiQuantity(double value, std::string_view unit) {
  if (std::isnan(value)) return "not a number";
  if (std::isinf(value)) return "infinite";
  if (unit != "m")
    return fmt::format("{}{}{}", TwoDigits(value), unit.empty() ? "" : " ", unit);
  constexpr std::array<Prefix, 4> kPrefixes = {
      {{1, "m"}, {1e-2, "cm"}, {1e-3, "mm"}, {1e-6, "µm"}}};
  for (const auto& [size, name] : kPrefixes) {
    // A value below 0.995 of a prefix has two digits less than 1: the next prefix is
    // better.
    if (std::abs(value) >= 0.995 * size)
      return fmt::format("{} {}", TwoDigits(value / size), name);
  }
  return fmt::format("{} m", TwoDigits(value));
}

std::string ShareInWords(double share, std::string_view whole) {
  if (!std::isfinite(share)) return "";
  if (share >= 1.05) return fmt::format("{} times {}", TwoDigits(share), whole);
  if (share >= 1e-4) return fmt::format("{} % of {}", TwoDigits(share * 100), whole);
  return fmt::format("{} of {}", TwoDigits(share), whole);
}

}  // namespace touchstone
