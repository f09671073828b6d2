#include "reports/accuracy/published_table.h"

#include <charconv>
#include <system_error>

#include <fmt/format.h>

#include "reports/ledger/apply_ledger.h"
#include "reports/ledger/update_bounds.h"

namespace touchstone {
namespace {

std::string_view Trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(' ');
  if (begin == std::string_view::npos) return "";
  return text.substr(begin, text.find_last_not_of(' ') - begin + 1);
}

std::vector<std::string_view> Split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  while (true) {
    const std::size_t end = text.find(separator);
    parts.push_back(text.substr(0, end));
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + 1);
  }
}

std::optional<double> NumberIn(std::string_view cell) {
  double number = 0;
  const auto [end, error] =
      std::from_chars(cell.data(), cell.data() + cell.size(), number);
  if (error != std::errc() || end != cell.data() + cell.size()) return std::nullopt;
  return number;
}

}  // namespace

std::vector<TableLine> TableLines(std::string_view text) {
  std::vector<TableLine> lines;
  for (const std::string_view line : Split(text, '\n')) {
    if (line.size() < 2 || line.front() != '|' || line.back() != '|') continue;
    TableLine& cells = lines.emplace_back();
    for (const std::string_view cell : Split(line.substr(1, line.size() - 2), '|'))
      cells.push_back(Trimmed(cell));
  }
  return lines;
}

std::string PublishedCell(const std::optional<double>& worst, std::string_view absent) {
  if (!worst) return std::string(absent);
  return fmt::format("{:.1e}", RoundedUp(kProposedBound * *worst));
}

std::string FaultOfCell(std::string_view cell, const std::optional<double>& worst,
                        std::string_view absent) {
  if (!worst) {
    if (cell == absent) return "";
    return fmt::format("the table says {}, but it is \"{}\"", cell, absent);
  }
  const std::optional<double> published = NumberIn(cell);
  if (!published)
    return fmt::format("measured {:.2e}, but the table says {}", *worst, cell);
  // Written so that a NaN is above everything.
  if (!(*worst <= *published))
    return fmt::format("measured {:.2e}, above the published {}", *worst, cell);
  if (*worst < *published * kImproved)
    return fmt::format("improved to {:.2e}: lower the published {}", *worst, cell);
  return "";
}

}  // namespace touchstone
