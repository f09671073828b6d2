#include "reports/triage/symptom.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include <fmt/format.h>

namespace touchstone {
namespace {

/** Returns the two shapes of a pair, whatever their order, or the family of worlds. */
std::string SubjectOf(const Series& series) {
  const auto* const contacts = std::get_if<QuestionSeries>(&series);
  if (contacts == nullptr)
    return std::string(NameOf(std::get<WorldSeries>(series).family));
  const auto [first, second] = std::minmax(NameOf(contacts->A), NameOf(contacts->B));
  return fmt::format("{}, {}", first, second);
}

/** Returns the family, and the pair in its order. */
std::string AskedOf(const Series& series) {
  const auto* const contacts = std::get_if<QuestionSeries>(&series);
  if (contacts == nullptr)
    return std::string(NameOf(std::get<WorldSeries>(series).family));
  return fmt::format("{}, {} and {}", NameOf(contacts->family), NameOf(contacts->A),
                     NameOf(contacts->B));
}

/** Orders failures, the gravest first. */
auto GravityOf(const FailedQuestion& failure) {
  return std::tuple(!failure.kind.ending.empty(), failure.kind.band, failure.share);
}

}  // namespace

std::vector<Symptom> SymptomsOf(const SweepFile& file) {
  const SweepSettings& settings = file.settings();
  std::map<Symptom::Key, Symptom> symptoms;
  for (std::size_t s = 0; s < settings.series.size(); ++s) {
    const Series& series = settings.series[s];
    const SeriesTally tally = file.Read(s);
    for (std::size_t o = 0; o < tally.oracles.size(); ++o) {
      const OracleTally& of_oracle = tally.oracles[o];
      const auto symptom_of = [&](const FindingKind& kind) -> Symptom& {
        return symptoms[{settings.subjects[o], SubjectOf(series), kind.measure,
                         kind.verdict, kind.law, kind.ending}];
      };
      for (const auto& [kind, count] : of_oracle.answers) {
        if (!IsFailure(kind.verdict)) continue;
        Rate& rate = symptom_of(kind).rates[AskedOf(series)];
        rate.failed += count;
        rate.asked = of_oracle.asked;
      }
      for (const auto& [kind, failures] : of_oracle.failures) {
        Symptom& symptom = symptom_of(kind);
        const FailedQuestion& worst = failures.front();
        if (symptom.gravest.scenario.empty() ||
            GravityOf(worst) > GravityOf(symptom.gravest)) {
          symptom.gravest = worst;
        }
      }
    }
  }
  std::vector<Symptom> sorted;
  for (auto& [key, symptom] : symptoms) {
    symptom.key = key;
    sorted.push_back(std::move(symptom));
  }
  std::ranges::stable_sort(sorted, [](const Symptom& a, const Symptom& b) {
    return GravityOf(a.gravest) > GravityOf(b.gravest);
  });
  return sorted;
}

}  // namespace touchstone
