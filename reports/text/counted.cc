#include "reports/text/counted.h"

#include <fmt/format.h>

namespace touchstone {

std::string Counted(std::uint64_t count, std::string_view noun, std::string_view plural) {
  if (count == 1) return fmt::format("1 {}", noun);
  if (plural.empty()) return fmt::format("{} {}s", count, noun);
  return fmt::format("{} {}", count, plural);
}

std::string Counted(int count, std::string_view noun, std::string_view plural) {
  return Counted(static_cast<std::uint64_t>(count), noun, plural);
}

}  // namespace touchstone
