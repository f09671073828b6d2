#include "reports/triage/symptom.h"

#include <algorithm>
#include <functional>
#include <tuple>
#include <utility>

#include "reports/shrink/size.h"
#include "scenarios/scenario_file.h"

namespace touchstone {
namespace {

/** The greatest number of questions that stay with a symptom. */
constexpr std::size_t kKept = 4;

/** Orders failures by gravity, but for their share. */
std::pair<bool, Grade> BandOf(const FailedQuestion& failure) {
  return {!failure.kind.ending.empty(), failure.kind.band};
}

/** Orders failures by gravity. */
std::tuple<bool, Grade, double> GravityOf(const FailedQuestion& failure) {
  return {!failure.kind.ending.empty(), failure.kind.band, failure.share};
}

/** Returns the size of the question of a failure. */
Size SizeOf(const FailedQuestion& failure) {
  ReadResult read = ReadScenario(failure.scenario, "a kept failure");
  return read.world ? touchstone::SizeOf(std::move(*read.world))
                    : touchstone::SizeOf(std::move(read.scenario.value()));
}

/** Returns `kKept` of `failures`: the gravest band first, and in it the simplest. */
std::vector<FailedQuestion> SimplestOf(const std::vector<FailedQuestion>& failures) {
  // One of everyday sizes is preferred to one with less to read.
  std::vector<std::pair<const FailedQuestion*, std::pair<int, Size>>> sized;
  sized.reserve(failures.size());
  for (const FailedQuestion& failure : failures) {
    const Size size = SizeOf(failure);
    sized.emplace_back(&failure, std::pair(size.decades, size));
  }
  std::ranges::stable_sort(sized, [](const auto& a, const auto& b) {
    const auto band_a = BandOf(*a.first);
    const auto band_b = BandOf(*b.first);
    return band_a != band_b ? band_a > band_b : a.second < b.second;
  });
  std::vector<FailedQuestion> simplest;
  for (std::size_t i = 0; i < std::min(sized.size(), kKept); ++i)
    simplest.push_back(*sized[i].first);
  return simplest;
}

bool IsFault(Verdict verdict) {
  return IsFailure(verdict) && verdict != Verdict::kDisagree;
}

}  // namespace

std::vector<Symptom> GravestFirst(const Symptoms& symptoms) {
  std::vector<std::pair<std::tuple<bool, Grade, double>, Symptom>> by_gravity;
  for (const auto& [key, found] : symptoms) {
    if (found.kept.empty()) continue;
    const FailedQuestion& gravest = *std::ranges::max_element(found.kept, {}, GravityOf);
    Symptom symptom{.key = key,
                    .kept = SimplestOf(found.kept),
                    .failed = found.failed,
                    .bands = found.bands};
    by_gravity.emplace_back(GravityOf(gravest), std::move(symptom));
  }
  std::ranges::stable_sort(by_gravity, std::greater{},
                           [](const auto& entry) { return entry.first; });
  std::vector<Symptom> sorted;
  sorted.reserve(by_gravity.size());
  for (auto& [gravity, symptom] : by_gravity) sorted.push_back(std::move(symptom));
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
    Symptom& symptom = symptom_of(kind);
    symptom.failed[what] += count;
    symptom.bands[kind.ending.empty() ? static_cast<Band>(kind.band) : Band::kWrong] +=
        count;
    failures.failed += count;
  }
  for (const auto& [kind, kept] : tally.failures) {
    if (!IsFault(kind.verdict)) continue;
    std::vector<FailedQuestion>& of_symptom = symptom_of(kind).kept;
    of_symptom.insert(of_symptom.end(), kept.begin(), kept.end());
  }
}

}  // namespace touchstone
