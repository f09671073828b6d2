#include "reports/shrink/round_to_digits.h"

#include <charconv>
#include <string>

#include <fmt/format.h>

namespace touchstone {

double RoundToDigits(double x, int digits) {
  const std::string text = fmt::format("{:.{}e}", x, digits - 1);
  double rounded = x;
  std::from_chars(text.data(), text.data() + text.size(), rounded);
  return rounded;
}

}  // namespace touchstone
