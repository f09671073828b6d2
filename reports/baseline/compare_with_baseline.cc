#include <algorithm>
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

/** The lengths by which rounding alone may change an answer, keyed by scenario and
 oracle. For a motion that is 64 roundings in each step, as the laws grant. [m] */
using Roundings = std::map<std::pair<std::string_view, std::string_view>, double>;

Roundings RoundingsOf(const RunReport& report) {
  constexpr double kRoundingsOfAStep = 64;
  Roundings roundings;
  for (std::size_t o = 0; o < report.oracles.size(); ++o) {
    const OracleInfo& oracle = report.oracles[o];
    for (const ScenarioResult& result : report.scenarios) {
      roundings[{result.scenario.id, oracle.name}] =
          RoundingOf(oracle, result.scenario.contact) + result.truth.input_rounding;
    }
    for (const WorldResult& result : report.worlds) {
      const World& world = result.scenario.world;
      roundings[{result.scenario.id, oracle.name}] =
          kRoundingsOfAStep * oracle.unit_roundoff * world.steps *
          SizeOf(world, result.trajectories[o]);
    }
  }
  return roundings;
}

/** Returns the value of a finding of one cell that rounding alone may cause. */
double FloorOf(const Finding& finding, const Roundings& roundings) {
  const double chance = kChance * finding.tolerance;
  if (UnitOf(finding.measure) != "m") return chance;
  return std::max(chance, roundings.at({finding.scenario, finding.oracle}));
}

/** Returns why a finding is worse than a baseline; "" if it is not. */
std::string WhyWorse(const Finding& finding, const Baseline::Measured& before,
                     const Roundings& roundings) {
  if (SeverityOf(finding.verdict) > SeverityOf(before.verdict))
    return fmt::format("was {}, is {}", NameOf(before.verdict), NameOf(finding.verdict));
  const double floor = FloorOf(finding, roundings);
  // Written so that a number that becomes a NaN is worse.
  if (std::isnan(before.value) || finding.value <= kWorse * std::max(before.value, floor))
    return "";
  return fmt::format("was {:.3g}, is {:.3g} {}", before.value, finding.value,
                     UnitOf(finding.measure));
}

}  // namespace

void CompareWithBaseline(RunReport& report, const Baseline& baseline) {
  const Roundings roundings = RoundingsOf(report);
  for (const Finding& finding : report.findings) {
    const LedgerCell cell = CellOf(finding);
    const auto before = baseline.cells.find(cell);
    if (before == baseline.cells.end()) continue;
    const std::string why = WhyWorse(finding, before->second, roundings);
    if (why.empty()) continue;
    report.regressions.push_back(
        {finding.oracle,
         fmt::format("{}: {} {}{}{}: {}", finding.scenario, finding.oracle,
                     NameOf(finding.measure), finding.law.empty() ? "" : " of ",
                     finding.law, why)});
  }
}

}  // namespace touchstone
