#include "reports/triage/symptom.h"

#include <algorithm>
#include <functional>
#include <tuple>

namespace touchstone {
namespace {

/** The greatest number of questions that stay with a symptom. */
constexpr std::size_t kKept = 4;

/** Orders failures by gravity. */
std::tuple<bool, Grade, double> GravityOf(const FailedQuestion& failure) {
  return {!failure.kind.ending.empty(), failure.kind.band, failure.share};
}

bool IsFault(Verdict verdict) {
  return IsFailure(verdict) && verdict != Verdict::kDisagree;
}

}  // namespace

std::vector<Symptom> GravestFirst(const Symptoms& symptoms) {
  std::vector<Symptom> sorted;
  for (const auto& [key, found] : symptoms) {
    if (found.kept.empty()) continue;
    Symptom& symptom = sorted.emplace_back(found);
    symptom.key = key;
    std::ranges::stable_sort(symptom.kept, std::greater{}, GravityOf);
    symptom.kept.resize(std::min(symptom.kept.size(), kKept));
  }
  std::ranges::stable_sort(sorted, [](const Symptom& a, const Symptom& b) {
    return GravityOf(a.kept.front()) > GravityOf(b.kept.front());
  });
  return sorted;
}

void AddAnswers(const OracleTally& tally, const std::string& oracle,
                const std::string& of, const std::string& what, Symptoms& symptoms,
                Failures& failures) {
  const auto symptom_of = [&](const FindingKind& kind) -> Symptom& {
    return symptoms[{oracle, of, kind.measure, kind.verdict, kind.law, kind.ending,
                     kind.touching}];
  };
  for (const auto& [kind, count] : tally.answers) {
    if (kind.verdict == Verdict::kDisagree) failures.unproved += count;
    if (!IsFault(kind.verdict)) continue;
    symptom_of(kind).failed[what] += count;
    failures.failed += count;
  }
  for (const auto& [kind, kept] : tally.failures) {
    if (!IsFault(kind.verdict)) continue;
    std::vector<FailedQuestion>& of_symptom = symptom_of(kind).kept;
    of_symptom.insert(of_symptom.end(), kept.begin(), kept.end());
  }
}

}  // namespace touchstone
