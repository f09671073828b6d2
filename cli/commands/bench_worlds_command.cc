#include "cli/commands/bench_worlds_command.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <iterator>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "cli/growth.h"
#include "cli/input_error.h"
#include "cli/median.h"
#include "cli/select_oracles.h"
#include "cli/stepping_child.h"
#include "scenarios/generators/crowds.h"

namespace touchstone {
namespace {

struct Scene {
  std::string_view name;
  std::string_view title;
  std::string_view bodies;  ///< Kind of its bodies, shared by scenes of several sizes.
  int size;                 ///< Number of bodies.
  World (*make)(std::uint64_t seed);
};

constexpr std::array kScenes = {
    Scene{"boxes100", "a pile of 100 boxes", "boxes", 100,
          [](std::uint64_t s) { return BoxPile(100, s); }},
    Scene{"boxes1000", "a pile of 1,000 boxes", "boxes", 1000,
          [](std::uint64_t s) { return BoxPile(1000, s); }},
    Scene{"boxes10000", "a pile of 10,000 boxes", "boxes", 10000,
          [](std::uint64_t s) { return BoxPile(10000, s); }},
    Scene{"boxes30000", "a pile of 30,000 boxes", "boxes", 30000,
          [](std::uint64_t s) { return BoxPile(30000, s); }},
    Scene{"stack20", "a stack of 20 boxes", "stacked boxes", 20,
          [](std::uint64_t) { return BoxStack(20); }},
    Scene{"spheres10000", "a pile of 10,000 spheres", "spheres", 10000,
          [](std::uint64_t s) { return SpherePile(10000, s); }},
};

struct Measured {
  double microseconds;  ///< Time per step. [µs]
  double waited;  ///< Fraction of wall time spent waiting for a processor, thread mean.
  WorldQuality quality;
};

struct Row {
  std::string oracle;
  int threads = 1;
  std::optional<Measured> measured;  ///< Empty if the oracle was stopped or crashed.
  std::vector<double>
      turns;              ///< Indexed by turn; empty if the best one counts. [µs/step]
  std::string complaint;  ///< Last line printed to standard error.

  std::string Name() const {
    return threads == 1 ? oracle : fmt::format("{}, {} threads", oracle, threads);
  }
};

struct Runner {
  Row row;
  std::unique_ptr<SteppingChild> child;
  std::vector<StepTime> turns;
};

// An oracle that steps in several threads has two runners: one thread, then several.
std::vector<Runner> Start(std::span<const Oracle* const> oracles, const World& world,
                          const BenchWorldsArguments& arguments) {
  std::vector<Runner> runners;
  const auto start = [&](const Oracle& oracle, int threads) {
    Runner& runner = runners.emplace_back();
    runner.row.oracle = oracle.info().name;
    runner.row.threads = threads;
    runner.child = std::make_unique<SteppingChild>(oracle, world,
                                                   Stepping{threads, arguments.seconds});
  };
  for (const Oracle* oracle : oracles) {
    start(*oracle, 1);
    if (arguments.threads > 1 && oracle->info().steps_in_threads)
      start(*oracle, arguments.threads);
  }
  return runners;
}

std::vector<double> CpuOf(const std::vector<StepTime>& turns) {
  std::vector<double> times;
  times.reserve(turns.size());
  for (const StepTime& turn : turns) times.push_back(turn.cpu);
  return times;
}

// Other processes can only add to wall time, so the best turn is the least disturbed.
Measured BestByWall(const std::vector<StepTime>& turns, int threads) {
  const StepTime& best = *std::min_element(
      turns.begin(), turns.end(),
      [](const StepTime& a, const StepTime& b) { return a.wall < b.wall; });
  return {best.wall, best.waited / (threads * best.wall), {}};
}

// Runs `steps` steps to let the bodies settle, then times as many: the benchmark is a
// pile, not bodies in free fall. The engines take turns, so that a temporary slowdown of
// the machine affects all of them alike.
std::vector<Row> Measure(std::vector<Runner> runners,
                         const BenchWorldsArguments& arguments) {
  constexpr int kTurns = 15;
  const int steps = arguments.steps;
  for (Runner& runner : runners) runner.child->Step(steps);
  const auto until = [&](long turn) { return static_cast<int>(steps * turn / kTurns); };
  for (int turn = 0; turn < kTurns; ++turn) {
    const int now = until(turn + 1) - until(turn);
    if (now == 0) continue;
    for (Runner& runner : runners) {
      const std::optional<StepTime> time = runner.child->Step(now);
      if (time) runner.turns.push_back(*time);
    }
  }
  std::vector<Row> rows;
  for (Runner& runner : runners) {
    const std::optional<WorldQuality> quality = runner.child->Quality();
    if (quality) {
      if (arguments.threads > 1) {
        runner.row.measured = BestByWall(runner.turns, runner.row.threads);
      } else {
        // The median ignores turns that were disturbed.
        runner.row.turns = CpuOf(runner.turns);
        runner.row.measured = Measured{MedianOf(runner.row.turns), 0, {}};
      }
      runner.row.measured->quality = *quality;
    }
    runner.row.complaint = runner.child->LastLine();
    rows.push_back(std::move(runner.row));
  }
  return rows;
}

double TimeOf(const Row& row) {
  return row.measured ? row.measured->microseconds : HUGE_VAL;
}

// Median of the ratios of each turn: a temporary slowdown of the machine affects both
// times of a turn, but not their ratio. The ratio of the medians lacks this property.
double TimesOf(const Row& row, const Row& best) {
  if (row.turns.empty()) return TimeOf(row) / TimeOf(best);
  std::vector<double> times;
  times.reserve(row.turns.size());
  for (std::size_t turn = 0; turn < row.turns.size(); ++turn)
    times.push_back(row.turns[turn] / best.turns[turn]);
  return MedianOf(times);
}

void PrintTable(const Scene& scene, const World& world,
                const BenchWorldsArguments& arguments, std::vector<Row> rows) {
  std::stable_sort(rows.begin(), rows.end(),
                   [](const Row& a, const Row& b) { return TimeOf(a) < TimeOf(b); });
  std::cout << fmt::format(
      "{}: steps {} to {} of {:.4g} ms, {}\n  {:<24}{:>12}{:>9}{:>14}{:>15}{:>14}\n",
      scene.title, arguments.steps + 1, 2 * arguments.steps, 1e3 * world.dt,
      arguments.threads > 1 ? "wall time of the best turn"
                            : "CPU time, medians of the turns",
      "oracle", "µs/step", "of best", "deepest [m]", "fastest [m/s]", "sideways [m]");
  for (const Row& row : rows) {
    if (!row.measured) {
      std::cout << fmt::format("  {:<24}{:>12}\n", row.Name(), "stopped");
      continue;
    }
    const Measured& measured = *row.measured;
    std::cout << fmt::format("  {:<24}{:>11.0f}{:>8.1f}×{:>14.2g}{:>15.2g}{:>14.2g}\n",
                             row.Name(), measured.microseconds,
                             TimesOf(row, rows.front()), measured.quality.deepest,
                             measured.quality.fastest, measured.quality.sideways);
  }
}

// The row for several threads follows the row for one thread.
void PrintSpeedUps(std::span<const Row> rows) {
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const Row& one = rows[i - 1];
    const Row& several = rows[i];
    if (several.threads == 1 || !one.measured || !several.measured) continue;
    std::cout << fmt::format("  {}: {} threads are {:.2f}× as fast as one\n",
                             several.oracle, several.threads,
                             TimeOf(one) / TimeOf(several));
  }
}

// Wall time measures the engine only if no other process needs the processors.
void PrintDisturbances(std::span<const Row> rows) {
  constexpr double kSeen = 0.05;  // Ratios are printed to one decimal.
  for (const Row& row : rows) {
    if (!row.measured || row.measured->waited < kSeen) continue;
    std::cout << fmt::format(
        "  {}: waited for a processor {:.0f} % of that time; expected an idle machine\n",
        row.Name(), 100 * row.measured->waited);
  }
}

// An engine that prints to standard error probably failed at something, whatever its
// time.
void PrintComplaints(std::span<const Row> rows) {
  for (const Row& row : rows) {
    if (row.complaint.empty()) continue;
    std::cout << fmt::format("  {} printed (last line): {}\n", row.Name(), row.complaint);
  }
}

bool StepsInThreads(const Oracle* oracle) {
  return oracle->info().steps_in_threads;
}

}  // namespace

std::vector<std::string> SceneNames() {
  std::vector<std::string> names;
  names.reserve(std::size(kScenes));
  for (const Scene& scene : kScenes) names.emplace_back(scene.name);
  return names;
}

int BenchWorldsCommand(const Session& session, const BenchWorldsArguments& arguments) {
  std::vector<const Oracle*> oracles;
  if (arguments.oracles.empty()) oracles = session.registry.All();
  for (const std::string& name : arguments.oracles) {
    for (const Oracle* oracle : OraclesNamed(session.registry, name))
      oracles.push_back(oracle);
  }
  if (arguments.threads > 1 &&
      std::none_of(oracles.begin(), oracles.end(), StepsInThreads))
    throw InputError(
        "none of these oracles steps in several threads; expected one that does, or no "
        "--threads");
  std::map<std::string_view, std::vector<TimeOfSize>> times;  // Keyed by kind of body.
  for (const Scene& scene : kScenes) {
    const auto& wanted = arguments.scenes;
    if (!wanted.empty() &&
        std::find(wanted.begin(), wanted.end(), scene.name) == wanted.end())
      continue;
    const World world = scene.make(arguments.seed);
    std::vector<const Oracle*> able;
    std::copy_if(oracles.begin(), oracles.end(), std::back_inserter(able),
                 [&](const Oracle* oracle) {
                   return oracle->info().CannotSimulate(world).empty();
                 });
    if (able.empty()) throw InputError("none of these oracles simulates worlds");
    const std::vector<Row> rows = Measure(Start(able, world, arguments), arguments);
    PrintTable(scene, world, arguments, rows);
    PrintSpeedUps(rows);
    PrintDisturbances(rows);
    PrintComplaints(rows);
    std::cout << '\n';
    for (const Row& row : rows) {
      if (row.measured)
        times[scene.bodies].push_back({row.Name(), scene.size, TimeOf(row)});
    }
  }
  if (times.empty()) {
    throw InputError(
        "nothing was measured: every engine was stopped or crashed; expected "
        "more --seconds, fewer --steps or a smaller --scene");
  }
  for (const auto& [bodies, of_sizes] : times) std::cout << GrowthTable(bodies, of_sizes);
  return 0;
}

}  // namespace touchstone
