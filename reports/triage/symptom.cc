#include "reports/triage/symptom.h"

#include <algorithm>
#include <functional>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "reports/triage/kept_question.h"

namespace touchstone {
namespace {

/** The greatest number of questions that stay with a symptom. */
constexpr std::size_t kKept = 4;

/** The gravest failure has the largest. */
std::pair<Grade, double> GradeAndShareOf(const FailedQuestion& failure) {
  return {failure.kind.grade, failure.share};
}

/** Returns `kKept` of `failures`: of the gravest grade first, and of one grade the
 * plainest.
 */
std::vector<FailedQuestion> PlainestOf(const std::vector<FailedQuestion>& failures) {
  using Ranked = std::tuple<Grade, std::pair<int, Size>, const FailedQuestion*>;
  std::vector<Ranked> ranked;
  ranked.reserve(failures.size());
  for (const FailedQuestion& failure : failures)
    ranked.emplace_back(failure.kind.grade, PlainnessOf(QuestionOf(failure)), &failure);
  std::ranges::stable_sort(ranked, [](const Ranked& a, const Ranked& b) {
    if (std::get<Grade>(a) != std::get<Grade>(b))
      return std::get<Grade>(a) > std::get<Grade>(b);
    return std::get<1>(a) < std::get<1>(b);
  });
  std::vector<FailedQuestion> plainest;
  for (std::size_t i = 0; i < std::min(ranked.size(), kKept); ++i)
    plainest.push_back(*std::get<2>(ranked[i]));
  return plainest;
}

}  // namespace

bool IsFault(Verdict verdict) {
  return IsFailure(verdict) && verdict != Verdict::kDisagree;
}

std::string PairName(ShapeKind a, ShapeKind b) {
  const auto [first, second] = std::minmax(NameOf(a), NameOf(b));
  return fmt::format("{} and {}", first, second);
}

std::vector<Symptom> GravestFirst(const Symptoms& symptoms) {
  std::vector<std::pair<std::pair<Grade, double>, Symptom>> by_size;
  for (const auto& [key, found] : symptoms) {
    if (found.kept.empty()) continue;
    const FailedQuestion& gravest =
        *std::ranges::max_element(found.kept, {}, GradeAndShareOf);
    Symptom symptom{.key = key,
                    .kept = PlainestOf(found.kept),
                    .failed = found.failed,
                    .grades = found.grades};
    by_size.emplace_back(GradeAndShareOf(gravest), std::move(symptom));
  }
  std::ranges::stable_sort(by_size, std::greater{},
                           [](const auto& entry) { return entry.first; });
  std::vector<Symptom> sorted;
  sorted.reserve(by_size.size());
  for (auto& [size, symptom] : by_size) sorted.push_back(std::move(symptom));
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
    symptom.grades[kind.grade] += count;
    failures.failed += count;
  }
  for (const auto& [kind, kept] : tally.failures) {
    if (!IsFault(kind.verdict)) continue;
    std::vector<FailedQuestion>& of_symptom = symptom_of(kind).kept;
    of_symptom.insert(of_symptom.end(), kept.begin(), kept.end());
  }
}

}  // namespace touchstone
