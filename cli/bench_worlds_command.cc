#include "cli/bench_worlds_command.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <iostream>
#include <iterator>
#include <optional>
#include <string_view>

#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "cli/input_error.h"
#include "cli/select_oracles.h"
#include "reports/worlds/deepest_penetration.h"
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

// What a child process sends back; plain bytes.
struct Measured {
  double microseconds = 0;  ///< A step.
  double deepest = 0;       ///< Overlap of two bodies at the end. [m]
  double fastest = 0;       ///< Speed of a body at the end. [m/s]
  double sideways = 0;      ///< Farthest way of a body across gravity. [m]
};

struct Row {
  std::string oracle;
  std::optional<Measured> measured;  ///< Empty where it was stopped, or crashed.
};

// CPU time of this thread: what else the machine does is not the engine's work. [s]
double ThreadSeconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

// Written so that a NaN is the largest.
void TakeLarger(double& largest, double value) {
  if (!(value <= largest) && !std::isnan(largest)) largest = value;
}

void Assess(const World& world, const WorldState& state, Measured& row) {
  row.deepest = DeepestPenetration(world, state).depth;
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    if (world.bodies[i].mass == 0) continue;
    Eigen::Vector3d moved = state.bodies[i].p_WB - world.bodies[i].placed.X_WB.p_WB;
    moved.y() = 0;
    TakeLarger(row.fastest, state.bodies[i].v_WB.norm());
    TakeLarger(row.sideways, moved.norm());
  }
}

// Steps to settle, then as many that are timed: the work of a pile, not of a rain.
Measured Measure(const Oracle& oracle, const World& world, int steps) {
  Measured measured;
  const std::unique_ptr<Simulation> simulation = oracle.BeginAsShipped(world);
  for (int i = 0; i < steps; ++i) simulation->Step();
  const double settled = ThreadSeconds();
  for (int i = 0; i < steps; ++i) simulation->Step();
  measured.microseconds = 1e6 * (ThreadSeconds() - settled) / steps;
  WorldState state;
  simulation->Read(state);
  Assess(world, state, measured);
  return measured;
}

// In a child process, so that an engine that takes hours for a step, or dies of it, loses
// this row only.
std::optional<Measured> MeasureInChild(const Oracle& oracle, const World& world,
                                       int steps, int seconds) {
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) throw InputError("no pipe to a child process");
  std::cout.flush();
  const pid_t child = fork();
  if (child < 0) throw InputError("no child process");
  if (child == 0) {
    const rlimit limit{static_cast<rlim_t>(seconds), static_cast<rlim_t>(seconds)};
    setrlimit(RLIMIT_CPU, &limit);
    const Measured measured = Measure(oracle, world, steps);
    const ssize_t sent = write(ends[1], &measured, sizeof measured);
    _exit(sent == sizeof measured ? 0 : 1);
  }
  close(ends[1]);
  Measured measured;
  const bool whole = read(ends[0], &measured, sizeof measured) == sizeof measured;
  close(ends[0]);
  waitpid(child, nullptr, 0);
  if (!whole) return std::nullopt;
  return measured;
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
    std::cout << fmt::format("  {:<24}{:>11.0f}{:>8.1f}×{:>14.2g}{:>15.2g}{:>14.2g}\n",
                             row.oracle, measured.microseconds,
                             measured.microseconds / TimeOf(rows.front()),
                             measured.deepest, measured.fastest, measured.sideways);
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
    std::vector<Row> rows;
    for (const Oracle* oracle : oracles) {
      if (!oracle->info().CannotSimulate(world).empty()) continue;
      rows.push_back({oracle->info().name, MeasureInChild(*oracle, world, arguments.steps,
                                                          arguments.seconds)});
    }
    if (rows.empty()) throw InputError("none of these oracles simulates worlds");
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
