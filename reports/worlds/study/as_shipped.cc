#include "reports/worlds/study/as_shipped.h"

#include <algorithm>
#include <iterator>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "reports/worlds/study/body_steps.h"
#include "reports/worlds/study/deciding_defaults.h"
#include "reports/worlds/study/every_step.h"
#include "reports/worlds/study/examine_world.h"
#include "reports/worlds/study/judge_ensemble.h"
#include "reports/worlds/study/judge_world.h"
#include "reports/worlds/study/trajectory_difference.h"

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

/** Returns whether a world is small enough to be asked again although nothing fails: its
 motion, or those of its ensemble together, have at most kStudiedBodySteps. */
bool IsCheap(const WorldScenario& scenario) {
  const int motions = scenario.ensemble ? scenario.ensemble->members : 1;
  return BodySteps(scenario.world) * motions <= kStudiedBodySteps;
}

/** Returns whether every finding for which `counts` holds has the property. */
template <typename Counts, typename Property>
bool All(std::span<const Finding> findings, Counts counts, Property has) {
  return std::all_of(findings.begin(), findings.end(), [&](const Finding& finding) {
    return !counts(finding) || has(finding);
  });
}

bool IsSameImpulse(const ContactImpulse& a, const ContactImpulse& b) {
  return a.step == b.step && a.A == b.A && a.B == b.B && a.p_WC == b.p_WC &&
         a.n_AB_W == b.n_AB_W && a.J_B_W == b.J_B_W && a.separation == b.separation &&
         a.t_W == b.t_W;
}

/** Returns whether two motions have the same states at all samples and the same impulses
 in all steps, bit by bit. */
bool IsSameMotion(const Trajectory& a, const Trajectory& b) {
  return a.status == b.status && std::ranges::equal(a.samples, b.samples, AreEqual) &&
         std::ranges::equal(a.impulses, b.impulses, IsSameImpulse);
}

/** Judges one motion of a world, without changed copies. */
Findings JudgedFromOneMotion(const WorldScenario& scenario, const Oracle& oracle,
                             const Trajectory& of_steps) {
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

/** Returns the neighbours that judge again the findings for which `counts` holds. */
template <typename Counts>
WantedNeighbours WantedFor(std::span<const Finding> findings, Counts counts) {
  const auto needs_few = [](const Finding& finding) {
    return NeedsOneMotion(finding) || NeedsNoQuarterStep(finding);
  };
  if (!All(findings, counts, needs_few))
    return {.limit = true, .causes = false, .variant = {}};
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
const Finding* Find(std::span<const Finding> findings, std::span<const Finding> all,
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
const Finding* FailureToAnswer(std::span<const Finding> findings) {
  const Finding& answering = findings.front();
  return answering.verdict == Verdict::kPass ? nullptr : &answering;
}

std::string Measured(const Finding& finding) {
  const std::string_view unit = UnitOf(finding.measure);
  const std::string_view space = unit.empty() ? "" : " ";
  return fmt::format("{:.3g}{}{} where {:.3g}{}{} is allowed", finding.value, space, unit,
                     finding.tolerance, space, unit);
}

/** Compares each finding with its counterpart as shipped; those that pass here, only if
 `passes_too`. */
void Compare(std::span<const Finding> shipped, bool passes_too,
             std::span<Finding> findings) {
  const Finding* silent = FailureToAnswer(shipped);
  for (std::size_t i = 0; i < findings.size(); ++i) {
    Finding& finding = findings[i];
    const bool fails = IsFailure(finding.verdict);
    const Finding* found = fails && silent ? silent : Find(shipped, findings, i);
    if (found == nullptr) continue;
    const bool fails_shipped = IsFailure(found->verdict);
    const bool is_decided = fails_shipped || found->verdict == Verdict::kPass;
    // The first finding is that the world was answered.
    const bool fails_only_shipped = passes_too && fails_shipped &&
                                    finding.verdict == Verdict::kPass &&
                                    (NeedsOneMotion(finding) || i == 0);
    if (fails ? !is_decided : !fails_only_shipped) continue;
    finding.shipped = !fails          ? Shipped::kShippedOnly
                      : fails_shipped ? Shipped::kBoth
                                      : Shipped::kHereOnly;
    finding.shipped_because =
        silent ? fmt::format("as shipped it gives no motion: {}", silent->proof)
               : Measured(*found) + " as shipped";
  }
}

/** Judges a world again, from the motions that the findings need for which `counts`
 holds. `known` are the findings of `motion`. An oracle that moves in that way has them,
 too: a setting that does not change the motion changes no variant. */
template <typename Counts>
Findings JudgedAgain(const WorldScenario& scenario, const Oracle& oracle,
                     const Trajectory& motion, std::span<const Finding> known,
                     Counts counts) {
  const Trajectory of_steps = oracle.Simulate(EveryStep(scenario.world));
  if (!scenario.ensemble && IsSameMotion(SampledAs(scenario.world, of_steps), motion))
    return {known.begin(), known.end()};
  if (All(known, counts, NeedsOneMotion))
    return JudgedFromOneMotion(scenario, oracle, of_steps);
  return ExamineMotion(scenario, oracle, of_steps, WantedFor(known, counts)).findings;
}

/** Says which settings decide the findings that fail here only, or as shipped only. */
void NameSettings(const WorldScenario& scenario, const Oracle& oracle,
                  const Trajectory& motion, Shipped which, bool one_motion,
                  std::span<Finding> findings) {
  const auto counts = [&](const Finding& finding) {
    return finding.shipped == which && NeedsOneMotion(finding) == one_motion;
  };
  DecidingDefaults defaults(oracle, [&](const Oracle& changed) {
    return JudgedAgain(scenario, changed, motion, findings, counts);
  });
  for (std::size_t i = 0; i < findings.size(); ++i) {
    Finding& finding = findings[i];
    if (!counts(finding)) continue;
    const bool fails = which == Shipped::kShippedOnly;
    const auto is_as_shipped = [&](const Findings& changed) {
      const Finding* found = Find(changed, findings, i);
      if (FailureToAnswer(changed)) return fails && found;
      return found &&
             (fails ? IsFailure(found->verdict) : found->verdict == Verdict::kPass);
    };
    const bool together = one_motion && IsCheap(scenario);
    finding.shipped_because += defaults.Name(is_as_shipped, together);
    if (finding.cause != Cause::kDefect) continue;
    finding.cause = Cause::kSetting;
    finding.cause_because = "it passes as the engine ships";
  }
}

}  // namespace

void CompareWithShipped(const WorldScenario& scenario, const Oracle& oracle,
                        const Trajectory& motion, std::span<Finding> findings) {
  const auto fails = [](const Finding& finding) { return IsFailure(finding.verdict); };
  const bool any_fails = std::any_of(findings.begin(), findings.end(), fails);
  const bool is_asked = any_fails || (IsWhole(motion) && IsCheap(scenario));
  if (oracle.info().setup.as_shipped || !is_asked) return;
  if (DecidingDefaults(oracle, {}).empty()) return;
  const std::unique_ptr<Oracle> untouched =
      oracle.SetUp({.as_shipped = true, .chosen = {}});
  const Findings shipped = JudgedAgain(scenario, *untouched, motion, findings, fails);
  const Finding* silent = FailureToAnswer(shipped);
  if (silent && silent->verdict == Verdict::kUnsupported) return;
  Compare(shipped, IsCheap(scenario), findings);
  // In an answer that fails here, only the failures are worth the search for settings.
  const Shipped named = any_fails ? Shipped::kHereOnly : Shipped::kShippedOnly;
  for (const bool one_motion : {true, false})
    NameSettings(scenario, oracle, motion, named, one_motion, findings);
}

}  // namespace touchstone
