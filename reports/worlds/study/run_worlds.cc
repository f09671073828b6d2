#include "reports/worlds/study/run_worlds.h"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <utility>

#include "reports/threads/parallel_for.h"
#include "reports/worlds/study/as_shipped.h"
#include "reports/worlds/study/body_steps.h"
#include "reports/worlds/study/examine_world.h"
#include "reports/worlds/study/motion_scale.h"

namespace touchstone {
namespace {

/** Returns the approximate cost of all simulations of one world by one oracle.
 [body-steps] */
double WorkOf(const WorldScenario& scenario) {
  // The step itself, half and a quarter of it, a moved start, and five variants.
  const double times = IsStudied(scenario) ? 1 + 2 + 4 + 1 + 5 : 1;
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

/** Sets the grade of every finding that is proved wrong. */
void GradeFaults(const World& world, const Trajectory& trajectory,
                 std::span<Finding> findings) {
  const MotionScale scale = ScaleOf(world, trajectory);
  for (Finding& finding : findings) {
    if (IsProvedWrong(finding)) finding.grade = GradeOf(finding, scale);
  }
}

}  // namespace

std::size_t CountOfWorldRuns(std::span<const WorldScenario> worlds,
                             std::span<const Oracle* const> oracles) {
  return PairsOf(worlds, oracles).size();
}

WorldsReport RunWorlds(std::span<const WorldScenario> worlds,
                       std::span<const Oracle* const> oracles, int jobs,
                       const std::function<void()>& on_done) {
  WorldsReport report;
  for (const WorldScenario& scenario : worlds)
    report.worlds.push_back({scenario, std::vector<Trajectory>(oracles.size()),
                             std::vector<MotionDrifts>(oracles.size()),
                             std::vector<EnsembleStatistics>(oracles.size())});
  const std::vector<Pair> pairs = PairsOf(worlds, oracles);
  std::vector<std::vector<Finding>> findings(pairs.size());
  const std::vector<std::size_t> order = LongestFirst(pairs, worlds);
  ParallelFor(pairs.size(), jobs, [&](std::size_t turn) {
    const std::size_t i = order[turn];
    const auto [w, o] = pairs[i];
    Examination examined = ExamineWorld(worlds[w], *oracles[o]);
    report.worlds[w].trajectories[o] = std::move(examined.trajectory);
    report.worlds[w].drifts[o] = examined.drifts;
    report.worlds[w].ensembles[o] = examined.ensemble;
    findings[i] = std::move(examined.findings);
    CompareWithShipped(worlds[w], *oracles[o], findings[i]);
    GradeFaults(worlds[w].world, report.worlds[w].trajectories[o], findings[i]);
    std::stable_sort(
        findings[i].begin(), findings[i].end(),
        [](const Finding& a, const Finding& b) { return a.measure < b.measure; });
    if (on_done) on_done();
  });
  for (std::vector<Finding>& of_pair : findings)
    std::move(of_pair.begin(), of_pair.end(), std::back_inserter(report.findings));
  return report;
}

}  // namespace touchstone
