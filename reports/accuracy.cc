#include "reports/accuracy.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>
#include <span>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "reports/apply_ledger.h"
#include "reports/ledger_file.h"

namespace touchstone {
namespace {

/** The measures that have a column, in this order. */
constexpr std::array kColumns = {MeasureKind::kSeparationError, MeasureKind::kExcess,
                                 MeasureKind::kContactSurfaceError};

constexpr std::string_view kUnsupported = "unsupported";
constexpr std::string_view kNotGiven = "-";

constexpr std::string_view kPreamble =
    "# Accuracy\n"
    "\n"
    "The worst error of each oracle on each pair of shapes over the catalogue, relative "
    "to the\n"
    "size of the scene: 1.5 times what was measured, rounded up. Generated, and guarded "
    "from\n"
    "both sides: an error above its row fails, and so does one below a twelfth of it.\n"
    "\n";

/** An oracle and an unordered pair of shapes: what a row is about. */
struct RowKey {
  std::size_t oracle;  ///< In the order of the report.
  ShapeKind a;
  ShapeKind b;  ///< Not before a.
  auto operator<=>(const RowKey&) const = default;
};

/** Worst errors by column; empty where the measure never applied. */
struct Row {
  int questions = 0;  ///< Answered.
  std::array<std::optional<double>, kColumns.size()> worst;
};

RowKey KeyOf(std::size_t oracle, const ContactQuery& query) {
  const auto [a, b] = std::minmax({KindOf(query.A.shape), KindOf(query.B.shape)});
  return {oracle, a, b};
}

std::string ShapesOf(const RowKey& key) {
  return fmt::format("{}, {}", NameOf(key.a), NameOf(key.b));
}

std::map<RowKey, Row> MeasuredRows(const RunReport& report) {
  std::map<std::string_view, const ContactQuery*> queries;
  std::map<RowKey, Row> rows;
  for (const ScenarioResult& result : report.scenarios) {
    const ContactQuery& query = result.scenario.contact;
    queries[result.scenario.id] = &query;
    for (std::size_t i = 0; i < report.oracles.size(); ++i) {
      if (!report.oracles[i].AnswersContacts()) continue;
      rows[KeyOf(i, query)].questions +=
          result.answers[i].status == AnswerStatus::kAnswered;
    }
  }
  std::map<std::string_view, std::size_t> oracles;
  for (std::size_t i = 0; i < report.oracles.size(); ++i)
    oracles[report.oracles[i].name] = i;
  for (const Finding& finding : report.findings) {
    const auto column = std::find(kColumns.begin(), kColumns.end(), finding.measure);
    if (column == kColumns.end()) continue;
    const ContactQuery& query = *queries.at(finding.scenario);
    Row& row = rows.at(KeyOf(oracles.at(finding.oracle), query));
    std::optional<double>& worst =
        row.worst[static_cast<std::size_t>(column - kColumns.begin())];
    worst = std::max(worst.value_or(0), ValueForLedger(finding, SceneSize(query)));
  }
  return rows;
}

std::vector<std::string> CellsOf(const Row& row) {
  std::vector<std::string> cells;
  for (const std::optional<double>& worst : row.worst) {
    if (row.questions == 0) {
      cells.emplace_back(kUnsupported);
    } else if (!worst) {
      cells.emplace_back(kNotGiven);
    } else {
      cells.push_back(fmt::format("{:.1e}", RoundedUp(kProposedBound * *worst)));
    }
  }
  return cells;
}

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

/** Published cells by oracle and shapes. */
using Published = std::map<std::pair<std::string_view, std::string_view>,
                           std::vector<std::string_view>>;

Published PublishedRows(std::string_view text) {
  constexpr std::size_t kNames = 3;  // Oracle, version, shapes.
  Published rows;
  for (const std::string_view line : Split(text, '\n')) {
    std::vector<std::string_view> cells;
    for (const std::string_view cell : Split(line, '|')) cells.push_back(Trimmed(cell));
    // Before the first bar and after the last there is nothing.
    if (cells.size() != kNames + kColumns.size() + 2) continue;
    rows[{cells[1], cells[3]}].assign(cells.begin() + 1 + kNames, cells.end() - 1);
  }
  return rows;
}

std::optional<double> NumberIn(std::string_view cell) {
  double number = 0;
  const auto [end, error] =
      std::from_chars(cell.data(), cell.data() + cell.size(), number);
  if (error != std::errc() || end != cell.data() + cell.size()) return std::nullopt;
  return number;
}

/** Returns what is wrong with one published cell, or nothing. */
std::string FaultOfCell(std::string_view cell, const Row& row, std::size_t column) {
  const std::optional<double>& worst = row.worst[column];
  if (row.questions == 0 || !worst) {
    const std::string_view expected = row.questions == 0 ? kUnsupported : kNotGiven;
    if (cell == expected) return "";
    return fmt::format("the table says {}, but it is \"{}\"", cell, expected);
  }
  const std::optional<double> published = NumberIn(cell);
  if (!published)
    return fmt::format("measured {:.2e}, but the table says {}", *worst, cell);
  // Written so that a NaN is above everything.
  if (!(*worst <= *published)) {
    return fmt::format("measured {:.2e}, above the published {}", *worst, cell);
  }
  if (*worst < *published * kImproved) {
    return fmt::format("improved to {:.2e}: lower the published {}", *worst, cell);
  }
  return "";
}

}  // namespace

std::string AccuracyTable(const RunReport& report) {
  std::string text(kPreamble);
  text += "| oracle | version | shapes ";
  for (const MeasureKind measure : kColumns)
    text += fmt::format("| {} ", NameOf(measure));
  text += "|\n|---|---|---";
  for ([[maybe_unused]] const MeasureKind measure : kColumns) text += "|---";
  text += "|\n";
  for (const auto& [key, row] : MeasuredRows(report)) {
    const OracleInfo& oracle = report.oracles[key.oracle];
    text += fmt::format("| {} | {} | {} | {} |\n", oracle.name, oracle.version,
                        ShapesOf(key), fmt::join(CellsOf(row), " | "));
  }
  return text;
}

std::vector<std::string> CheckAccuracy(const RunReport& report, std::string_view text) {
  const Published published = PublishedRows(text);
  std::vector<std::string> faults;
  for (const auto& [key, row] : MeasuredRows(report)) {
    const std::string& oracle = report.oracles[key.oracle].name;
    const std::string shapes = ShapesOf(key);
    const auto found = published.find({oracle, shapes});
    if (found == published.end()) {
      faults.push_back(fmt::format("{} on {}: has no row: add it", oracle, shapes));
      continue;
    }
    for (std::size_t i = 0; i < kColumns.size(); ++i) {
      const std::string fault = FaultOfCell(found->second[i], row, i);
      if (fault.empty()) continue;
      faults.push_back(
          fmt::format("{} on {}: {}: {}", oracle, shapes, NameOf(kColumns[i]), fault));
    }
  }
  return faults;
}

}  // namespace touchstone
