#include "reports/worlds/study/judge_ensemble.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "reports/finding/tolerance.h"
#include "reports/worlds/study/judge_world.h"
#include "scenarios/generators/ensemble.h"

namespace touchstone {
namespace {

/** Returns a sort key: passing or not first, then the value over its tolerance. */
std::pair<bool, double> Severity(const Finding& finding) {
  const bool passes = finding.verdict == Verdict::kPass;
  return {!passes, InTolerances(finding.value, finding.tolerance)};
}

bool IsUnverified(const Finding& finding) {
  return finding.verdict == Verdict::kUnsupported;
}

/** Merges `others`, the findings of one ensemble member, into `findings`, those of the
 members before it: per measure the worse one is kept. Both belong to the same claim,
 which has one finding per measure. A member whose motion gives the law nothing to judge
 adds nothing; its finding is replaced by those of a member that does. */
void KeepWorst(std::vector<Finding>& findings, const std::vector<Finding>& others) {
  if (std::any_of(others.begin(), others.end(), IsUnverified)) return;
  std::erase_if(findings, IsUnverified);
  for (const Finding& other : others) {
    const auto same =
        std::find_if(findings.begin(), findings.end(),
                     [&](const Finding& f) { return f.measure == other.measure; });
    if (same == findings.end())
      findings.push_back(other);
    else if (Severity(other) > Severity(*same))
      *same = other;
  }
}

}  // namespace

EnsembleJudgement JudgeEnsemble(const WorldScenario& scenario, const Oracle& oracle,
                                const Trajectory& first,
                                std::vector<std::vector<Finding>> groups,
                                SecondsByName* seconds_of_laws) {
  std::vector<World> worlds;
  for (int index = 1; index < scenario.ensemble->members; ++index)
    worlds.push_back(MemberOf(scenario, index));
  std::vector<Trajectory> trajectories = oracle.SimulateEach(worlds);
  WorldScenario member = scenario;
  double seconds = 0;
  member.expectations.clear();  // They are about the world without jitter.
  for (std::size_t i = 0; i < worlds.size(); ++i) {
    member.world = std::move(worlds[i]);
    seconds += trajectories[i].seconds;
    auto more = JudgeWorldByClaim({.scenario = member,
                                   .oracle = oracle.info(),
                                   .trajectory = trajectories[i],
                                   .seconds_of_laws = seconds_of_laws});
    for (std::size_t group = 0; group < more.size(); ++group) {
      for (Finding& finding : more[group])
        if (!finding.proof.empty())
          finding.proof =
              fmt::format("member {} of the ensemble: {}", i + 1, finding.proof);
      KeepWorst(groups[group], more[group]);
    }
  }
  trajectories.push_back(first);
  return {std::move(groups), StatisticsOf(scenario.world, trajectories), seconds};
}

}  // namespace touchstone
