#include "reports/triage/sweep_failures.h"

#include <filesystem>
#include <utility>

#include <fmt/format.h>

#include "scenarios/scenario_file.h"

namespace touchstone {
namespace {

/** Returns Symptom::Key::of the questions of a series. */
std::string SubjectOf(const Series& series) {
  const auto pair = PairOf(series);
  return pair ? PairName(pair->first, pair->second) : OriginOf(series);
}

/** Returns the path of a file as a stranger may read it: not where a home is. */
std::string PublicPath(const std::string& file) {
  const std::filesystem::path path(file);
  if (!path.is_absolute()) return file;
  // A path that ends with a slash has no file name.
  return (path.has_filename() ? path : path.parent_path()).filename().string();
}

/** Returns the family or the file, and the pair in its order. */
std::string AskedOf(const Series& series) {
  const auto pair = PairOf(series);
  if (!pair) return OriginOf(series);
  const std::string origin = IsOfFile(series) ? "the file " + PublicPath(OriginOf(series))
                             : IsSearch(series) ? "worst cases of " + OriginOf(series)
                                                : OriginOf(series);
  return fmt::format("{}, {} and {}", origin, NameOf(pair->first), NameOf(pair->second));
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

Failures FailuresOf(const SweepFile& file, const std::set<std::string>& oracles) {
  const SweepSettings& settings = file.settings();
  Failures result;
  Symptoms symptoms;
  for (std::size_t s = 0; s < settings.series.size(); ++s) {
    const Series& series = settings.series[s];
    const SeriesTally tally = file.Read(s);
    for (std::size_t o = 0; o < tally.oracles.size(); ++o) {
      if (!oracles.contains(settings.subjects[o])) continue;
      const OracleTally& of_oracle = tally.oracles[o];
      AddAnswers(of_oracle, settings.subjects[o], SubjectOf(series), AskedOf(series),
                 symptoms, result);
      std::uint64_t answered = of_oracle.asked;
      for (const auto& [kind, count] : of_oracle.answers) {
        if (kind.verdict == Verdict::kUnsupported) answered -= count;
      }
      result.asked.push_back(
          {settings.subjects[o], AskedOf(series), PairOf(series), answered});
    }
  }
  for (const auto& [key, symptom] : symptoms) {
    for (const FailedQuestion& failure : symptom.kept) RequireReadable(failure, file);
  }
  result.symptoms = GravestFirst(symptoms);
  return result;
}

}  // namespace touchstone
