#include <iterator>
#include <utility>

#include "reports/run_report.h"
#include "reports/sweep/ask_block.h"
#include "reports/sweep/count_answer.h"
#include "reports/worlds/study/judge_once.h"
#include "reports/worlds/study/motion_scale.h"
#include "scenarios/scenario_file.h"

namespace touchstone {
namespace {

/** Returns the report of a run of one oracle in which the worlds were judged once. */
RunReport ReportOf(const std::vector<WorldScenario>& scenarios, const Oracle& subject) {
  RunReport report;
  report.subject = subject.info().name;
  report.oracles = {subject.info()};
  std::vector<JudgedMotion> judged = JudgeOnce(scenarios, subject);
  for (std::size_t i = 0; i < scenarios.size(); ++i) {
    report.worlds.push_back({scenarios[i], {std::move(judged[i].trajectory)}, {}, {}});
    std::move(judged[i].findings.begin(), judged[i].findings.end(),
              std::back_inserter(report.findings));
  }
  return report;
}

}  // namespace

std::optional<SeriesTally> AskWorlds(const SweepPlan& plan, const WorldSeries& block,
                                     const Stop& stop) {
  std::vector<WorldScenario> scenarios;
  for (std::uint64_t i = 0; i < block.count; ++i)
    scenarios.push_back(WorldAt(block, block.first + i));
  SeriesTally tally;
  for (const Oracle* subject : plan.subjects) {
    const RunReport report = ReportOf(scenarios, *subject);
    if (IsStopped(stop)) return std::nullopt;
    const std::vector<Outcome> outcomes = OutcomesOf(report);
    OracleTally& of_subject = tally.oracles.emplace_back();
    for (std::uint64_t i = 0; i < block.count; ++i) {
      const WorldScenario& scenario = scenarios[i];
      const MotionScale scale =
          ScaleOf(scenario.world, report.worlds[i].trajectories.front().samples);
      CountAnswer(
          {.question = block.first + i,
           .outcome = outcomes[i],
           .share_of =
               [&scale](const Finding& finding) { return ShareOf(finding, scale); },
           .write = [&scenario] { return WriteScenario(scenario); }},
          of_subject);
    }
  }
  return tally;
}

}  // namespace touchstone
