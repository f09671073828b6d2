#include "reports/worlds/study/as_shipped.h"

#include <algorithm>
#include <iterator>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "reports/worlds/study/every_step.h"
#include "reports/worlds/study/examine_world.h"
#include "reports/worlds/study/judge_ensemble.h"
#include "reports/worlds/study/judge_world.h"

namespace touchstone {
namespace {

using Findings = std::vector<Finding>;

/** Returns whether a failure can be judged from the motion alone, without the motions of
 changed copies of the world. */
bool NeedsOneMotion(const Finding& finding) {
  return finding.reference == "law" && finding.measure != MeasureKind::kObservedOrder &&
         finding.measure != MeasureKind::kLimitError;
}

/** Returns whether a failure is one of stability, or of one variant to move as the world
 does. Half the step and the moved starts judge the former, and one variant more the
 latter. */
bool NeedsNoQuarterStep(const Finding& finding) {
  return finding.measure >= MeasureKind::kStability &&
         finding.measure <= MeasureKind::kMassScaling;
}

/** Returns whether every finding for which `counts` holds has the property. */
template <typename Counts, typename Property>
bool All(std::span<const Finding> findings, Counts counts, Property has) {
  return std::all_of(findings.begin(), findings.end(), [&](const Finding& finding) {
    return !counts(finding) || has(finding);
  });
}

Findings JudgedFromOneMotion(const WorldScenario& scenario, const Oracle& oracle) {
  const Trajectory of_steps = oracle.Simulate(EveryStep(scenario.world));
  const Trajectory trajectory = SampledAs(scenario.world, of_steps);
  std::vector<Findings> groups = JudgeWorldByClaim({.scenario = scenario,
                                                    .oracle = oracle.info(),
                                                    .trajectory = trajectory,
                                                    .of_steps = &of_steps});
  if (groups.front().front().verdict == Verdict::kPass && scenario.ensemble)
    groups = JudgeEnsemble(scenario, oracle, trajectory, std::move(groups)).groups;
  Findings all;
  for (Findings& group : groups)
    std::move(group.begin(), group.end(), std::back_inserter(all));
  return all;
}

/** The neighbours that every finding needs for its verdict. Its cause is known. */
const WantedNeighbours kForVerdicts{.limit = true, .causes = false, .variant = {}};

/** Returns the neighbours that judge again the findings for which `counts` holds. */
template <typename Counts>
WantedNeighbours WantedFor(std::span<const Finding> findings, Counts counts) {
  const auto needs_few = [](const Finding& finding) {
    return NeedsOneMotion(finding) || NeedsNoQuarterStep(finding);
  };
  if (!All(findings, counts, needs_few)) return kForVerdicts;
  std::set<MeasureKind> measures;
  for (const Finding& finding : findings)
    if (counts(finding)) measures.insert(finding.measure);
  return {.limit = false, .causes = false, .variant = [measures](MeasureKind measure) {
            return measures.contains(measure);
          }};
}

bool IsSame(const Finding& a, const Finding& b) {
  return a.law == b.law && a.measure == b.measure && a.reference == b.reference;
}

/** Returns the counterpart in `findings` of `all[index]`, or null: of the findings of the
 same law and measure, the one in the same place. Several claims of one law have several.
 */
const Finding* Find(const Findings& findings, std::span<const Finding> all,
                    std::size_t index) {
  const auto is_same = [&](const Finding& finding) {
    return IsSame(finding, all[index]);
  };
  const auto before = all.first(index);
  auto left = std::count_if(before.begin(), before.end(), is_same);
  for (const Finding& finding : findings)
    if (is_same(finding) && left-- == 0) return &finding;
  return nullptr;
}

/** Returns whether a world gave no motion to judge. */
const Finding* FailureToAnswer(const Findings& findings) {
  const Finding& answering = findings.front();
  return answering.verdict == Verdict::kPass ? nullptr : &answering;
}

std::string Measured(const Finding& finding) {
  const std::string_view unit = UnitOf(finding.measure);
  const std::string_view space = unit.empty() ? "" : " ";
  return fmt::format("{:.3g}{}{} where {:.3g}{}{} is allowed", finding.value, space, unit,
                     finding.tolerance, space, unit);
}

/** A parameter in force with another value than the engine's default. */
struct Difference {
  const WorldParameter* parameter;
  double value;      ///< The value in force.
  Findings shipped;  ///< The findings with the default of this parameter alone.

  std::string InWords() const {
    return fmt::format("{} = {}, {} here", parameter->name, parameter->shipped, value);
  }
};

std::vector<Difference> DifferencesOf(const OracleInfo& info) {
  const std::vector<double> values = ValuesOf(info.parameters, info.setup);
  std::vector<Difference> differences;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (values[i] != info.parameters[i].shipped)
      differences.push_back({&info.parameters[i], values[i], {}});
  }
  return differences;
}

/** Returns the parameters whose default lets `findings[index]` pass, as the end of a
 * sentence.
 */
std::string WhatDecides(std::span<const Finding> findings, std::size_t index,
                        std::span<const Difference> differences) {
  std::vector<std::string> all;
  std::vector<std::string> alone;
  for (const Difference& difference : differences) {
    all.push_back(difference.InWords());
    if (FailureToAnswer(difference.shipped)) continue;
    const Finding* found = Find(difference.shipped, findings, index);
    if (found && found->verdict == Verdict::kPass) alone.push_back(difference.InWords());
  }
  if (!alone.empty())
    return fmt::format("; the default {}, is enough", fmt::join(alone, "; or "));
  if (all.empty()) return "";
  return fmt::format("; no default alone is enough, of {}", fmt::join(all, "; "));
}

}  // namespace

void CompareWithShipped(const WorldScenario& scenario, const Oracle& oracle,
                        std::span<Finding> findings) {
  const OracleInfo& info = oracle.info();
  const auto fails = [](const Finding& finding) { return IsFailure(finding.verdict); };
  if (info.setup.as_shipped || std::none_of(findings.begin(), findings.end(), fails))
    return;
  std::vector<Difference> differences = DifferencesOf(info);
  if (differences.empty()) return;
  const std::unique_ptr<Oracle> untouched =
      oracle.SetUp({.as_shipped = true, .chosen = {}});
  const Findings shipped =
      All(findings, fails, NeedsOneMotion)
          ? JudgedFromOneMotion(scenario, *untouched)
          : ExamineWorld(scenario, *untouched, kForVerdicts).findings;
  const Finding* silent = FailureToAnswer(shipped);
  if (silent && silent->verdict == Verdict::kUnsupported) return;
  for (std::size_t i = 0; i < findings.size(); ++i) {
    Finding& finding = findings[i];
    const Finding* found = silent ? silent : Find(shipped, findings, i);
    if (found == nullptr || (!fails(finding) && (silent || !fails(*found)))) continue;
    const bool is_decided = fails(*found) || found->verdict == Verdict::kPass;
    if (!is_decided) continue;
    finding.shipped = !fails(finding) ? Shipped::kShippedOnly
                      : fails(*found) ? Shipped::kBoth
                                      : Shipped::kHereOnly;
    finding.shipped_because =
        silent ? fmt::format("as shipped it gives no motion: {}", silent->proof)
               : Measured(*found) + " as shipped";
  }
  const auto here_only = [](const Finding& finding) {
    return finding.shipped == Shipped::kHereOnly;
  };
  if (std::none_of(findings.begin(), findings.end(), here_only)) return;
  const bool needs_one_motion = All(findings, here_only, NeedsOneMotion);
  const WantedNeighbours wanted = WantedFor(findings, here_only);
  for (Difference& difference : differences) {
    WorldSetup setup = info.setup;
    setup.chosen[difference.parameter->name] = difference.parameter->shipped;
    const std::unique_ptr<Oracle> changed = oracle.SetUp(setup);
    difference.shipped = needs_one_motion
                             ? JudgedFromOneMotion(scenario, *changed)
                             : ExamineWorld(scenario, *changed, wanted).findings;
  }
  for (std::size_t i = 0; i < findings.size(); ++i) {
    if (!here_only(findings[i])) continue;
    findings[i].shipped_because += WhatDecides(findings, i, differences);
    if (findings[i].cause != Cause::kDefect) continue;
    findings[i].cause = Cause::kSetting;
    findings[i].cause_because = "it passes as the engine ships";
  }
}

}  // namespace touchstone
