#include "scenarios/csv_line.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>

namespace touchstone {

std::vector<std::string_view> CellsOf(std::string_view line) {
  if (line.ends_with('\r')) line.remove_suffix(1);
  std::vector<std::string_view> cells;
  for (std::size_t at = 0; at <= line.size();) {
    const std::size_t end = std::min(line.find(',', at), line.size());
    cells.push_back(line.substr(at, end - at));
    at = end + 1;
  }
  return cells;
}

std::optional<double> FiniteNumberIn(std::string_view cell) {
  double number = 0;
  const auto [end, error] =
      std::from_chars(cell.data(), cell.data() + cell.size(), number);
  if (error != std::errc() || end != cell.data() + cell.size() || !std::isfinite(number))
    return std::nullopt;
  return number;
}

}  // namespace touchstone
