#include "reports/worlds/study/run_worlds.h"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <optional>
#include <utility>

#include <malloc.h>

#include "oracles/isolation/motion_store.h"
#include "oracles/stopwatch.h"
#include "reports/threads/parallel_for.h"
#include "reports/worlds/study/as_shipped.h"
#include "reports/worlds/study/body_steps.h"
#include "reports/worlds/study/judge_world.h"
#include "reports/worlds/study/motion_scale.h"

namespace touchstone {
namespace {

/** Returns the approximate cost of all simulations of one world by one oracle.
 [body-steps] */
double WorkOf(const WorldScenario& scenario) {
  // The step itself, half and a quarter of it, two moved starts, and five variants.
  const double times = IsStudied(scenario) ? 1 + 2 + 4 + 2 + 5 : 1;
  const int members = scenario.ensemble ? scenario.ensemble->members : 1;
  return BodySteps(scenario.world) * (times + members - 1);
}

/** The indices of a world and an oracle. */
struct Pair {
  std::size_t world;
  std::size_t oracle;
};

std::vector<Pair> PairsOf(std::span<const WorldScenario> worlds,
                          std::span<const Oracle* const> oracles) {
  std::vector<Pair> pairs;
  for (std::size_t w = 0; w < worlds.size(); ++w) {
    for (std::size_t o = 0; o < oracles.size(); ++o) {
      if (oracles[o]->info().simulates) pairs.push_back({w, o});
    }
  }
  return pairs;
}

/** Returns the order in which the pairs are simulated: the most expensive first, so that
 the last ones are short and no core idles for long at the end. */
std::vector<std::size_t> LongestFirst(std::span<const Pair> pairs,
                                      std::span<const WorldScenario> worlds) {
  std::vector<double> works;
  for (const WorldScenario& scenario : worlds) works.push_back(WorkOf(scenario));
  std::vector<std::size_t> order(pairs.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return works[pairs[a].world] > works[pairs[b].world];
  });
  return order;
}

/** Returns the result of one pair: a kept one, or a new one, which is then kept. */
Examination Examined(const WorldScenario& scenario, const Oracle& oracle,
                     const WorldsOptions& options) {
  if (options.find) {
    if (auto kept = options.find(scenario, oracle.info())) return std::move(*kept);
  }
  const Stopwatch all;
  Examination examined = ExamineWorld(scenario, oracle);
  const Stopwatch shipped;
  CompareWithShipped(scenario, oracle, examined.trajectory, examined.findings);
  examined.seconds.motions["as shipped"] = shipped.seconds();
  GradeFaults(ScaleOf(scenario.world, examined.trajectory.samples), examined.findings);
  SortByMeasure(examined.findings);
  examined.seconds.all = all.seconds();
  // The signal that stops this program may have killed the engine's process, too.
  const bool is_stopped = IsStopped(options.stop);
  if (options.keep && !is_stopped) options.keep(scenario, oracle.info(), examined);
  return examined;
}

}  // namespace

std::size_t CountOfWorldRuns(std::span<const WorldScenario> worlds,
                             std::span<const Oracle* const> oracles) {
  return PairsOf(worlds, oracles).size();
}

double WorkOfWorlds(std::span<const WorldScenario> worlds,
                    std::span<const Oracle* const> oracles) {
  double work = 0;
  for (const Pair& pair : PairsOf(worlds, oracles)) work += WorkOf(worlds[pair.world]);
  return work;
}

WorldsReport RunWorlds(std::span<const WorldScenario> worlds,
                       std::span<const Oracle* const> oracles,
                       const WorldsOptions& options) {
  WorldsReport report;
  for (const WorldScenario& scenario : worlds)
    report.worlds.push_back({scenario, std::vector<Trajectory>(oracles.size()),
                             std::vector<MotionDrifts>(oracles.size()),
                             std::vector<EnsembleStatistics>(oracles.size()),
                             std::vector<WorldSeconds>(oracles.size())});
  const std::vector<Pair> pairs = PairsOf(worlds, oracles);
  std::vector<std::vector<Finding>> findings(pairs.size());
  MotionStore motions;
  std::vector<std::optional<MotionStore::Place>> places(pairs.size());
  const std::vector<std::size_t> order = LongestFirst(pairs, worlds);
  ParallelFor(pairs.size(), options.jobs, [&](std::size_t turn) {
    const std::size_t i = order[turn];
    const auto [w, o] = pairs[i];
    if (IsStopped(options.stop)) return;
    Examination examined = Examined(worlds[w], *oracles[o], options);
    places[i] = motions.Keep(examined.trajectory);
    report.worlds[w].drifts[o] = examined.drifts;
    report.worlds[w].ensembles[o] = examined.ensemble;
    report.worlds[w].seconds[o] = std::move(examined.seconds);
    findings[i] = std::move(examined.findings);
    // Children are forked all the time. What a motion has left in the allocator would be
    // copied with each.
    examined = {};
    malloc_trim(0);
    if (options.on_done) options.on_done(WorkOf(worlds[w]));
  });
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (places[i])
      report.worlds[pairs[i].world].trajectories[pairs[i].oracle] =
          motions.Take(*places[i]);
  }
  for (std::vector<Finding>& of_pair : findings)
    std::move(of_pair.begin(), of_pair.end(), std::back_inserter(report.findings));
  return report;
}

}  // namespace touchstone
