#include "reports/worlds/study/judge_once.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "reports/worlds/study/body_steps.h"
#include "reports/worlds/study/every_step.h"
#include "reports/worlds/study/judge_world.h"
#include "reports/worlds/study/motion_scale.h"

namespace touchstone {
namespace {

using Groups = std::vector<std::vector<Finding>>;

/** Returns the motions with a sample at every step. */
std::vector<Trajectory> MotionsOf(std::span<const WorldScenario> scenarios,
                                  const Oracle& oracle) {
  if (!oracle.info().simulates) {
    Trajectory none;
    none.reason = "it simulates no worlds";
    return {scenarios.size(), none};
  }
  std::vector<World> worlds;
  worlds.reserve(scenarios.size());
  for (const WorldScenario& scenario : scenarios)
    worlds.push_back(EveryStep(scenario.world));
  return oracle.SimulateEach(worlds);
}

bool HasDefect(const Groups& groups) {
  return std::any_of(groups.begin(), groups.end(), [](const std::vector<Finding>& group) {
    return std::any_of(group.begin(), group.end(), [](const Finding& finding) {
      return IsProvedWrong(finding) && finding.cause == Cause::kDefect;
    });
  });
}

/** Replaces `groups` by `refined`, the judgement with smaller steps. Both have the same
 groups. A group of `refined` begins with the findings of the other, with their causes,
 and ends with findings on convergence, which are dropped. */
void TakeCauses(Groups refined, Groups& groups) {
  for (std::size_t g = 0; g < groups.size(); ++g) {
    refined[g].resize(groups[g].size());
    groups[g] = std::move(refined[g]);
  }
}

/** Looks for the causes of the failures in smaller steps. */
void FindCauses(std::span<const WorldScenario> scenarios, const Oracle& oracle,
                std::span<const Trajectory> of_steps, std::span<const Trajectory> motions,
                std::span<Groups> judged) {
  std::vector<std::size_t> failed;
  std::vector<World> worlds;
  for (std::size_t i = 0; i < scenarios.size(); ++i) {
    if (!HasDefect(judged[i]) || !IsStudied(scenarios[i])) continue;
    failed.push_back(i);
    for (const int factor : {2, 4}) worlds.push_back(Refined(scenarios[i].world, factor));
  }
  if (failed.empty()) return;
  const std::vector<Trajectory> refined = oracle.SimulateEach(worlds);
  for (std::size_t f = 0; f < failed.size(); ++f) {
    const Trajectory& half = refined[2 * f];
    const Trajectory& quarter = refined[2 * f + 1];
    if (!IsWhole(half) || !IsWhole(quarter)) continue;
    const std::size_t i = failed[f];
    TakeCauses(JudgeWorldByClaim({.scenario = scenarios[i],
                                  .oracle = oracle.info(),
                                  .trajectory = motions[i],
                                  .half = &half,
                                  .quarter = &quarter,
                                  .of_steps = &of_steps[i]}),
               judged[i]);
  }
}

}  // namespace

std::vector<JudgedMotion> JudgeOnce(std::span<const WorldScenario> scenarios,
                                    const Oracle& oracle) {
  const std::vector<Trajectory> of_steps = MotionsOf(scenarios, oracle);
  std::vector<Trajectory> motions;
  std::vector<Groups> judged;
  for (std::size_t i = 0; i < scenarios.size(); ++i) {
    motions.push_back(SampledAs(scenarios[i].world, of_steps[i]));
    judged.push_back(JudgeWorldByClaim({.scenario = scenarios[i],
                                        .oracle = oracle.info(),
                                        .trajectory = motions.back(),
                                        .of_steps = &of_steps[i]}));
  }
  FindCauses(scenarios, oracle, of_steps, motions, judged);
  std::vector<JudgedMotion> results;
  for (std::size_t i = 0; i < scenarios.size(); ++i) {
    JudgedMotion& result = results.emplace_back();
    for (std::vector<Finding>& group : judged[i])
      std::move(group.begin(), group.end(), std::back_inserter(result.findings));
    GradeFaults(ScaleOf(scenarios[i].world, motions[i].samples), result.findings);
    SortByMeasure(result.findings);
    result.trajectory = std::move(motions[i]);
  }
  return results;
}

}  // namespace touchstone
