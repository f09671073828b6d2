#include "reports/sweep/series.h"

#include <algorithm>

namespace touchstone {

std::uint64_t BlockSizeOf(const Series& series) {
  return IsOfWorlds(series) ? kWorldBlock : kContactBlock;
}

std::string_view KindNameOf(const Series& series) {
  return IsOfWorlds(series) ? "world" : "contact";
}

std::string OriginOf(const Series& series) {
  if (const auto* const file = std::get_if<FileSeries>(&series)) return file->file;
  if (const auto* const worlds = std::get_if<WorldSeries>(&series))
    return std::string(NameOf(worlds->family));
  return std::string(NameOf(std::get<QuestionSeries>(series).family));
}

std::optional<std::pair<ShapeKind, ShapeKind>> PairOf(const Series& series) {
  if (const auto* const file = std::get_if<FileSeries>(&series))
    return std::pair(file->A, file->B);
  if (const auto* const contacts = std::get_if<QuestionSeries>(&series))
    return std::pair(contacts->A, contacts->B);
  return std::nullopt;
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
