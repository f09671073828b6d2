#include "reports/worlds/study/judge_variant.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "reports/worlds/law_support/allowed_motion.h"
#include "reports/worlds/study/late_falls.h"
#include "reports/worlds/study/trajectory_difference.h"
#include "reports/worlds/study/world_size.h"
#include "reports/worlds/truth/mechanics.h"

namespace touchstone {
namespace {

/** The difference of two motions up to a time, and the parts that explain it. */
struct Comparison {
  double apart;           ///< [m]
  double discretisation;  ///< [m]
  double rounding;        ///< Sum for both motions, before amplification. [m]
  double most;            ///< The most that rounding explains. [m]
  double late;            ///< Due to events a step late. [m]
  double yielding;        ///< Due to the softness of contacts and joints. [m]

  double Granted(double gain) const {
    return discretisation + std::min(gain * rounding, most) + late + yielding;
  }
  std::string Because(double gain) const {
    return fmt::format(
        "two approximations of one motion: each is off by twice the change from halving "
        "the step ({:.3g} m), and by 64 roundings a step ({:.3g} m for both), which the "
        "motion amplifies {:.3g} times{}{}{}",
        discretisation / 4, rounding, gain,
        gain * rounding > most
            ? fmt::format(
                  ", but to no more than {:.3g} m, ten times what a start that is "
                  "moved by all of them changes",
                  most)
            : "",
        late > 0
            ? fmt::format("; {:.3g} m for a contact that is detected a step late", late)
            : "",
        yielding > 0 ? fmt::format("; {:.3g} m that contacts as soft as documented yield",
                                   yielding)
                     : "");
  }
};

/** Returns how far apart soft contacts may bring a world and a variant. A contact of the
 softness σ yields by σ ∫F dt. The impulses on what it carries are at most those of the
 loads, and twice the momentum √(2 H Σm), H the most kinetic energy that the truth allows.
 A variant may have three times the masses, and every body may stand on all others. [m] */
double YieldingOf(const Study& study, double until) {
  const double softness = SoftnessOf(study.oracle);
  if (softness == 0) return 0;
  const World& world = study.scenario.world;
  const double time = std::min(until, world.dt * world.steps);
  double load = 0;
  double mass = 0;
  double count = 0;
  for (const RigidBody& body : world.bodies) {
    if (body.mass == 0) continue;
    load += body.mass * AccelerationOf(world, body).norm();
    mass += body.mass;
    ++count;
  }
  const AllowedMotion allowed({world, study.oracle, study.trajectory});
  const double H = allowed.KineticEnergyBetween(study.trajectory.samples.size() - 1);
  const double impulse = time * load + 2 * std::sqrt(2 * H * mass);
  constexpr double kMasses = 1 + 3;  // Those of the world and of its heavier variant.
  return kMasses * count * softness * impulse;
}

Comparison Compare(const Study& study, const Trajectory& seen_in_world, double until,
                   const RoundingGrowth& growth) {
  const World& world = study.scenario.world;
  const double radius = LargestRadius(world);
  const double steps = std::min<double>(world.steps, until / world.dt);
  return {DistanceBetween(study.trajectory, seen_in_world, radius, until),
          4 * DistanceBetween(study.trajectory, *study.half, radius, until),
          2 * RoundingOf(study, steps),
          growth.most,
          growth.late,
          YieldingOf(study, until)};
}

/** Judges by rounding and discretisation alone. */
Finding JudgeWithoutEvents(const Study& study, const RoundingGrowth& growth,
                           MeasureKind measure, const Trajectory& seen_in_world) {
  const double until = UntilOf(study);
  const Comparison whole = Compare(study, seen_in_world, until, growth);
  const bool unstable = growth.horizon < until;
  const Comparison before =
      unstable ? Compare(study, seen_in_world, growth.horizon, growth) : whole;
  const bool differs_before = before.apart > before.Granted(growth.gain_before);
  const Comparison& told = differs_before ? before : whole;
  Finding finding;
  finding.scenario = study.scenario.id;
  finding.oracle = study.oracle.name;
  finding.measure = measure;
  finding.value = told.apart;
  const auto grant = [&](double gain) {
    finding.tolerance = told.Granted(gain);
    finding.tolerance_because = told.Because(gain);
  };
  grant(growth.gain_before);
  if (!differs_before && finding.value <= finding.tolerance) return finding;
  finding.proof = fmt::format(
      "{} moves the world {} differently, by {:.6g} m of distance + angle × radius",
      finding.oracle, ChangeOf(measure), finding.value);
  if (unstable && !differs_before) {
    grant(growth.gain);
    if (finding.value <= finding.tolerance) {
      finding.verdict = Verdict::kUndecidable;
      finding.proof += fmt::format(
          "; from {:.6g} s on this motion amplifies rounding {:.3g} times: the variants "
          "cannot be compared",
          growth.horizon, growth.gain);
      return finding;
    }
  }
  finding.verdict = Verdict::kFail;
  finding.cause = Cause::kDefect;
  finding.cause_because =
      fmt::format("no law of motion tells the world {} apart", ChangeOf(measure));
  const std::string differs = std::move(finding.proof);
  State(LargestDifference(study.scenario.world, study.trajectory, seen_in_world,
                          differs_before ? std::min(until, growth.horizon) : until),
        finding);
  finding.proof =
      fmt::format("{}: {}, in the world itself and in the variant mapped back", differs,
                  finding.proof);
  return finding;
}

}  // namespace

std::string_view ChangeOf(MeasureKind measure) {
  switch (measure) {
    case MeasureKind::kHeading:
      return "turned about gravity";
    case MeasureKind::kTranslation:
      return "moved";
    case MeasureKind::kMirror:
      return "mirrored";
    case MeasureKind::kPermutation:
      return "with its bodies in the opposite order";
    default:
      return "with all masses three times as large";
  }
}

Finding JudgeVariant(const Study& study, const RoundingGrowth& growth,
                     MeasureKind measure, const Trajectory& seen_in_world) {
  Finding finding = JudgeWithoutEvents(study, growth, measure, seen_in_world);
  if (finding.verdict == Verdict::kPass) return finding;
  // A fall may be the jump that makes the growth beyond the horizon: it is looked for
  // without that growth.
  RoundingGrowth before = growth;
  if (finding.verdict == Verdict::kUndecidable)
    before = {.gain = growth.gain_before,
              .gain_before = growth.gain_before,
              .late = growth.late};
  const double tolerance =
      JudgeWithoutEvents(study, before, measure, seen_in_world).tolerance;
  std::vector<LateFall> falls = LateFallsOf(study);
  double longest = 0;
  for (LateFall& fall : falls) {
    // Next to a tolerance of an eighth of a fall, a number of half falls explains
    // nothing.
    if (fall.each_W.norm() < 8 * tolerance) fall = {};
    longest = std::max(longest, fall.most * fall.each_W.norm());
  }
  if (longest == 0) return finding;
  Finding without = JudgeWithoutEvents(
      study, before, measure, WithoutLateFalls(seen_in_world, study.trajectory, falls));
  if (without.verdict == Verdict::kFail) return finding;
  without.value = finding.value;
  without.tolerance += longest;
  without.tolerance_because += fmt::format(
      "; besides up to {:.3g} m along the load in half falls a h², in a step in which "
      "rounding leaves out a contact of the start",
      longest);
  return without;
}

}  // namespace touchstone
