#include "reports/worlds/laws/falls.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "reports/worlds/laws/energy_bound.h"
#include "reports/worlds/laws/error_laws.h"
#include "reports/worlds/laws/words.h"
#include "reports/worlds/laws/worst.h"

namespace touchstone {
namespace {

/** How much of a restitution may be unknown before a bounce is too slow to tell. [-] */
constexpr double kSlowBounce = 0.25;

/** Largest angle between directions that an author means to be one: those of quaternions
 with 16 digits. [rad] */
constexpr double kParallel = 1e-9;

/** The largest error so far, at each sample, of engines that follow the rule. [m] */
std::vector<double> StepErrors(const Motion& motion, const Fall& fall) {
  constexpr int kPhases = 8;
  std::vector<double> errors(motion.trajectory.samples.size(), 0);
  for (const ContactSeen seen : {ContactSeen::kTouching, ContactSeen::kAhead}) {
    for (int phase = 0; phase < kPhases; ++phase) {
      Fall shifted = fall;
      shifted.start.gap +=
          phase * fall.Truth().impact_speed() * motion.world.dt / kPhases;
      const VerticalBounces truth = shifted.Truth();
      SteppedBounces stepped{
          BounceRule::kStartOfStep, seen,         fall.gravity, fall.restitution,
          motion.world.dt,          shifted.start};
      double done = 0;
      for (std::size_t s = 0; s < errors.size(); ++s) {
        for (; done < StepsBefore(motion, s); ++done) stepped.Step();
        const double off =
            std::abs(stepped.state.gap - truth.At(motion.trajectory.times[s]).gap);
        errors[s] = std::max(errors[s], off);
      }
    }
  }
  for (std::size_t s = 1; s < errors.size(); ++s)
    errors[s] = std::max(errors[s], errors[s - 1]);
  return errors;
}

/** Two neighbouring samples between which the fall was turned. */
struct Bounce {
  double before;  ///< Downward speed at the first. [m/s]
  double after;   ///< Upward speed at the second. [m/s]
  double time;    ///< Of the second. [s]
  double steps;   ///< Between the two.
};

std::vector<Bounce> BouncesOf(const Motion& motion, const Fall& fall) {
  const Trajectory& trajectory = motion.trajectory;
  const auto speed = [&](std::size_t s) {
    return fall.n_W.dot(fall.is(trajectory.samples[s]).v_W);
  };
  std::vector<Bounce> bounces;
  for (std::size_t s = 1; s < trajectory.samples.size(); ++s) {
    const double time = trajectory.times[s] - trajectory.times[s - 1];
    const double before = -speed(s - 1);
    const double after = speed(s);
    // Gravity alone would have it fall faster by g Δt: what stops half of the fall is a
    // bounce.
    if (before > 0 && after + before + fall.gravity * time > before / 2) {
      bounces.push_back(
          {before, after, trajectory.times[s], std::round(time / motion.world.dt)});
    }
  }
  return bounces;
}

/** Whether v' = −e (v − g h j) − g h (k − j), a fall of j >= 1 steps reflected and a rise
 of the rest, holds for a whole j, to rounding. */
bool ReflectsAfterGravity(const Bounce& bounce, const Fall& fall, double dt,
                          double rounding) {
  const double gh = fall.gravity * dt;
  const double e = fall.restitution;
  const double j =
      (bounce.after - e * bounce.before + gh * bounce.steps) / (gh * (1 + e));
  return std::round(j) >= 1 && std::round(j) <= bounce.steps &&
         std::abs(j - std::round(j)) * gh <= rounding;
}

}  // namespace

bool IsAlong(const Eigen::Vector3d& v, const Eigen::Vector3d& n) {
  return v.cross(n).norm() <= kParallel * v.norm();
}

std::vector<std::pair<std::string_view, double>> NumbersOf(const Fall& fall) {
  const VerticalBounces truth = fall.Truth();
  const double V = truth.impact_speed() * fall.restitution;
  return {{"expected_first_impact", truth.first_impact()},
          {"expected_impact_speed", truth.impact_speed()},
          {"expected_total_time", truth.total_time()},
          {"expected_first_apex", V * V / (2 * fall.gravity)}};
}

std::vector<LawFinding> JudgeFalls(const Motion& motion, const std::vector<Fall>& falls) {
  const World& world = motion.world;
  const Trajectory& trajectory = motion.trajectory;
  Worst position(
      MeasureKind::kPositionError,
      "1.5 × the largest error so far of engines that see contacts once a step, "
      "stepped beside the truth, with V h for an impact a step late; and 64 "
      "roundings a step");
  Worst restitution(
      MeasureKind::kRestitution,
      "1.5 × (1 + e) g (Δt + h)/V: what gravity does to the samples around a "
      "bounce");
  bool after_gravity = true;
  bool any_bounce = false;
  for (const Fall& fall : falls) {
    const VerticalBounces truth = fall.Truth();
    const double V = truth.impact_speed();
    const std::vector<double> errors = StepErrors(motion, fall);
    const double reach = fall.p_W.norm() + fall.size;
    for (std::size_t s = 0; s < trajectory.samples.size(); ++s) {
      const double t = trajectory.times[s];
      const Eigen::Vector3d is = fall.is(trajectory.samples[s]).p_W;
      const Eigen::Vector3d p_W = fall.PlaceAt(t);
      const double late = t > truth.first_impact() - world.dt ? V * world.dt : 0;
      position.Take((is - p_W).norm(),
                    kSafety * (errors[s] + late) +
                        RoundingOf(motion.oracle, StepsBefore(motion, s)) *
                            (reach + (V + fall.v_along_W.norm()) * t),
                    [&] {
                      return fmt::format(
                          "{} has {} at {} after {:.6g} s; falling from {:.6g} m with "
                          "e = {:.6g} puts it at {}",
                          motion.oracle.name, fall.name, Words(is), t, fall.start.gap,
                          fall.restitution, Words(p_W));
                    });
    }
    const double e = fall.restitution;
    for (const Bounce& bounce : BouncesOf(motion, fall)) {
      const double tolerance = kSafety * (1 + e) * fall.gravity * (bounce.steps + 1) *
                               world.dt / bounce.before;
      if (tolerance > kSlowBounce) continue;
      any_bounce = true;
      const double rounding =
          RoundingOf(motion.oracle, bounce.time / world.dt) * (V + bounce.before);
      after_gravity =
          after_gravity && ReflectsAfterGravity(bounce, fall, world.dt, rounding);
      restitution.Take(std::abs(bounce.after / bounce.before - e), tolerance, [&] {
        return fmt::format(
            "{} has {} leave with {:.6g} m/s at {:.6g} s, having come with {:.6g} m/s: "
            "e = {:.6g}; the bodies' is {:.6g}",
            motion.oracle.name, fall.name, bounce.after, bounce.time, bounce.before,
            bounce.after / bounce.before, e);
      });
    }
  }
  const bool recognised = any_bounce && after_gravity;
  std::vector<LawFinding> findings = {
      recognised ? position.RecognisedAs(kReflectsAfterGravity) : position.finding()};
  if (any_bounce) findings.push_back(restitution.finding());
  return findings;
}

}  // namespace touchstone
