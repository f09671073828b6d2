#include "cli/commands/bench_worlds_command.h"

#include <algorithm>
#include <iostream>
#include <iterator>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include <fmt/format.h>

#include "cli/input_error.h"
#include "cli/select_oracles.h"
#include "reports/bench/growth.h"
#include "reports/bench/scene.h"

namespace touchstone {
namespace {

void PrintTable(const Scene& scene, const World& world, const TurnSettings& turns,
                std::vector<TimedSteps> rows) {
  std::stable_sort(rows.begin(), rows.end(),
                   [](const TimedSteps& a, const TimedSteps& b) {
                     return a.Microseconds() < b.Microseconds();
                   });
  std::cout << fmt::format(
      "{}: steps {} to {} of {:.4g} ms, {}\n  {:<24}{:>12}{:>9}{:>14}{:>15}{:>14}\n",
      scene.title, turns.steps + 1, 2 * turns.steps, 1e3 * world.dt,
      turns.threads > 1 ? "wall time of the best turn" : "CPU time, medians of the turns",
      "oracle", "µs/step", "of best", "deepest [m]", "fastest [m/s]", "sideways [m]");
  for (const TimedSteps& row : rows) {
    if (!row.measured) {
      std::cout << fmt::format("  {:<24}{:>12}\n", row.Name(), "stopped");
      continue;
    }
    const MeasuredSteps& measured = *row.measured;
    std::cout << fmt::format("  {:<24}{:>11.0f}{:>8.1f}×{:>14.2g}{:>15.2g}{:>14.2g}\n",
                             row.Name(), measured.microseconds,
                             RatioOf(row, rows.front()), measured.quality.deepest,
                             measured.quality.fastest, measured.quality.sideways);
  }
}

// The row for several threads follows the row for one thread.
void PrintSpeedUps(std::span<const TimedSteps> rows) {
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const TimedSteps& one = rows[i - 1];
    const TimedSteps& several = rows[i];
    if (several.threads == 1 || !one.measured || !several.measured) continue;
    std::cout << fmt::format("  {}: {} threads are {:.2f}× as fast as one\n",
                             several.oracle, several.threads,
                             one.Microseconds() / several.Microseconds());
  }
}

// Wall time measures the engine only if no other process needs the processors.
void PrintDisturbances(std::span<const TimedSteps> rows) {
  constexpr double kSeen = 0.05;  // Ratios are printed to one decimal.
  for (const TimedSteps& row : rows) {
    if (!row.measured || row.measured->waited < kSeen) continue;
    std::cout << fmt::format(
        "  {}: waited for a processor {:.0f} % of that time; expected an idle machine\n",
        row.Name(), 100 * row.measured->waited);
  }
}

void PrintReasons(std::span<const TimedSteps> rows) {
  for (const TimedSteps& row : rows) {
    if (row.measured) continue;
    std::cout << fmt::format("  {} stopped: {}\n", row.Name(), row.reason);
  }
}

// An engine that prints to standard error probably failed at something, whatever its
// time.
void PrintComplaints(std::span<const TimedSteps> rows) {
  for (const TimedSteps& row : rows) {
    if (row.complaint.empty() || row.reason.ends_with(row.complaint)) continue;
    std::cout << fmt::format("  {} printed (last line): {}\n", row.Name(), row.complaint);
  }
}

bool StepsInThreads(const Oracle* oracle) {
  return oracle->info().steps_in_threads;
}

std::vector<TimedSteps> Time(std::span<const Oracle* const> oracles, const World& world,
                             const TurnSettings& turns) {
  try {
    return TimeInTurns(oracles, world, turns);
  } catch (const std::system_error& error) {
    throw InputError(fmt::format("cannot create a child process: {}", error.what()));
  }
}

}  // namespace

int BenchWorldsCommand(const Session& session, const BenchWorldsArguments& arguments) {
  std::vector<const Oracle*> oracles;
  if (arguments.oracles.empty()) oracles = session.registry.All();
  for (const std::string& name : arguments.oracles) {
    for (const Oracle* oracle : OraclesNamed(session.registry, name))
      oracles.push_back(oracle);
  }
  if (arguments.turns.threads > 1 &&
      std::none_of(oracles.begin(), oracles.end(), StepsInThreads))
    throw InputError(
        "none of these oracles steps in several threads; expected one that does, or no "
        "--threads");
  std::map<std::string_view, std::vector<TimeOfSize>> times;  // Keyed by kind of body.
  for (const Scene& scene : Scenes()) {
    const auto& wanted = arguments.scenes;
    if (!wanted.empty() &&
        std::find(wanted.begin(), wanted.end(), scene.name) == wanted.end())
      continue;
    const World world = scene.make(arguments.seed);
    std::vector<const Oracle*> able;
    std::copy_if(oracles.begin(), oracles.end(), std::back_inserter(able),
                 [&](const Oracle* oracle) {
                   // A program returns whole motions, so single steps cannot be timed.
                   return !oracle->info().external &&
                          oracle->info().CannotSimulate(world).empty();
                 });
    if (able.empty()) {
      std::cout << scene.name << ": none of these oracles simulates it\n\n";
      continue;
    }
    const std::vector<TimedSteps> rows = Time(able, world, arguments.turns);
    PrintTable(scene, world, arguments.turns, rows);
    PrintSpeedUps(rows);
    PrintDisturbances(rows);
    PrintReasons(rows);
    PrintComplaints(rows);
    std::cout << '\n';
    for (const TimedSteps& row : rows) {
      if (row.measured)
        times[scene.bodies].push_back({row.Name(), scene.size, row.Microseconds()});
    }
  }
  if (times.empty()) {
    throw InputError(
        "nothing was measured: every engine was stopped, crashed or does not simulate "
        "these scenes; expected more --seconds, fewer --steps or another --scene");
  }
  for (const auto& [bodies, of_sizes] : times) std::cout << GrowthTable(bodies, of_sizes);
  return 0;
}

}  // namespace touchstone
