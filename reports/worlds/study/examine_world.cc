#include "reports/worlds/study/examine_world.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "reports/worlds/law_support/box_cone.h"
#include "reports/worlds/law_support/cone_models.h"
#include "reports/worlds/laws/laws.h"
#include "reports/worlds/study/body_steps.h"
#include "reports/worlds/study/every_step.h"
#include "reports/worlds/study/fine_tolerance.h"
#include "reports/worlds/study/judge_ensemble.h"
#include "reports/worlds/study/judge_stability.h"
#include "reports/worlds/study/judge_variant.h"
#include "reports/worlds/study/judge_world.h"
#include "reports/worlds/study/neighbours.h"
#include "reports/worlds/study/rounding_growth.h"
#include "reports/worlds/study/run_claims.h"
#include "reports/worlds/truth/sliding.h"

namespace touchstone {
namespace {

void Append(std::vector<Finding>& findings, std::vector<Finding> more) {
  std::move(more.begin(), more.end(), std::back_inserter(findings));
}

/** The name in WorldSeconds::motions of worlds with a moved start. */
constexpr std::string_view kMovedStart = "moved start";

/** The name of the motion at a quarter of the step. */
constexpr std::string_view kQuarterStep = "quarter step";

/** Adds the times of the neighbours to `motions`. */
void AddSeconds(const Neighbours& neighbours, SecondsByName& motions) {
  const auto add = [&](std::string_view kind, const Trajectory& motion) {
    if (motion.seconds > 0) motions[std::string(kind)] += motion.seconds;
  };
  add("half step", neighbours.half);
  if (neighbours.quarter) add(kQuarterStep, *neighbours.quarter);
  for (const Trajectory& motion : neighbours.nudged) add(kMovedStart, motion);
  for (const VariantMotion& variant : neighbours.variants)
    add(NameOf(variant.variant.measure), variant.trajectory);
  add("again", neighbours.again);
}

/** Gives a study the motions at smaller steps, unless one was not answered. */
void Refine(const Neighbours& neighbours, Study& study) {
  const bool answered =
      IsWhole(neighbours.half) && (!neighbours.quarter || IsWhole(*neighbours.quarter));
  study.half = answered ? &neighbours.half : nullptr;
  study.quarter = answered && neighbours.quarter ? &*neighbours.quarter : nullptr;
}

/** Returns whether a law fails, and only smaller steps tell whether its error vanishes
 with the step. */
bool LacksACause(std::span<const std::vector<Finding>> groups) {
  const auto lacks = [](const Finding& finding) {
    return finding.verdict == Verdict::kFail && finding.cause_because.empty() &&
           FindLaw(finding.law) != nullptr;
  };
  return std::ranges::any_of(groups, [&](const std::vector<Finding>& group) {
    return std::ranges::any_of(group, lacks);
  });
}

/** Returns the findings that the motions of a studied world at other steps and with a
 moved start were not answered. The first unanswered move speaks for all. */
std::vector<Finding> FailuresToAnswer(const Study& study, const Neighbours& neighbours) {
  std::vector<Finding> failures;
  const auto add = [&](const Trajectory& other, std::string_view asked, double step) {
    const std::optional<Finding> failure = FailureToAnswer(study, other, asked, step);
    if (failure) failures.push_back(*failure);
  };
  const double dt = study.scenario.world.dt;
  add(neighbours.half, "at half the step", dt / 2);
  if (neighbours.quarter) add(*neighbours.quarter, "at a quarter of the step", dt / 4);
  const auto unanswered =
      std::find_if_not(neighbours.nudged.begin(), neighbours.nudged.end(), IsWhole);
  if (unanswered != neighbours.nudged.end())
    add(*unanswered, "with its start moved by a rounding", dt);
  return failures;
}

/** Number of starts that are moved by the roundings of all steps, by two moves and by
 their opposites: whether such a move makes a motion jump is chance. */
constexpr std::size_t kNudgesOfUnstable = 4;

/** Returns the growth of rounding by the answered motion that amplifies it most. */
RoundingGrowth LargestGrowth(const Study& study, std::span<const Trajectory> nudged) {
  RoundingGrowth growth;
  for (const Trajectory& other : nudged) {
    if (!study.half || !IsWhole(other)) continue;
    const RoundingGrowth more = GrowthOf(study, other);
    if (more.gain > growth.gain) growth = more;
  }
  return growth;
}

/** Asks the oracle what the roundings of all steps move, and returns
 RoundingGrowth::most. Adds the time that this takes to `seconds`. */
double MostMoved(const Study& study, const Oracle& oracle, double& seconds) {
  const double all_roundings = RoundingOf(study, study.scenario.world.steps);
  const std::vector<Trajectory> moved =
      SimulateNudged(study.scenario, oracle, all_roundings, kNudgesOfUnstable);
  for (const Trajectory& other : moved) seconds += other.seconds;
  return MostThatRoundingExplains(study, moved);
}

/** Returns the finding that the claim of that law could not be judged. */
Finding Unverified(const Study& study, std::string_view law) {
  Finding finding;
  finding.scenario = study.scenario.id;
  finding.oracle = study.oracle.name;
  finding.measure = MeasureKind::kAnswering;
  finding.law = law;
  finding.verdict = Verdict::kUnsupported;
  finding.tolerance_because = "an answer is an answer";
  finding.proof = fmt::format("{}: not every world with a moved start was answered", law);
  return finding;
}

/** Returns the finding of the claim that a world is stable with at most the gain `most`.
 */
Finding JudgeStable(const Study& study, double most, std::span<const Trajectory> nudged) {
  return std::all_of(nudged.begin(), nudged.end(), IsWhole)
             ? JudgeStability(study, most, nudged)
             : Unverified(study, kStable);
}

/** Returns the growth of rounding by which the variants of a stable world are judged:
 `gain`, but at most `most`. Lateness is granted only if a moved start shows it, as
 `stability` says. */
RoundingGrowth GrowthIfStable(const Study& study, double gain, double most,
                              const Finding& stability) {
  const double late = LatenessOf(study);
  const bool is_late = stability.value > stability.tolerance - late;
  gain = std::min(gain, most);
  return {.gain = gain, .gain_before = gain, .late = is_late ? late : 0};
}

/** Returns the failures of a variant's motion under the claims of the world, except those
 that the world itself has too. The claims hold for the variant whether or not the two
 motions can be compared. Points that are cited are mapped back into the world itself. */
std::vector<Finding> BrokenBy(const VariantMotion& moved, const Study& study,
                              std::span<const Finding> of_world) {
  WorldScenario asked = study.scenario;
  asked.world = moved.variant.world;
  asked.claims = ClaimsOf(moved.variant, study.scenario.claims);
  asked.expectations.clear();  // They are about places in the world itself.
  std::vector<Finding> broken;
  for (Finding& found : JudgeWorld({.scenario = asked,
                        .oracle = study.oracle,
                        .trajectory = moved.trajectory,
                        .seconds_of_laws = study.seconds_of_laws})) {
    if (found.verdict != Verdict::kFail) continue;
    const bool is_known =
        std::any_of(of_world.begin(), of_world.end(), [&](const Finding& known) {
          return known.law == found.law && known.measure == found.measure &&
                 known.verdict == Verdict::kFail;
        });
    if (is_known) continue;
    found.reference.clear();  // The failure is shown by a changed world.
    found.proof =
        fmt::format("the world {}: {}", ChangeOf(moved.variant.measure), found.proof);
    for (Eigen::Vector3d& p_W : found.cited.points_W)
      p_W = SeenInWorld(moved.variant, p_W);
    broken.push_back(std::move(found));
  }
  return broken;
}

/** Returns the friction cone that a motion follows instead of the circle; empty if none
 is known. A claim may have recognised it. Else the contact impulses may show it. */
std::string ConeOf(const Study& study, std::span<const Finding> of_world) {
  for (const Finding& shown : of_world) {
    const std::string_view model = RecognisedModelOf(shown);
    if (IsFrictionCone(model)) return std::string(model);
  }
  if (!FollowsBoxCone({study.scenario.world, study.oracle, study.trajectory})) return "";
  return std::string(NameOf(FrictionCone::kBox));
}

/** Sets the cause of a variant that moves differently: a model if the motion follows a
 friction cone with directions that are fixed in the world. The cone is then not the same
 in the world turned or mirrored. */
void AttributeToCone(const Study& study, std::span<const Finding> of_world,
                     Finding& finding) {
  if (finding.verdict != Verdict::kFail) return;
  if (finding.measure != MeasureKind::kHeading && finding.measure != MeasureKind::kMirror)
    return;
  const std::string cone = ConeOf(study, of_world);
  if (cone.empty()) return;
  finding.cause = Cause::kModel;
  finding.cause_because =
      fmt::format("{} has directions that are fixed in the world", cone);
}

/** Turns models into defects in a motion that breaks a law by a defect: a legal model
 breaks no law. It may break what an author expects. */
void RefuseModelsOfDefects(std::span<Finding> findings) {
  const auto is_defect = [](const Finding& finding) {
    return finding.verdict == Verdict::kFail && finding.cause == Cause::kDefect &&
           !finding.law.starts_with("expect[");
  };
  const auto defect = std::find_if(findings.begin(), findings.end(), is_defect);
  if (defect == findings.end()) return;
  const std::string broken =
      defect->law.empty() ? std::string(NameOf(defect->measure)) : defect->law;
  for (Finding& finding : findings) {
    if (finding.verdict != Verdict::kFail || finding.cause != Cause::kModel) continue;
    finding.cause = Cause::kDefect;
    finding.cause_because += fmt::format("; a model would not break {} too", broken);
  }
}

/** Returns the findings of one variant: a failure to answer, or its difference from the
 world after the claims that it breaks. */
std::vector<Finding> FindingsOfVariant(const Study& study, const RoundingGrowth& growth,
                                       const VariantMotion& moved,
                                       std::span<const Finding> of_world) {
  const auto& [variant, trajectory] = moved;
  std::vector<Finding> findings;
  const std::optional<Finding> failure = FailureToAnswer(
      study, trajectory, ChangeOf(variant.measure), study.scenario.world.dt);
  if (failure) findings.push_back(*failure);
  if (!study.half || !IsWhole(trajectory)) return findings;
  Finding finding =
      JudgeVariant(study, growth, variant.measure, SeenInWorld(variant, trajectory));
  AttributeToCone(study, of_world, finding);
  if (finding.verdict != Verdict::kFail)
    Append(findings, BrokenBy(moved, study, of_world));
  // The laws decide whether the motion is right, also if the variant says nothing.
  if (finding.verdict == Verdict::kUndecidable) finding.verdict = Verdict::kUnsupported;
  findings.push_back(std::move(finding));
  return findings;
}

/** Adds the findings of the wanted neighbours of a studied world to `of_world`, those of
 the world itself, and returns all. Adds the time of further motions to `motions`. */
std::vector<Finding> WithNeighbours(const Study& study, const Oracle& oracle,
                                    const Neighbours& neighbours,
                                    std::vector<Finding> of_world,
                                    SecondsByName& motions) {
  Append(of_world, FailuresToAnswer(study, neighbours));
  RoundingGrowth growth = LargestGrowth(study, neighbours.nudged);
  if (const Claim* stable = FindClaim(study.scenario, kStable)) {
    const double most = stable->numbers.at(std::string(kStableGain));
    of_world.push_back(JudgeStable(study, most, neighbours.nudged));
    growth = GrowthIfStable(study, growth.gain, most, of_world.back());
  } else if (growth.gain > kLargestGain && !neighbours.variants.empty()) {
    // Only variants are judged by it, and those of a stable world by what it claims.
    growth.most = MostMoved(study, oracle, motions[std::string(kMovedStart)]);
  }
  std::vector<Finding> findings = of_world;
  for (const VariantMotion& moved : neighbours.variants)
    Append(findings, FindingsOfVariant(study, growth, moved, of_world));
  const FineTolerance fine({study.scenario.world, study.oracle, study.trajectory});
  for (Finding& finding : findings) fine.Require(finding);
  return findings;
}

}  // namespace

Examination ExamineWorld(const WorldScenario& scenario, const Oracle& oracle) {
  return ExamineMotion(scenario, oracle, oracle.Simulate(EveryStep(scenario.world)), {});
}

Examination ExamineMotion(const WorldScenario& scenario, const Oracle& oracle,
                          const Trajectory& of_steps, const WantedNeighbours& wanted) {
  Examination examined;
  examined.trajectory = SampledAs(scenario.world, of_steps);
  const Trajectory& trajectory = examined.trajectory;
  SecondsByName& motions = examined.seconds.motions;
  motions["itself"] = trajectory.seconds;
  Neighbours neighbours;
  if (IsWhole(trajectory)) {
    examined.drifts = DriftsOf(scenario.world, trajectory);
    const double nudge = RoundingOf({scenario, oracle.info(), trajectory}, 1);
    neighbours = SimulateNeighbours(scenario, oracle, nudge, wanted);
    AddSeconds(neighbours, motions);
  }
  const bool studied = IsWhole(trajectory) && IsStudied(scenario);
  Study study{.scenario = scenario,
              .oracle = oracle.info(),
              .trajectory = trajectory,
              .of_steps = &of_steps,
              .seconds_of_laws = &examined.seconds.laws};
  if (studied) Refine(neighbours, study);
  std::vector<std::vector<Finding>> groups = JudgeWorldByClaim(study);
  if (wanted.causes && study.half && !neighbours.quarter && LacksACause(groups)) {
    neighbours.quarter = oracle.Simulate(Refined(scenario.world, 4));
    motions[std::string(kQuarterStep)] += neighbours.quarter->seconds;
    Refine(neighbours, study);
    groups = JudgeWorldByClaim(study);
  }
  const bool answered = groups.front().front().verdict == Verdict::kPass;
  if (answered && scenario.ensemble) {
    EnsembleJudgement ensemble = JudgeEnsemble(scenario, oracle, trajectory,
                                               std::move(groups), &examined.seconds.laws);
    motions["ensemble"] = ensemble.seconds;
    groups = std::move(ensemble.groups);
    examined.ensemble = ensemble.statistics;
  }
  std::vector<Finding> findings;
  for (std::vector<Finding>& group : groups) Append(findings, std::move(group));
  if (answered && FindClaim(scenario, kDeterministic))
    findings.push_back(JudgeRepetition(study, neighbours.again));
  if (answered && studied)
    findings = WithNeighbours(study, oracle, neighbours, std::move(findings), motions);
  RefuseModelsOfDefects(findings);
  examined.findings = std::move(findings);
  return examined;
}

}  // namespace touchstone
