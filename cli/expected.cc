#include "cli/expected.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>
#include <thread>

#include <fmt/format.h>

#include "cli/did_you_mean.h"

namespace touchstone {

Expected WholeNumber(std::uint64_t least, std::uint64_t most) {
  return [least, most](const std::string& text) -> std::string {
    std::uint64_t number = 0;
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, number);
    const bool is_number = error != std::errc::invalid_argument && stop == end;
    const bool too_large = error == std::errc::result_out_of_range || number > most;
    if (is_number && too_large) return fmt::format("{}; expected at most {}", text, most);
    if (is_number && number >= least) return "";
    return fmt::format("'{}'; expected a whole number of at least {}", text, least);
  };
}

Expected NumberOfThreads() {
  return [](const std::string& text) -> std::string {
    const unsigned processors = std::max(1U, std::thread::hardware_concurrency());
    if (WholeNumber(1, processors)(text).empty()) return "";
    return fmt::format(
        "'{}'; expected a whole number from 1 to {}, the number of processors", text,
        processors);
  };
}

Expected NotNegative() {
  return [](const std::string& text) -> std::string {
    double number = 0;
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, number);
    if (error == std::errc() && stop == end && std::isfinite(number) && number >= 0)
      return "";
    return fmt::format("'{}'; expected a finite number >= 0", text);
  };
}

Expected Duration() {
  return [](const std::string& text) -> std::string {
    const std::string number = text.substr(0, text.find_last_of("0123456789") + 1);
    const bool has_unit = text.size() == number.size() + 1 &&
                          std::string_view("smhd").find(text.back()) != std::string::npos;
    // A century, so that the sum with the clock does not overflow.
    if (has_unit && WholeNumber(1, 36500)(number).empty()) return "";
    return fmt::format("'{}'; expected a duration such as 90s, 10m, 2h or 1d", text);
  };
}

std::chrono::seconds DurationOf(const std::string& text) {
  const std::int64_t number = std::stoll(text);
  switch (text.back()) {
    case 'd':
      return std::chrono::days(number);
    case 'h':
      return std::chrono::hours(number);
    case 'm':
      return std::chrono::minutes(number);
    default:
      return std::chrono::seconds(number);
  }
}

Expected PartOfWhole() {
  return [](const std::string& text) -> std::string {
    const std::size_t slash = text.find('/');
    if (slash != std::string::npos) {
      const std::string part = text.substr(0, slash);
      const std::string whole = text.substr(slash + 1);
      if (WholeNumber(1, 1'000'000)(whole).empty() &&
          WholeNumber(1, std::stoull(whole))(part).empty()) {
        return "";
      }
    }
    return fmt::format("'{}'; expected K/N with 1 <= K <= N <= 1000000, e.g. 2/8", text);
  };
}

std::pair<std::uint64_t, std::uint64_t> PartOf(const std::string& text) {
  return {std::stoull(text), std::stoull(text.substr(text.find('/') + 1))};
}

Expected OneOf(const std::vector<std::string>& names) {
  return [names](const std::string& text) -> std::string {
    if (std::find(names.begin(), names.end(), text) != names.end()) return "";
    const std::vector<std::string_view> views(names.begin(), names.end());
    return fmt::format("'{}'{}; expected {}", text, DidYouMean(text, views),
                       fmt::join(names, " or "));
  };
}

}  // namespace touchstone
