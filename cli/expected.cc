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

Expected OneOf(const std::vector<std::string>& names) {
  return [names](const std::string& text) -> std::string {
    if (std::find(names.begin(), names.end(), text) != names.end()) return "";
    const std::vector<std::string_view> views(names.begin(), names.end());
    return fmt::format("'{}'{}; expected {}", text, DidYouMean(text, views),
                       fmt::join(names, " or "));
  };
}

}  // namespace touchstone
