#include "reports/sweep/world_series.h"

#include <fmt/format.h>

namespace touchstone {

std::string IdOf(const WorldSeries& series, std::uint64_t index) {
  // Indices have equal width, so that ids sort as indices do.
  return fmt::format("sweep/world/{}/seed_{}/{:020}", NameOf(series.family), series.seed,
                     index);
}

WorldScenario WorldAt(const WorldSeries& series, std::uint64_t index) {
  WorldScenario scenario = GenerateWorld(series.family, series.seed, index);
  scenario.id = IdOf(series, index);
  scenario.title = fmt::format("{} (world {} of the family {}, seed {})", scenario.title,
                               index, NameOf(series.family), series.seed);
  scenario.source = ReplayOf(series, index);
  return scenario;
}

std::string ReplayOf(const WorldSeries& series, std::uint64_t index) {
  return fmt::format("touchstone sweep world --family {} --seed {} --first {} --count 1",
                     NameOf(series.family), series.seed, index);
}

}  // namespace touchstone
