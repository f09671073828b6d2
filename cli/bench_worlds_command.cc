#include "cli/bench_worlds_command.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <iterator>
#include <memory>
#include <optional>
#include <span>
#include <string_view>

#include <fmt/format.h>

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
  World (*make)(std::uint64_t seed);
};

constexpr std::array kScenes = {
    Scene{"boxes100", "a pile of 100 boxes",
          [](std::uint64_t s) { return BoxPile(100, s); }},
    Scene{"boxes1000", "a pile of 1,000 boxes",
          [](std::uint64_t s) { return BoxPile(1000, s); }},
    Scene{"boxes10000", "a pile of 10,000 boxes",
          [](std::uint64_t s) { return BoxPile(10000, s); }},
    Scene{"boxes30000", "a pile of 30,000 boxes",
          [](std::uint64_t s) { return BoxPile(30000, s); }},
    Scene{"stack20", "a stack of 20 boxes", [](std::uint64_t) { return BoxStack(20); }},
    Scene{"spheres10000", "a pile of 10,000 spheres",
          [](std::uint64_t s) { return SpherePile(10000, s); }},
};

struct Measured {
  double microseconds;  ///< A step.
  WorldQuality quality;
};

struct Row {
  std::string oracle;
  std::optional<Measured> measured;  ///< Empty where it was stopped, or crashed.
};

// Steps to settle, then as many that are timed: the work of a pile, not of a rain. The
// engines take turns: what slows the machine for a while slows all alike, and the median
// turn is not disturbed.
std::vector<Row> Measure(std::span<const Oracle* const> oracles, const World& world,
                         int steps, int seconds) {
  constexpr int kTurns = 15;
  struct Runner {
    std::unique_ptr<SteppingChild> child;
    std::vector<double> microseconds;
  };
  std::vector<Runner> runners;
  for (const Oracle* oracle : oracles) {
    runners.push_back({std::make_unique<SteppingChild>(*oracle, world, seconds), {}});
    runners.back().child->Step(steps);
  }
  const auto until = [&](long turn) { return static_cast<int>(steps * turn / kTurns); };
  for (int turn = 0; turn < kTurns; ++turn) {
    const int now = until(turn + 1) - until(turn);
    if (now == 0) continue;
    for (Runner& runner : runners) {
      const std::optional<double> time = runner.child->Step(now);
      if (time) runner.microseconds.push_back(*time);
    }
  }
  std::vector<Row> rows;
  for (std::size_t i = 0; i < oracles.size(); ++i) {
    Row& row = rows.emplace_back(Row{oracles[i]->info().name, std::nullopt});
    const std::optional<WorldQuality> quality = runners[i].child->Quality();
    if (quality) row.measured = {MedianOf(runners[i].microseconds), *quality};
  }
  return rows;
}

double TimeOf(const Row& row) {
  return row.measured ? row.measured->microseconds : HUGE_VAL;
}

void Print(const Scene& scene, const World& world, int steps, std::vector<Row> rows) {
  std::stable_sort(rows.begin(), rows.end(),
                   [](const Row& a, const Row& b) { return TimeOf(a) < TimeOf(b); });
  std::cout << fmt::format(
      "{}: steps {} to {} of {:.4g} ms\n  {:<24}{:>12}{:>9}{:>14}{:>15}{:>14}\n",
      scene.title, steps + 1, 2 * steps, 1e3 * world.dt, "oracle", "µs/step", "of best",
      "deepest [m]", "fastest [m/s]", "sideways [m]");
  for (const Row& row : rows) {
    if (!row.measured) {
      std::cout << fmt::format("  {:<24}{:>12}\n", row.oracle, "stopped");
      continue;
    }
    const Measured& measured = *row.measured;
    std::cout << fmt::format(
        "  {:<24}{:>11.0f}{:>8.1f}×{:>14.2g}{:>15.2g}{:>14.2g}\n", row.oracle,
        measured.microseconds, measured.microseconds / TimeOf(rows.front()),
        measured.quality.deepest, measured.quality.fastest, measured.quality.sideways);
  }
  std::cout << '\n';
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
  bool any_measured = false;
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
    std::vector<Row> rows = Measure(able, world, arguments.steps, arguments.seconds);
    any_measured = any_measured ||
                   std::any_of(rows.begin(), rows.end(),
                               [](const Row& row) { return row.measured.has_value(); });
    Print(scene, world, arguments.steps, std::move(rows));
  }
  if (!any_measured) {
    throw InputError(
        "nothing was measured: every engine was stopped or crashed; expected "
        "more --seconds, fewer --steps or a smaller --scene");
  }
  return 0;
}

}  // namespace touchstone
