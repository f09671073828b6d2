#include "reports/triage/symptom.h"

#include <algorithm>
#include <functional>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "scenarios/scenario_file.h"

namespace touchstone {
namespace {

/** Returns the two shapes of a pair, whatever their order, or the family of worlds. */
std::string SubjectOf(const Series& series) {
  const auto pair = PairOf(series);
  if (!pair) return OriginOf(series);
  const auto [first, second] = std::minmax(NameOf(pair->first), NameOf(pair->second));
  return fmt::format("{}, {}", first, second);
}

/** Returns the family or the file, and the pair in its order. */
std::string AskedOf(const Series& series) {
  const auto pair = PairOf(series);
  if (!pair) return OriginOf(series);
  return fmt::format("{}{}, {} and {}", IsOfFile(series) ? "the file " : "",
                     OriginOf(series), NameOf(pair->first), NameOf(pair->second));
}

/** The greatest number of questions that stay with a symptom. */
constexpr std::size_t kKept = 4;

/** Orders failures by gravity. */
std::tuple<bool, Grade, double> GravityOf(const FailedQuestion& failure) {
  return {!failure.kind.ending.empty(), failure.kind.band, failure.share};
}

bool IsFault(Verdict verdict) {
  return IsFailure(verdict) && verdict != Verdict::kDisagree;
}

void RequireReadable(const FailedQuestion& failure, const SweepFile& file) {
  const ReadResult read = ReadScenario(failure.scenario, file.file().string());
  if (read.scenario || read.world) return;
  throw SweepFileError(
      fmt::format("{}: damaged: a kept question cannot be read; expected a file that "
                  "`touchstone sweep` wrote",
                  file.file().string()));
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
                         kind.verdict, kind.law, kind.ending, kind.touching}];
      };
      for (const auto& [kind, count] : of_oracle.answers) {
        if (!IsFault(kind.verdict)) continue;
        Rate& rate = symptom_of(kind).rates[AskedOf(series)];
        rate.failed += count;
        rate.asked = of_oracle.asked;
      }
      for (const auto& [kind, failures] : of_oracle.failures) {
        if (!IsFault(kind.verdict)) continue;
        std::vector<FailedQuestion>& kept = symptom_of(kind).kept;
        kept.insert(kept.end(), failures.begin(), failures.end());
      }
    }
  }
  std::vector<Symptom> sorted;
  for (auto& [key, symptom] : symptoms) {
    symptom.key = key;
    std::ranges::stable_sort(symptom.kept, std::greater{}, GravityOf);
    symptom.kept.resize(std::min(symptom.kept.size(), kKept));
    for (const FailedQuestion& failure : symptom.kept) RequireReadable(failure, file);
    if (!symptom.kept.empty()) sorted.push_back(std::move(symptom));
  }
  std::ranges::stable_sort(sorted, [](const Symptom& a, const Symptom& b) {
    return GravityOf(a.kept.front()) > GravityOf(b.kept.front());
  });
  return sorted;
}

}  // namespace touchstone
