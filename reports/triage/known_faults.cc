#include "reports/triage/known_faults.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>

namespace touchstone {

std::vector<std::string> KnownFaultsLike(const Finding& finding, const OracleInfo& oracle,
                                         const Ledger& ledger) {
  const auto has = [](const auto& all, const auto& one) {
    return std::ranges::find(all, one) != all.end();
  };
  std::set<std::string> faults;
  for (const LedgerEntry& entry : ledger.entries) {
    if (entry.oracle != oracle.name || entry.version != oracle.version ||
        entry.verdict != finding.verdict || !has(entry.measures, finding.measure) ||
        (finding.cause != Cause::kNone && !has(entry.causes, finding.cause))) {
      continue;
    }
    faults.insert(fmt::format("{} ({})", FaultOf(entry), entry.upstream));
  }
  return {faults.begin(), faults.end()};
}

}  // namespace touchstone
