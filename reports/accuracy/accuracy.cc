#include "reports/accuracy/accuracy.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "reports/accuracy/published_table.h"
#include "reports/accuracy/world_accuracy.h"
#include "reports/ledger/apply_ledger.h"

namespace touchstone {
namespace {

/** The measures that have a column, in the order of the columns. */
constexpr std::array kColumns = {MeasureKind::kSeparationError, MeasureKind::kExcess,
                                 MeasureKind::kContactSurfaceError};

constexpr std::string_view kUnsupported = "unsupported";
constexpr std::string_view kNotGiven = "-";

constexpr std::string_view kPreamble =
    "# Accuracy\n"
    "\n"
    "The worst error of each oracle on each pair of shapes over the catalogue,\n"
    "relative to the size of the scene: 1.5 times the measured value, rounded up.\n"
    "Written by `touchstone accuracy > docs/accuracy.md` and guarded from both sides:\n"
    "an error above its row fails, and so does one below a twelfth of it.\n"
    "`touchstone explain ID --all` shows the measurements behind a row.\n"
    "\n";

/** The key of a row: an oracle and an unordered pair of shapes. */
struct RowKey {
  std::size_t oracle;  ///< Index into RunReport::oracles.
  ShapeKind a;
  ShapeKind b;  ///< Not less than `a`.
  auto operator<=>(const RowKey&) const = default;
};

/** The worst errors, indexed by column; empty where the measure never applied. */
struct Row {
  int questions = 0;  ///< Number of answered questions.
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
    worst = std::max(worst.value_or(0), ValueForLedger(finding, {SceneSize(query)}));
  }
  return rows;
}

std::string_view AbsentFrom(const Row& row) {
  return row.questions == 0 ? kUnsupported : kNotGiven;
}

std::vector<std::string> CellsOf(const Row& row) {
  std::vector<std::string> cells;
  for (const std::optional<double>& worst : row.worst)
    cells.push_back(PublishedCell(worst, AbsentFrom(row)));
  return cells;
}

/** Published cells, keyed by oracle and shapes. */
using Published = std::map<std::pair<std::string_view, std::string_view>, TableLine>;

Published PublishedRows(std::string_view text) {
  constexpr std::size_t kNames = 3;  // Columns: oracle, version, shapes.
  Published rows;
  for (const TableLine& cells : TableLines(text)) {
    if (cells.size() != kNames + kColumns.size()) continue;
    rows[{cells[0], cells[2]}].assign(cells.begin() + kNames, cells.end());
  }
  return rows;
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
  return text + WorldAccuracyTable(report);
}

std::vector<std::string> CheckAccuracy(const RunReport& report, std::string_view text) {
  const std::size_t worlds = text.find(kWorldAccuracyHeading);
  const Published published = PublishedRows(text.substr(0, worlds));
  std::vector<std::string> faults = CheckWorldAccuracy(
      report, worlds == std::string_view::npos ? "" : text.substr(worlds));
  for (const auto& [key, row] : MeasuredRows(report)) {
    const std::string& oracle = report.oracles[key.oracle].name;
    const std::string shapes = ShapesOf(key);
    const auto found = published.find({oracle, shapes});
    if (found == published.end()) {
      faults.push_back(fmt::format("{} on {}: has no row: add it", oracle, shapes));
      continue;
    }
    for (std::size_t i = 0; i < kColumns.size(); ++i) {
      const std::string fault =
          FaultOfCell(found->second[i], row.worst[i], AbsentFrom(row));
      if (fault.empty()) continue;
      faults.push_back(
          fmt::format("{} on {}: {}: {}", oracle, shapes, NameOf(kColumns[i]), fault));
    }
  }
  return faults;
}

}  // namespace touchstone
