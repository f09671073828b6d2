#include "reports/accuracy/world_accuracy.h"

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "reports/accuracy/published_table.h"

namespace touchstone {
namespace {

constexpr std::string_view kAbsent = "-";

/** The errors of one world and one measure. */
struct Row {
  std::map<std::string_view, double>
      worst;  ///< Keyed by oracle; only oracles that were judged.
  /** Oracles that follow another legal model than the truth's: their values are not
   errors. */
  std::set<std::string_view> legal;
  double least_tolerance = std::numeric_limits<double>::infinity();

  std::optional<double> Of(std::string_view oracle) const {
    const auto found = worst.find(oracle);
    return found == worst.end() ? std::nullopt : std::optional(found->second);
  }

  /** Returns the value of an oracle unless it follows another legal model. */
  std::optional<double> ErrorOf(std::string_view oracle) const {
    return legal.contains(oracle) ? std::nullopt : Of(oracle);
  }

  /** Returns the oracle with the least error of those with a smaller error than `oracle`;
   "" if there is none. */
  std::string_view LessThan(std::string_view oracle) const {
    const std::optional<double> error = ErrorOf(oracle);
    std::string_view least;
    for (const auto& [other, value] : worst) {
      if (!error || legal.contains(other) || *error <= value + kAlike * least_tolerance)
        continue;
      if (least.empty() || value < worst.at(least)) least = other;
    }
    return least;
  }
};

using Rows = std::map<std::pair<std::string_view, MeasureKind>, Row>;

/** Returns whether a finding compares a motion with the truth that its world claims, not
 with itself or with laws that hold everywhere. */
bool IsError(const Finding& finding) {
  return finding.reference == "law" && !finding.universal &&
         finding.measure >= MeasureKind::kPositionError &&
         finding.measure <= MeasureKind::kForceError;
}

Rows MeasuredRows(const RunReport& report) {
  std::set<std::string_view> worlds;
  for (const WorldResult& result : report.worlds) worlds.insert(result.scenario.id);
  Rows rows;
  for (const Finding& finding : report.findings) {
    if (!IsError(finding) || !worlds.contains(finding.scenario)) continue;
    Row& row = rows[{finding.scenario, finding.measure}];
    row.least_tolerance = std::min(row.least_tolerance, finding.tolerance);
    double& worst = row.worst.try_emplace(finding.oracle, 0).first->second;
    worst = std::max(worst, finding.value);
    if (finding.verdict == Verdict::kPass && finding.cause == Cause::kModel)
      row.legal.insert(finding.oracle);
  }
  return rows;
}

std::vector<const OracleInfo*> SimulatorsOf(const RunReport& report) {
  std::vector<const OracleInfo*> simulators;
  for (const OracleInfo& oracle : report.oracles) {
    if (oracle.simulates) simulators.push_back(&oracle);
  }
  return simulators;
}

std::string MeasureCell(MeasureKind measure) {
  const std::string_view unit = UnitOf(measure);
  if (unit.empty()) return std::string(NameOf(measure));
  return fmt::format("{} [{}]", NameOf(measure), unit);
}

/** The number of rows in which an oracle was judged, and in how many of them no oracle
 has a smaller error. */
struct Standing {
  int judged = 0;
  int least = 0;
};

Standing StandingOf(std::string_view oracle, const Rows& rows) {
  Standing standing;
  for (const auto& [key, row] : rows) {
    if (!row.ErrorOf(oracle)) continue;
    ++standing.judged;
    standing.least += row.LessThan(oracle).empty() ? 1 : 0;
  }
  return standing;
}

/** Lists the rows in which another oracle has a smaller error than `oracle`, one line
 each. */
std::string LostRows(std::string_view oracle, const Rows& rows) {
  std::string lines;
  for (const auto& [key, row] : rows) {
    const std::string_view less = row.LessThan(oracle);
    if (less.empty()) continue;
    lines += fmt::format("- {}, {}: {}, and {} by {}\n", key.first,
                         MeasureCell(key.second), PublishedCell(row.Of(oracle), kAbsent),
                         PublishedCell(row.Of(less), kAbsent), less);
  }
  if (lines.empty()) return "";
  return fmt::format("In these rows another oracle has a smaller error than {}:\n\n{}\n",
                     oracle, lines);
}

std::string Summary(const std::vector<const OracleInfo*>& simulators, const Rows& rows) {
  std::string text =
      "| oracle | version | rows | in which no error is smaller |\n|---|---|---|---|\n";
  for (const OracleInfo* oracle : simulators) {
    const auto [judged, least] = StandingOf(oracle->name, rows);
    text += fmt::format("| {} | {} | {} | {} |\n", oracle->name, oracle->version, judged,
                        least);
  }
  return text + "\n";
}

/** Published cells, keyed by world and measure, then by oracle. */
using Published = std::map<std::pair<std::string_view, std::string_view>,
                           std::map<std::string_view, std::string_view>>;

Published PublishedRows(std::string_view text) {
  constexpr std::size_t kNames = 2;  // Columns: world, measure.
  Published rows;
  TableLine header;
  for (const TableLine& cells : TableLines(text)) {
    if (cells[0] == "world") header = cells;
    if (header.empty() || cells.size() != header.size()) continue;
    for (std::size_t i = kNames; i < cells.size(); ++i)
      rows[{cells[0], cells[1]}][header[i]] = cells[i];
  }
  return rows;
}

}  // namespace

std::string WorldAccuracyTable(const RunReport& report) {
  const Rows rows = MeasuredRows(report);
  if (rows.empty()) return "";
  const std::vector<const OracleInfo*> simulators = SimulatorsOf(report);
  std::string text = fmt::format(
      "\n{}\n\n"
      "The worst error of each oracle against the laws of each world, in the unit\n"
      "of the measure: 1.5 times the measured value, rounded up; - where the world or\n"
      "the measure does not apply to it. Guarded like the table above. Two errors\n"
      "that differ by less than {:g} of the tolerance count as equal. A motion that\n"
      "follows another legal model than the truth's (simultaneous impacts, another\n"
      "friction cone) is not counted: the distance between two models is no error.\n\n",
      kWorldAccuracyHeading, kAlike);
  text += Summary(simulators, rows);
  if (!simulators.empty()) text += LostRows(simulators.front()->name, rows);
  text += "| world | measure |";
  for (const OracleInfo* oracle : simulators) text += fmt::format(" {} |", oracle->name);
  text += "\n|---|---|";
  for (std::size_t i = 0; i < simulators.size(); ++i) text += "---|";
  for (const auto& [key, row] : rows) {
    text += fmt::format("\n| {} | {} |", key.first, MeasureCell(key.second));
    for (const OracleInfo* oracle : simulators)
      text += fmt::format(" {} |", PublishedCell(row.Of(oracle->name), kAbsent));
  }
  return text + "\n";
}

std::vector<std::string> CheckWorldAccuracy(const RunReport& report,
                                            std::string_view text) {
  const Published published = PublishedRows(text);
  const std::vector<const OracleInfo*> simulators = SimulatorsOf(report);
  std::vector<std::string> faults;
  for (const auto& [key, row] : MeasuredRows(report)) {
    const auto& [world, measure] = key;
    const auto found = published.find({world, MeasureCell(measure)});
    for (const OracleInfo* oracle : simulators) {
      const std::optional<double> worst = row.Of(oracle->name);
      std::string fault;
      if (found != published.end() && found->second.contains(oracle->name)) {
        fault = FaultOfCell(found->second.at(oracle->name), worst, kAbsent);
      } else if (worst) {
        fault = "is not in the table: add it";
      }
      if (fault.empty()) continue;
      faults.push_back(
          fmt::format("{} in {}: {}: {}", oracle->name, world, NameOf(measure), fault));
    }
  }
  return faults;
}

}  // namespace touchstone
