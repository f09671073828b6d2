#include "reports/sweep/series.h"

#include <algorithm>

namespace touchstone {

std::uint64_t BlockSizeOf(const Series& series) {
  return IsOfWorlds(series) ? kWorldBlock : kContactBlock;
}

std::string_view KindNameOf(const Series& series) {
  return IsOfWorlds(series) ? "world" : "contact";
}

std::uint64_t CountOf(const Series& series) {
  return std::visit([](const auto& of_kind) { return of_kind.count; }, series);
}

std::uint64_t BlockCount(const Series& series) {
  const std::uint64_t size = BlockSizeOf(series);
  const std::uint64_t count = CountOf(series);
  return count / size + (count % size == 0 ? 0 : 1);
}

Series BlockOf(const Series& series, std::uint64_t block) {
  const std::uint64_t size = BlockSizeOf(series);
  Series result = series;
  std::visit(
      [&](auto& of_kind) {
        of_kind.first += block * size;
        of_kind.count = std::min(size, of_kind.count - block * size);
      },
      result);
  return result;
}

std::string ReplayOf(const Series& series, std::uint64_t index) {
  return std::visit([&](const auto& of_kind) { return ReplayOf(of_kind, index); },
                    series);
}

}  // namespace touchstone
