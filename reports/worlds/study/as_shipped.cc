#include "reports/worlds/study/as_shipped.h"

#include <algorithm>
#include <iterator>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

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

/** A way to judge a world with another setup. */
class Asking {
 public:
  /** Asks for changed copies of the world only if one of `failures` needs them. */
  Asking(const WorldScenario& scenario, const Oracle& oracle,
         std::span<const Finding> failures)
      : scenario_(scenario),
        oracle_(oracle),
        one_motion_(std::all_of(failures.begin(), failures.end(), [](const Finding& f) {
          return !IsFailure(f.verdict) || NeedsOneMotion(f);
        })) {}

  Findings With(const WorldSetup& setup) const {
    const std::unique_ptr<Oracle> oracle = oracle_.SetUp(setup);
    if (!one_motion_) return ExamineWorld(scenario_, *oracle).findings;
    const Trajectory trajectory = oracle->Simulate(scenario_.world);
    std::vector<Findings> groups =
        JudgeWorldByClaim({scenario_, oracle->info(), trajectory});
    if (groups.front().front().verdict == Verdict::kPass && scenario_.ensemble) {
      groups = JudgeEnsemble(scenario_, *oracle, trajectory, std::move(groups)).groups;
    }
    Findings all;
    for (Findings& group : groups)
      std::move(group.begin(), group.end(), std::back_inserter(all));
    return all;
  }

 private:
  const WorldScenario& scenario_;
  const Oracle& oracle_;
  bool one_motion_;
};

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
  const Asking asking(scenario, oracle, findings);
  const Findings shipped = asking.With({.as_shipped = true, .chosen = {}});
  const Finding* silent = FailureToAnswer(shipped);
  if (silent && silent->verdict == Verdict::kUnsupported) return;
  for (std::size_t i = 0; i < findings.size(); ++i) {
    Finding& finding = findings[i];
    const Finding* found = silent ? silent : Find(shipped, findings, i);
    if (found == nullptr || (!fails(finding) && (silent || !fails(*found)))) continue;
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
  for (Difference& difference : differences) {
    WorldSetup setup = info.setup;
    setup.chosen[difference.parameter->name] = difference.parameter->shipped;
    difference.shipped = asking.With(setup);
  }
  for (std::size_t i = 0; i < findings.size(); ++i) {
    if (here_only(findings[i]))
      findings[i].shipped_because += WhatDecides(findings, i, differences);
  }
}

}  // namespace touchstone
