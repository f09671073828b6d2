#include "reports/sweep/question_series.h"

#include <fmt/format.h>

namespace touchstone {

std::string IdOf(const QuestionSeries& series, std::uint64_t index) {
  // Indices have equal width, so that ids sort as indices do.
  return fmt::format("sweep/{}/{}_{}/seed_{}/{}{:020}", NameOf(series.family),
                     NameOf(series.A), NameOf(series.B), series.seed,
                     series.climb == 1 ? "" : fmt::format("climb_{}/", series.climb),
                     index);
}

Scenario ScenarioAt(const QuestionSeries& series, std::uint64_t index) {
  Scenario scenario;
  scenario.id = IdOf(series, index);
  scenario.title =
      fmt::format("Question {} of the family {}, {} and {}, seed {}", index,
                  NameOf(series.family), NameOf(series.A), NameOf(series.B), series.seed);
  scenario.source = ReplayOf(series, index);
  scenario.name_A = 'A';
  scenario.name_B = 'B';
  scenario.contact = Generate(series.family, series.A, series.B, series.seed, index);
  return scenario;
}

std::string ReplayOf(const QuestionSeries& series, std::uint64_t index) {
  return fmt::format(
      "touchstone sweep contact --family {} --pair {} {} --seed {} --first {} --count "
      "1{}",
      NameOf(series.family), NameOf(series.A), NameOf(series.B), series.seed, index,
      series.climb == 1 ? "" : fmt::format(" --climb {}", series.climb));
}

}  // namespace touchstone
