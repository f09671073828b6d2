#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "reports/baseline/baseline.h"
#include "reports/contacts/tolerances.h"
#include "reports/finding/severity.h"
#include "reports/ledger/apply_ledger.h"
#include "reports/worlds/study/world_size.h"

namespace touchstone {
namespace {

/** The part of its tolerance below which a value has no cause but chance. [-] */
constexpr double kChance = 0.01;

/** Returns whether a verdict is a fault, whether the ledger knows it or not. */
bool IsFault(Verdict verdict) {
  const int rank = SeverityOf(verdict);
  return rank == 2 || rank == 3;
}

/** Returns whether an earlier pass is neither a pass nor a fault now. */
bool IsNotJudged(Verdict before, Verdict now) {
  return before == Verdict::kPass &&
         (now == Verdict::kUndecidable || now == Verdict::kUnsupported);
}

/** Returns why a finding is worse than an earlier one; "" if it is not. */
std::string WhyWorse(MeasureKind measure, const Baseline::Measured& before,
                     const Baseline::Measured& now) {
  if (SeverityOf(now.verdict) > SeverityOf(before.verdict))
    return fmt::format("was {}, is {}", NameOf(before.verdict), NameOf(now.verdict));
  // Written so that a number that becomes a NaN is worse.
  if (std::isnan(before.value) ||
      now.value <= kWorseFactor * std::max(before.value, now.floor))
    return "";
  return fmt::format("was {:.3g}, is {:.3g} {}", before.value, now.value,
                     UnitOf(measure));
}

/** Returns what a fault is that only one run has: "is fail, 0.02 m". */
std::string WhatItIs(std::string_view verb, MeasureKind measure,
                     const Baseline::Measured& measured) {
  return fmt::format("{} {}, {:.3g} {}", verb, NameOf(measured.verdict), measured.value,
                     UnitOf(measure));
}

}  // namespace

Baseline FindingsOf(const Baseline& run, std::string_view oracle, std::string_view as) {
  Baseline findings;
  for (const auto& [cell, measured] : run.cells) {
    if (cell.oracle != oracle) continue;
    LedgerCell renamed = cell;
    renamed.oracle = as;
    findings.cells.emplace(std::move(renamed), measured);
  }
  return findings;
}

double RoundingLength(const RunReport& report, std::size_t question, std::size_t oracle) {
  constexpr double kRoundingsOfAStep = 64;
  const OracleInfo& info = report.oracles[oracle];
  const std::size_t contacts = report.scenarios.size();
  if (question < contacts) {
    const ScenarioResult& result = report.scenarios[question];
    return RoundingOf(info, result.scenario.contact) + result.truth.input_rounding;
  }
  const WorldResult& result = report.worlds[question - contacts];
  const World& world = result.scenario.world;
  return kRoundingsOfAStep * info.unit_roundoff * world.steps *
         SizeOf(world, result.trajectories[oracle]);
}

double FloorOf(MeasureKind measure, double tolerance, double rounding) {
  const double chance = kChance * tolerance;
  return UnitOf(measure) == "m" ? std::max(chance, rounding) : chance;
}

void CompareWithBaseline(RunReport& report, const Baseline& baseline) {
  std::map<std::pair<std::string_view, std::string_view>, double> roundings;
  for (std::size_t q = 0; q < QuestionCount(report); ++q) {
    for (std::size_t o = 0; o < report.oracles.size(); ++o)
      roundings[{IdOf(report, q), report.oracles[o].name}] = RoundingLength(report, q, o);
  }
  for (const Finding& finding : report.findings) {
    const LedgerCell cell = CellOf(finding);
    const auto before = baseline.cells.find(cell);
    if (before == baseline.cells.end()) continue;
    const double rounding = roundings.at({finding.scenario, finding.oracle});
    const std::string why =
        WhyWorse(finding.measure, before->second,
                 {finding.value, finding.verdict,
                  FloorOf(finding.measure, finding.tolerance, rounding)});
    if (why.empty()) continue;
    report.regressions.push_back(
        {finding.oracle,
         fmt::format("{}: {} {}{}{}: {}", finding.scenario, finding.oracle,
                     NameOf(finding.measure), finding.law.empty() ? "" : " of ",
                     finding.law, why)});
  }
}

std::string_view NameOf(ChangeKind kind) {
  constexpr std::array<std::string_view, 5> kNames = {"worse", "no longer judged", "new",
                                                      "gone", "better"};
  return kNames[static_cast<std::size_t>(kind)];
}

bool IsWorse(ChangeKind kind) {
  return kind == ChangeKind::kWorse || kind == ChangeKind::kNotJudged;
}

std::vector<Change> Compare(const Baseline& before, const Baseline& after) {
  std::vector<Change> changes;
  for (const auto& [cell, now] : after.cells) {
    const auto then = before.cells.find(cell);
    if (then == before.cells.end()) {
      if (IsFault(now.verdict)) {
        changes.push_back({ChangeKind::kNew, cell, std::nullopt, now,
                           WhatItIs("is", cell.measure, now)});
      }
      continue;
    }
    if (std::string why = WhyWorse(cell.measure, then->second, now); !why.empty()) {
      const bool is_not_judged = IsNotJudged(then->second.verdict, now.verdict);
      changes.push_back({is_not_judged ? ChangeKind::kNotJudged : ChangeKind::kWorse,
                         cell, then->second, now, std::move(why)});
    } else if (!WhyWorse(cell.measure, now, then->second).empty()) {
      const bool by_verdict = SeverityOf(now.verdict) != SeverityOf(then->second.verdict);
      changes.push_back({ChangeKind::kBetter, cell, then->second, now,
                         by_verdict
                             ? fmt::format("was {}, is {}", NameOf(then->second.verdict),
                                           NameOf(now.verdict))
                             : fmt::format("was {:.3g}, is {:.3g} {}", then->second.value,
                                           now.value, UnitOf(cell.measure))});
    }
  }
  for (const auto& [cell, then] : before.cells) {
    if (after.cells.contains(cell)) continue;
    if (then.verdict == Verdict::kPass) {
      changes.push_back({ChangeKind::kNotJudged, cell, then, std::nullopt,
                         "was pass, is not measured"});
    } else if (IsFault(then.verdict)) {
      changes.push_back({ChangeKind::kGone, cell, then, std::nullopt,
                         WhatItIs("was", cell.measure, then)});
    }
  }
  std::ranges::stable_sort(changes, {}, &Change::kind);
  return changes;
}

}  // namespace touchstone
