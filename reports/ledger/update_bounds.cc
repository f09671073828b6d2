#include "reports/ledger/update_bounds.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "reports/finding/severity.h"
#include "reports/finding/verdict_before.h"
#include "reports/ledger/apply_ledger.h"
#include "reports/ledger/bounds_file.h"

namespace touchstone {
namespace {

/** The findings of one cell. */
struct Found {
  bool fails = false;                ///< Whether one is a failure that an entry covers.
  Verdict verdict = Verdict::kPass;  ///< Worst verdict of the covered failures.
  double worst = 0;                  ///< Largest value of a covered failure.
  bool needed = false;               ///< Whether one needs the bound that the cell has.
  bool exceeded = false;             ///< Whether one exceeds it.
};

/** Returns the bound of a cell with failures. */
LedgerBound BoundFor(MeasureKind measure, const Found& found) {
  if (!HasValue(found.verdict)) return {found.verdict, 0, 0};
  return {Verdict::kFail, ProposedBound(measure, found.worst), 0};
}

/** Returns whether the run could tell if a bound is needed. */
bool IsTested(const RunReport& report, const LedgerCell& cell,
              const std::set<std::string_view>& scenarios) {
  const bool took_part = std::ranges::any_of(
      report.oracles, [&](const OracleInfo& info) { return info.name == cell.oracle; });
  if (!took_part || !scenarios.contains(cell.scenario)) return false;
  for (std::size_t i = 0; i < report.ledger.entries.size(); ++i) {
    const LedgerEntry& entry = report.ledger.entries[i];
    if (!Concerns(entry, cell)) continue;
    if (entry.intermittent || report.ledger_use[i].voided) return false;
  }
  return true;
}

}  // namespace

UpdatedBounds UpdateBounds(const RunReport& report) {
  const LedgerBounds& old = report.ledger.bounds;
  const std::map<std::string_view, LedgerScale> scales = LedgerScalesOf(report);
  UpdatedBounds updated;
  std::map<LedgerCell, Found> cells;
  for (const Finding& finding : report.findings) {
    const LedgerCell cell = CellOf(finding);
    const Verdict verdict = VerdictBefore(finding, report.ledger.entries);
    const double value = ValueForLedger(finding, scales.at(finding.scenario));
    const auto bound = old.find(cell);
    const bool fails = IsFailure(verdict);
    const std::optional<std::size_t> entry =
        fails ? EntryFor(report, cell, verdict) : std::nullopt;
    // An intermittent verdict without a value needs no bound.
    if (entry && report.ledger.entries[*entry].intermittent && !HasValue(verdict))
      continue;
    // Nothing bounds an infinite value.
    const bool covered = entry && std::isfinite(value);
    if (fails && !covered) ++updated.uncovered;
    if (!covered && bound == old.end()) continue;
    Found& found = cells[cell];
    if (bound != old.end()) {
      found.needed = found.needed || !IsImproved(bound->second, finding, verdict, value);
      found.exceeded =
          found.exceeded || (covered && !IsWithin(bound->second, verdict, value));
    }
    if (!covered) continue;
    found.fails = true;
    found.verdict = Worse(found.verdict, verdict);
    found.worst = std::max(found.worst, value);
  }
  std::set<std::string_view> scenarios;
  for (std::size_t i = 0; i < QuestionCount(report); ++i)
    scenarios.insert(IdOf(report, i));
  for (const auto& [cell, bound] : old) {
    const auto found = cells.find(cell);
    const bool holds =
        found != cells.end() && found->second.needed && !found->second.exceeded;
    if (holds || ((found == cells.end() || !found->second.fails) &&
                  !IsTested(report, cell, scenarios))) {
      updated.bounds.emplace(cell, bound);
    } else if (found != cells.end() && found->second.fails) {
      updated.bounds.emplace(cell, BoundFor(cell.measure, found->second));
      ++updated.changed;
    } else {
      ++updated.removed;
    }
  }
  for (const auto& [cell, found] : cells) {
    if (!found.fails || old.contains(cell)) continue;
    updated.bounds.emplace(cell, BoundFor(cell.measure, found));
    ++updated.added;
  }
  return updated;
}

double ProposedBound(MeasureKind measure, double value) {
  if (IsCount(measure)) return value;
  const double bound = RoundedUp(kProposedBound * value);
  return IsShare(measure) ? std::min(bound, 1.0) : bound;
}

double RoundedUp(double value) {
  if (!(value > 0)) return 0;
  const double digit = std::pow(10.0, std::floor(std::log10(value)) - 1);
  // The text of two digits is what a file of bounds holds.
  const std::string text = fmt::format("{:.1e}", std::ceil(value / digit) * digit);
  return std::strtod(text.c_str(), nullptr);
}

}  // namespace touchstone
