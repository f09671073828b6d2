#include "reports/triage/known_faults.h"

#include <algorithm>
#include <set>
#include <tuple>

#include <fmt/format.h>

namespace touchstone {

std::vector<std::string> KnownFaultsLike(const Root& root, const Ledger& ledger) {
  std::set<std::tuple<std::string, Verdict, MeasureKind>> kinds;
  for (const Specimen& specimen : root.specimens) {
    const Finding& finding = specimen.finding;
    kinds.emplace(finding.oracle, finding.verdict, finding.measure);
    for (const Symptom& symptom : specimen.symptoms)
      kinds.emplace(symptom.key.oracle, symptom.key.verdict, symptom.key.measure);
  }
  std::set<std::string> faults;
  for (const LedgerEntry& entry : ledger.entries) {
    if (entry.version != root.key.version) continue;
    if (std::ranges::any_of(entry.measures, [&](MeasureKind measure) {
          return kinds.contains({entry.oracle, entry.verdict, measure});
        })) {
      faults.insert(fmt::format("{} ({})", FaultOf(entry), entry.upstream));
    }
  }
  return {faults.begin(), faults.end()};
}

}  // namespace touchstone
