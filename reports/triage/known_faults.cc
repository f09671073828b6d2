#include "reports/triage/known_faults.h"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "reports/ledger/glob.h"

namespace touchstone {
namespace {

/** Returns whether `entry` is about `question`. */
template <typename Question>
bool IsAbout(const LedgerEntry& entry, const Question& question) {
  return std::ranges::any_of(entry.scenarios, [&](const std::string& glob) {
    return MatchesGlob(glob, question.id);
  });
}

/** Returns whether `entry` is about a question that may show `root` to `oracle`. */
bool MayBe(const Root& root, const LedgerEntry& entry, const Questions& catalogue,
           const OracleInfo& oracle) {
  if (root.key.algorithm.empty()) {
    return std::ranges::any_of(catalogue.worlds, [&](const WorldScenario& world) {
      return IsAbout(entry, world);
    });
  }
  return std::ranges::any_of(catalogue.contacts, [&](const Scenario& scenario) {
    const auto& [A, B] = scenario.contact;
    return MayShow(root.key, std::pair(KindOf(A.shape), KindOf(B.shape)), oracle) &&
           IsAbout(entry, scenario);
  });
}

}  // namespace

std::vector<std::string> KnownFaultsLike(const Root& root, const Ledger& ledger,
                                         const Questions& catalogue) {
  std::set<std::tuple<std::string, Verdict, MeasureKind>> kinds;
  for (const Specimen& specimen : root.specimens) {
    const Finding& finding = specimen.finding;
    kinds.emplace(finding.oracle, finding.verdict, finding.measure);
    for (const Symptom& symptom : specimen.symptoms)
      kinds.emplace(symptom.key.oracle, symptom.key.verdict, symptom.key.measure);
  }
  std::map<std::string, std::set<std::string>> links;  // By fault.
  for (const LedgerEntry& entry : ledger.entries) {
    if (entry.version != root.key.version) continue;
    const bool is_alike = std::ranges::any_of(entry.measures, [&](MeasureKind measure) {
      return kinds.contains({entry.oracle, entry.verdict, measure});
    });
    if (is_alike && MayBe(root, entry, catalogue, root.smallest().oracle->info())) {
      links[FaultOf(entry)].insert(entry.upstream);
    }
  }
  std::vector<std::string> faults;
  faults.reserve(links.size());
  for (const auto& [fault, upstream] : links)
    faults.push_back(fmt::format("{} ({})", fault, fmt::join(upstream, ", ")));
  return faults;
}

}  // namespace touchstone
