#include "cli/commands/bench_command.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "cli/commands/sweep_command.h"
#include "cli/select_oracles.h"
#include "reports/text/counted.h"
#include "reports/writers/describe.h"

namespace touchstone {
namespace {

// A ratio in at most seven characters, as far as programs of their own reach.
std::string Ratio(double ratio) {
  constexpr double kLarge = 1000;
  return ratio < kLarge ? fmt::format("{:.1f}", ratio) : fmt::format("{:.0f}", ratio);
}

void Print(std::vector<TimedQueries> rows) {
  std::stable_sort(
      rows.begin(), rows.end(), [](const TimedQueries& a, const TimedQueries& b) {
        return a.nanoseconds.value_or(HUGE_VAL) < b.nanoseconds.value_or(HUGE_VAL);
      });
  for (const TimedQueries& row : rows) {
    const std::string time =
        row.nanoseconds ? fmt::format("{:>10.0f}{:>7}×", *row.nanoseconds,
                                      Ratio(*row.nanoseconds / *rows.front().nanoseconds))
                        : fmt::format("{:>18}", "not timed");
    const SampleAccuracy& accuracy = row.accuracy;
    const std::string error = accuracy.measured == 0
                                  ? "none given"
                                  : fmt::format("{:.2g}", accuracy.worst_error);
    std::cout << fmt::format("  {:<26}{} {:>16}{:>10}{:>15}{:>11}\n",
                             row.oracle->info().name, time, error, accuracy.measured,
                             accuracy.wrong_verdicts, accuracy.without_answer);
  }
}

void BenchPair(ShapeKind A, ShapeKind B, std::span<const Oracle* const> oracles,
               const BenchArguments& arguments) {
  ContactBench bench = BenchContacts(A, B, oracles, arguments.questions);
  if (bench.rows.empty()) return;
  std::cout << fmt::format(
      "{} {}: {}, {} checked against the truth, {} of them touching\n"
      "  {:<26}{:>10}{:>8} {:>16}{:>10}{:>15}{:>11}\n",
      NameOf(A), NameOf(B), Counted(bench.queries, "random pose"), bench.sample,
      bench.touching, "oracle", "ns/query", "of best", "worst error [m]", "measured",
      "wrong touching", "no answer");
  const bool all_timed =
      std::all_of(bench.rows.begin(), bench.rows.end(),
                  [](const TimedQueries& row) { return row.nanoseconds.has_value(); });
  const bool any_external =
      std::any_of(bench.rows.begin(), bench.rows.end(),
                  [](const TimedQueries& row) { return row.oracle->info().external; });
  Print(std::move(bench.rows));
  if (any_external)
    std::cout << "  a program of its own: wall time, the oracle protocol included\n";
  if (!all_timed)
    std::cout << "  not timed: the oracle has no bare call to time, or runs in its own "
                 "process because it may hang\n";
  std::cout << '\n';
}

}  // namespace

int BenchCommand(const Session& session, const BenchArguments& arguments) {
  std::vector<const Oracle*> oracles;
  if (arguments.oracles.empty()) oracles = session.registry.All();
  for (const std::string& pattern : arguments.oracles) {
    for (const Oracle* oracle : OraclesNamed(session.registry, pattern)) {
      oracles.push_back(oracle);
    }
  }
  if (!arguments.pair.empty()) {
    const auto [A, B] = PairNamed(arguments.pair);
    BenchPair(A, B, oracles, arguments);
    return 0;
  }
  // The shape pairs that the cookbook engine supports.
  BenchPair(ShapeKind::kSphere, ShapeKind::kSphere, oracles, arguments);
  BenchPair(ShapeKind::kSphere, ShapeKind::kBox, oracles, arguments);
  BenchPair(ShapeKind::kBox, ShapeKind::kBox, oracles, arguments);
  return 0;
}

}  // namespace touchstone
