#include "reports/worlds/study/judge_world.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "oracles/stopwatch.h"
#include "reports/worlds/law_support/cone_models.h"
#include "reports/worlds/law_support/error_laws.h"
#include "reports/worlds/laws/laws.h"
#include "reports/worlds/study/every_step.h"
#include "reports/worlds/study/fine_tolerance.h"
#include "reports/worlds/study/judge_expectation.h"
#include "reports/worlds/study/starting_state.h"
#include "reports/worlds/study/trajectory_difference.h"
#include "reports/worlds/study/universal_claims.h"
#include "reports/worlds/study/world_size.h"

namespace touchstone {
namespace {

/** An order that is observed may fall short of the true one by this much: rounded to a
 whole number, it is still the true one. */
constexpr double kHalfAnOrder = 0.5;

/** The least order at which an error counts as vanishing with the step: nearer to 1,
 which every consistent scheme has, than to 0. Half the step must leave at most 2^-0.5 of
 it. */
constexpr double kLeastOrder = 1 - kHalfAnOrder;

/** The share of an error from which on its value at half the step counts as no smaller.
 [-] */
constexpr double kHardlySmaller = 0.9;

/** Returns the largest value of each series up to the sample at which `first` has reached
 an eighth of its maximum. Later samples say nothing about the order: two rotations or
 swings that have lost phase differ by as much at any step. */
std::pair<double, double> WhileGrowing(const std::vector<double>& first,
                                       const std::vector<double>& second) {
  if (first.empty() || second.empty()) return {0, 0};
  const double grown = *std::max_element(first.begin(), first.end()) / 8;
  std::pair<double, double> largest{0, 0};
  for (std::size_t s = 0; s < first.size() && s < second.size(); ++s) {
    largest = {std::max(largest.first, first[s]), std::max(largest.second, second[s])};
    if (first[s] >= grown) break;
  }
  return largest;
}

/** Returns the value of the same claim and measure for another motion, if it has one. */
std::optional<double> ValueOf(const Law& law, const Motion& motion, const Claim& claim,
                              MeasureKind measure) {
  for (const LawFinding& finding : law.judge(motion, claim)) {
    if (finding.measure == measure) return finding.value;
  }
  return std::nullopt;
}

/** Describes in `finding` how an oracle failed to return a motion, if it failed. `asked`
 is empty for the world itself, else it names the change of the world. */
void DescribeAnswering(const Trajectory& trajectory, double dt, std::string_view asked,
                       Finding& finding) {
  const std::string who =
      asked.empty() ? finding.oracle : fmt::format("{}, {}", finding.oracle, asked);
  switch (trajectory.status) {
    case AnswerStatus::kUnsupported:
      finding.verdict = Verdict::kUnsupported;
      finding.proof = trajectory.reason;
      return;
    case AnswerStatus::kCrashed:
      finding.verdict = Verdict::kCrashed;
      break;
    case AnswerStatus::kTimedOut:
      finding.verdict = Verdict::kTimedOut;
      break;
    case AnswerStatus::kAnswered:
      if (trajectory.diverged_at_step == 0) return;
      finding.verdict = Verdict::kInvalid;
      finding.value = 1;
      finding.proof =
          fmt::format("{}: diverged in step {}, at {:.6g} s", who,
                      trajectory.diverged_at_step, trajectory.diverged_at_step * dt);
      finding.cited.time = trajectory.diverged_at_step * dt;
      finding.cited.first_time = finding.cited.time;
      return;
  }
  finding.value = 1;
  finding.proof = fmt::format("{}: {}", who, trajectory.reason);
}

class Judgement {
 public:
  explicit Judgement(const Study& study)
      : study_(study), motion_{study.scenario.world, study.oracle, study.trajectory} {}

  std::vector<std::vector<Finding>> Findings() && {
    groups_.resize(1);
    if (!JudgeAnswering()) return std::move(groups_);
    fine_.emplace(motion_);
    for (const Claim& claim : study_.scenario.claims) {
      groups_.emplace_back();
      const Law* law = FindLaw(claim.law);
      // A claim with faults is an error of the file, not of an oracle.
      if (law && law->faults(study_.scenario.world, claim).empty()) Hold(*law, claim);
    }
    for (const Claim& claim : UniversalClaims(study_.scenario)) {
      groups_.emplace_back();
      HoldUniversal(*FindLaw(claim.law), claim);
    }
    for (std::size_t i = 0; i < study_.scenario.expectations.size(); ++i) {
      groups_.emplace_back();
      Expect(i);
    }
    for (std::vector<Finding>& group : groups_)
      for (Finding& finding : group) fine_->Require(finding);
    return std::move(groups_);
  }

 private:
  /** Returns whether there is a motion to judge. */
  bool JudgeAnswering() {
    Finding& finding = Add(MeasureKind::kAnswering, 0, {0, "an answer is an answer"});
    DescribeAnswering(study_.trajectory, study_.scenario.world.dt, "", finding);
    if (finding.verdict != Verdict::kPass) return false;
    CitingProof deviation =
        DeviationFromStart(study_.scenario.world, study_.oracle, study_.trajectory);
    if (deviation.sentence.empty()) return true;
    finding.verdict = Verdict::kInvalid;
    finding.value = 1;
    finding.proof = std::move(deviation.sentence);
    finding.cited = std::move(deviation.cited);
    return false;
  }

  /** Returns what a law finds in the motion, with a sample at every step if it wants them
   and somebody took them. */
  std::vector<LawFinding> FoundBy(const Law& law, const Claim& claim) const {
    if (!law.of_steps || !study_.of_steps) return law.judge(motion_, claim);
    const World world = EveryStep(motion_.world);
    return law.judge({world, study_.oracle, *study_.of_steps}, claim);
  }

  void Hold(const Law& law, const Claim& claim) {
    const Stopwatch watch;
    const std::vector<LawFinding> all = FoundBy(law, claim);
    if (all.empty()) {
      Finding& unverified =
          Add(MeasureKind::kAnswering, 0, {0, "an answer is an answer"});
      unverified.law = law.name;
      unverified.verdict = Verdict::kUnsupported;
      unverified.proof =
          fmt::format("{}: this motion gives the law nothing to judge", law.name);
    }
    for (const LawFinding& found : all) Add(found, law, claim, law.name);
    if (law.smooth && study_.half && study_.quarter) JudgeConvergence();
    if (law.has_impacts && study_.quarter) JudgeNearLimit(law, claim);
    AddSeconds(law.name, watch);
  }

  /** Judges by a law that no claim of the file states. Engines that give it nothing to
   judge promised nothing. */
  void HoldUniversal(const Law& law, const Claim& claim) {
    const Stopwatch watch;
    const std::string true_of_all = fmt::format("{}, true of every motion", law.name);
    for (const LawFinding& found : FoundBy(law, claim))
      Add(found, law, claim, true_of_all).universal = true;
    AddSeconds(law.name, watch);
  }

  void AddSeconds(std::string_view law, const Stopwatch& watch) const {
    if (study_.seconds_of_laws)
      (*study_.seconds_of_laws)[std::string(law)] += watch.seconds();
  }

  /** Judges by one plain expectation of the file. */
  void Expect(std::size_t index) {
    const LawFinding found =
        JudgeExpectation(motion_, study_.scenario.expectations[index]);
    Finding& finding = Add(found.measure, found.value, found.tolerance);
    finding.law = fmt::format("expect[{}]", index);
    if (!IsBeyond(found)) return;
    finding.verdict = Verdict::kFail;
    finding.proof = fmt::format("{}: {}", finding.law, found.proof);
    finding.cited = found.cited;
    finding.cause = Cause::kDefect;
  }

  /** Adds what a law found; `name` is that of the law in its proof. */
  Finding& Add(const LawFinding& found, const Law& law, const Claim& claim,
               std::string_view name) {
    Finding& finding = Add(found, found.measure, name);
    finding.law = law.name;
    if (finding.verdict == Verdict::kFail) Attribute(finding, found.grants, law, claim);
    return finding;
  }

  /** Adds what a law found, as a finding of `measure`, without law and cause of failure.
   `what` starts the proof of a failure. */
  Finding& Add(const LawFinding& found, MeasureKind measure, std::string_view what) {
    // The worst number is small next to its tolerance; a larger one decides.
    const bool is_coarse =
        !IsBeyond(found) && found.largest.value > fine_->Of(found.measure);
    Finding& finding = is_coarse ? Add(measure, found.largest.value,
                                       {found.largest.tolerance, found.tolerance.because})
                                 : Add(measure, found.value, found.tolerance);
    if (found.grants == Grants::kStep) finding.safety = kSafety;
    if (IsBeyond(found)) finding.cited = found.cited;
    if (!std::isfinite(found.tolerance.value) && found.value != 0) {
      // A sum of the law has overflowed: it neither accuses nor excuses.
      finding.verdict = Verdict::kUndecidable;
      finding.proof = fmt::format("{}: no number follows for its tolerance where {}",
                                  what, found.proof);
    } else if (is_coarse && !found.scheme.name.empty() &&
               found.scheme.error <= fine_->Of(found.measure)) {
      finding.cause = Cause::kModel;
      finding.cause_because = found.scheme.name;
    } else if (!found.recognised.empty()) {
      finding.cause = Cause::kModel;
      finding.cause_because = found.recognised;
      finding.proof = found.proof;
    } else if (IsBeyond(found)) {
      finding.verdict = Verdict::kFail;
      finding.proof = fmt::format("{}: {}", what, found.proof);
    }
    return finding;
  }

  /** Sets the cause of a failure: whether its error vanishes with the step. An error that
   no step excuses, since its tolerance is rounding alone, is a defect at any step. */
  void Attribute(Finding& finding, Grants grants, const Law& law, const Claim& claim) {
    finding.cause = Cause::kDefect;
    if (grants == Grants::kRounding) {
      finding.cause_because = "it holds at any step to rounding";
      return;
    }
    if (!study_.half || !study_.quarter) return;
    // Smaller steps are known at the samples alone, and like is compared with like.
    std::optional<double> sampled = finding.value;
    if (law.of_steps && study_.of_steps)
      sampled = ValueOf(law, motion_, claim, finding.measure);
    if (!sampled || *sampled <= finding.tolerance) {
      finding.cause_because =
          "it shows between the samples, where no smaller step was judged";
      return;
    }
    const World half_world = Refined(study_.scenario.world, 2);
    const World quarter_world = Refined(study_.scenario.world, 4);
    const auto half =
        ValueOf(law, {half_world, study_.oracle, *study_.half}, claim, finding.measure);
    const auto quarter = ValueOf(law, {quarter_world, study_.oracle, *study_.quarter},
                                 claim, finding.measure);
    if (!half || !quarter) return;
    // The impulse of a step is F h: it halves with the step by itself, so forces and
    // moments are compared.
    const std::string_view unit =
        UnitOf(finding.measure) == "N s"                          ? " N"
        : finding.measure == MeasureKind::kAngularMomentumBalance ? " N m"
                                                                  : "";
    const bool is_of_step = !unit.empty();
    const double h = is_of_step ? study_.scenario.world.dt : 1;
    const double at_step = *sampled / h;
    const double at_half = *half / (is_of_step ? h / 2 : 1);
    const double at_quarter = *quarter / (is_of_step ? h / 4 : 1);
    const double shrinks = std::exp2(-kLeastOrder);
    finding.study =
        StepStudy{{at_step, at_half, at_quarter},
                  std::string(is_of_step ? unit.substr(1) : UnitOf(finding.measure))};
    const bool vanishes = at_half <= shrinks * at_step && at_quarter <= shrinks * at_half;
    const bool depends_on_phase =
        at_half > kHardlySmaller * at_step && *quarter <= finding.tolerance;
    finding.cause = vanishes ? Cause::kDiscretisation : Cause::kDefect;
    finding.cause_because = fmt::format(
        "{:.3g}, {:.3g} and {:.3g}{} at the step, a half and a quarter of it: {}",
        at_step, at_half, at_quarter, unit,
        vanishes ? "it vanishes with the step"
                 : fmt::format(
                       "{}to vanish with the step it would have to fall to 1/{:.2g} "
                       "at each halving",
                       depends_on_phase
                           ? "it passes at a quarter but is hardly smaller at a half, so "
                             "where the steps fall determines it, too; "
                           : "",
                       1 / shrinks));
  }

  /** Judges order and limit, once for any number of smooth claims. */
  void JudgeConvergence() {
    if (convergence_judged_) return;
    convergence_judged_ = true;
    const double radius = LargestRadius(study_.scenario.world);
    const double until = UntilOf(study_);
    const auto [first, second] =
        WhileGrowing(DistancesBetween(study_.trajectory, *study_.half, radius, until),
                     DistancesBetween(*study_.half, *study_.quarter, radius, until));
    const double rounding = RoundingOf(study_, 4 * study_.scenario.world.steps);
    // If halving the step changes nothing, there is no order to observe.
    if (first > 8 * rounding && second > 8 * rounding) {
      const double order = std::log2(first / second);
      const double stated = study_.oracle.stated_order;
      Finding& finding =
          Add(MeasureKind::kObservedOrder, std::max(0.0, stated - order),
              {kHalfAnOrder,
               stated == 1
                   ? "the error of a consistent scheme is at least of first order in the "
                     "step: an order nearer to 1 than to 0"
                   : fmt::format("order {:g} is stated by {}: an order nearer to it than "
                                 "to {:g}",
                                 stated, study_.oracle.order_stated_by, stated - 1)});
      if (finding.value > finding.tolerance) {
        finding.verdict = Verdict::kFail;
        finding.cause = Cause::kDefect;
        finding.proof = fmt::format(
            "halving the step moves {} by {:.3g} m while the difference still grows, "
            "halving it again by {:.3g} m: order {:.2f}",
            study_.oracle.name, first, second, order);
      }
    }
    JudgeLimit(DistanceBetween(*study_.half, *study_.quarter, radius, until) + rounding);
  }

  void JudgeLimit(double tolerance) {
    const World world = Refined(study_.scenario.world, 4);
    const Trajectory limit = ExtrapolatedToZeroStep(*study_.half, *study_.quarter);
    for (const Claim& claim : study_.scenario.claims) {
      const Law* law = FindLaw(claim.law);
      if (!law || !law->smooth || !law->faults(world, claim).empty()) continue;
      const auto error = ValueOf(*law, {world, study_.oracle, limit}, claim,
                                 MeasureKind::kPositionError);
      if (!error) continue;
      Finding& finding =
          Add(MeasureKind::kLimitError, *error,
              {tolerance,
               "the extrapolated motion is off by less than the last halving of the "
               "step changes it, plus rounding"});
      finding.law = law->name;
      if (finding.value <= finding.tolerance) continue;
      finding.verdict = Verdict::kFail;
      finding.cause = Cause::kModel;
      finding.cause_because = "it converges to a motion other than the truth";
      finding.proof = fmt::format(
          "{}: as the step goes to 0, {} converges to a motion that is {:.6g} m off",
          law->name, study_.oracle.name, *error);
    }
  }

  /** Judges a motion with impacts at a quarter of the step; see Law::has_impacts. */
  void JudgeNearLimit(const Law& law, const Claim& claim) {
    const World world = Refined(study_.scenario.world, 4);
    if (!law.faults(world, claim).empty()) return;
    const Motion motion{world, study_.oracle, *study_.quarter};
    for (const LawFinding& found : law.judge(motion, claim)) {
      if (found.measure != MeasureKind::kPositionError) continue;
      LawFinding near = found;
      near.tolerance.because = "at a quarter of the step: " + near.tolerance.because;
      Finding& finding = Add(near, MeasureKind::kLimitError,
                             std::string(law.name) + ": at a quarter of the step");
      if (finding.verdict != Verdict::kFail) continue;
      finding.cause = Cause::kDefect;
      finding.cause_because = "it does not approach the truth as the step shrinks";
    }
  }

  Finding& Add(MeasureKind measure, double value, const Tolerance& tolerance) {
    Finding& finding = groups_.back().emplace_back();
    finding.scenario = study_.scenario.id;
    finding.oracle = study_.oracle.name;
    finding.reference = "law";
    finding.measure = measure;
    finding.value = value;
    finding.tolerance = tolerance.value;
    finding.tolerance_because = tolerance.because;
    return finding;
  }

  const Study& study_;
  Motion motion_;
  std::optional<FineTolerance> fine_;  ///< Of an answered motion.
  bool convergence_judged_ = false;
  /** Answering first, then one per claim, universal law and expectation. */
  std::vector<std::vector<Finding>> groups_;
};

/** Turns recognised friction cones into failures if claims of one motion recognise two
 different ones: an engine has only one cone. */
void RefuseTwoCones(std::vector<std::vector<Finding>>& groups) {
  std::set<std::string_view> cones;
  const auto is_cone = [](const Finding& finding) {
    return finding.verdict == Verdict::kPass && IsFrictionCone(finding.cause_because);
  };
  for (const std::vector<Finding>& group : groups) {
    for (const Finding& finding : group)
      if (is_cone(finding)) cones.insert(finding.cause_because);
  }
  if (cones.size() < 2) return;
  for (std::vector<Finding>& group : groups) {
    for (Finding& finding : group) {
      if (!is_cone(finding)) continue;
      finding.verdict = Verdict::kFail;
      finding.cause = Cause::kDefect;
      finding.cause_because =
          fmt::format("the {} explains this claim, but another claim shows another cone",
                      finding.cause_because);
    }
  }
}

Finding SelfFinding(const Study& study, MeasureKind measure) {
  Finding finding;
  finding.scenario = study.scenario.id;
  finding.oracle = study.oracle.name;
  finding.measure = measure;
  return finding;
}

}  // namespace

bool IsWhole(const Trajectory& trajectory) {
  return trajectory.status == AnswerStatus::kAnswered && trajectory.diverged_at_step == 0;
}

std::string PrintedBy(const Trajectory& trajectory) {
  if (trajectory.complaint.empty()) return "";
  return fmt::format(" (it printed: {})", trajectory.complaint);
}

std::vector<std::vector<Finding>> JudgeWorldByClaim(const Study& study) {
  std::vector<std::vector<Finding>> groups = Judgement(study).Findings();
  RefuseTwoCones(groups);
  for (std::vector<Finding>& group : groups) {
    for (Finding& finding : group) {
      if (finding.verdict != Verdict::kPass && finding.verdict != Verdict::kUnsupported)
        finding.proof += PrintedBy(study.trajectory);
    }
  }
  return groups;
}

std::vector<Finding> JudgeWorld(const Study& study) {
  std::vector<Finding> findings;
  for (std::vector<Finding>& group : JudgeWorldByClaim(study))
    std::move(group.begin(), group.end(), std::back_inserter(findings));
  return findings;
}

void SortByMeasure(std::vector<Finding>& findings) {
  std::stable_sort(
      findings.begin(), findings.end(),
      [](const Finding& a, const Finding& b) { return a.measure < b.measure; });
}

std::optional<Finding> FailureToAnswer(const Study& study, const Trajectory& other,
                                       std::string_view asked, double dt) {
  if (IsWhole(other) || other.status == AnswerStatus::kUnsupported) return std::nullopt;
  Finding finding = SelfFinding(study, MeasureKind::kAnswering);
  finding.reference = "law";
  finding.tolerance_because = "an answer is an answer";
  DescribeAnswering(other, dt, asked, finding);
  finding.proof += PrintedBy(other);
  return finding;
}

Finding JudgeRepetition(const Study& study, const Trajectory& again) {
  Finding finding = SelfFinding(study, MeasureKind::kDeterminism);
  finding.tolerance_because = "the same question has the same answer, bit for bit";
  CitingProof difference = FirstDifference(study.scenario.world, study.trajectory, again);
  if (difference.sentence.empty()) return finding;
  finding.value = 1;
  finding.verdict = Verdict::kFail;
  finding.cause = Cause::kDefect;
  finding.proof =
      fmt::format("{} gives two answers: {}", finding.oracle, difference.sentence);
  finding.cited = std::move(difference.cited);
  return finding;
}

}  // namespace touchstone
