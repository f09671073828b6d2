#include "reports/worlds/law_support/falls.h"

#include <algorithm>
#include <cmath>

#include "reports/worlds/law_support/citing.h"
#include "reports/worlds/law_support/energy_bound.h"
#include "reports/worlds/law_support/envelope.h"
#include "reports/worlds/law_support/error_laws.h"
#include "reports/worlds/law_support/prediction.h"
#include "reports/worlds/law_support/worst.h"

namespace touchstone {
namespace {

/** Uncertainty of a restitution above which a bounce is too slow to judge. [-] */
constexpr double kSlowBounce = 0.25;

/** Largest angle between directions that an author means to be equal; quaternions have 16
 digits. [rad] */
constexpr double kParallel = 1e-9;

/** Number of phases of an impact within its step, which is random: starting gaps that are
 this fraction of V h apart represent it. */
constexpr int kPhases = 8;

/** Returns the fall from a gap that is larger by `phase` fractions of V h. */
Fall Shifted(const Fall& fall, double dt, int phase) {
  Fall shifted = fall;
  shifted.start.gap += phase * fall.Truth().impact_speed() * dt / kPhases;
  return shifted;
}

/** Returns the fall, to be stepped by the rule. */
SteppedBounces Stepped(const Motion& motion, const Fall& fall, BounceRule rule,
                       ContactSeen seen) {
  return {rule, seen, fall.gravity, fall.restitution, motion.world.dt, fall.start};
}

/** Returns the largest error so far of engines that follow the rule. */
Envelope StepErrors(const Motion& motion, const Fall& fall) {
  Envelope errors(motion);
  for (const ContactSeen seen : {ContactSeen::kTouching, ContactSeen::kAhead}) {
    for (int phase = 0; phase < kPhases; ++phase) {
      const Fall shifted = Shifted(fall, motion.world.dt, phase);
      const VerticalBounces truth = shifted.Truth();
      SteppedBounces stepped = Stepped(motion, shifted, BounceRule::kStartOfStep, seen);
      errors.Include([&] { stepped.Step(); },
                     [&](std::size_t s) {
                       const Height is = truth.At(motion.trajectory.times[s]);
                       return Apart{std::abs(stepped.state.gap - is.gap), 0};
                     });
    }
  }
  return errors;
}

/** Returns the heights of a fall that reflects the velocity after gravity, at each sample
 of the motion. */
std::vector<Height> HeightsAfterGravity(const Motion& motion, const Fall& fall) {
  SteppedBounces stepped =
      Stepped(motion, fall, BounceRule::kAfterGravity, ContactSeen::kTouching);
  std::vector<Height> heights;
  long done = 0;
  for (std::size_t s = 0; s < motion.trajectory.samples.size(); ++s) {
    for (; done < WholeStepsBefore(motion, s); ++done) stepped.Step();
    heights.push_back(stepped.state);
  }
  return heights;
}

/** Whether the heights after the first impact are those of falls that reflect the
 velocity after gravity. The tolerance is 1.5 × the largest distance so far between such
 falls from gaps a fraction of V h apart, and V h for an impact one step late. Errors
 before the first impact and across the normal must be within the truth's tolerances,
 `granted` at each sample. */
bool FollowsAfterGravity(const Motion& motion, const Fall& fall,
                         const std::vector<double>& granted) {
  const double h = motion.world.dt;
  const std::vector<Height> model = HeightsAfterGravity(motion, fall);
  Envelope spread(motion);
  for (const ContactSeen seen : {ContactSeen::kTouching, ContactSeen::kAhead}) {
    for (int phase = 0; phase < kPhases; ++phase) {
      SteppedBounces other =
          Stepped(motion, Shifted(fall, h, phase), BounceRule::kAfterGravity, seen);
      spread.Include([&] { other.Step(); },
                     [&](std::size_t s) {
                       return Apart{std::abs(other.state.gap - model[s].gap), 0};
                     });
    }
  }
  double fastest = fall.Truth().impact_speed();
  for (std::size_t s = 0; s < model.size(); ++s) {
    const double t = motion.trajectory.times[s];
    fastest = std::max(fastest, std::abs(model[s].velocity));
    const Eigen::Vector3d off =
        fall.point.In(motion.trajectory.samples[s]).p_W - fall.PlaceAt(t);
    const double along = fall.n_W.dot(off);
    const double across = (off - along * fall.n_W).norm();
    const bool fell = t > fall.Truth().first_impact() - h;
    const double off_model = along + fall.Truth().At(t).gap - model[s].gap;
    const bool follows =
        fell ? across <= granted[s] &&
                   std::abs(off_model) <=
                       granted[s] + kSafety * (spread.At(s).place + fastest * h)
             : off.norm() <= granted[s];
    if (!follows) return false;
  }
  return true;
}

/** Two neighbouring samples between which a fall was reversed. */
struct Bounce {
  double before;  ///< Downward speed at the first sample. [m/s]
  double after;   ///< Upward speed at the second sample. [m/s]
  double higher;  ///< Height of the second sample above the first. [m]
  double time;    ///< Time of the second sample. [s]
  double steps;   ///< Steps between the two.
  bool stays;     ///< Whether the body rests at the second sample and the next.
};

/** Whether the body rests at sample `s` and the next. Its speed at both, and its motion
 between them, are at most a quarter of gravity's effect in a step; a flight would exceed
 that. */
bool Lies(const Motion& motion, const Fall& fall, std::size_t s) {
  const Trajectory& trajectory = motion.trajectory;
  if (s + 1 >= trajectory.samples.size()) return false;
  const double dt = motion.world.dt;
  const PointState here = fall.point.In(trajectory.samples[s]);
  const PointState next = fall.point.In(trajectory.samples[s + 1]);
  const double speed =
      std::max(std::abs(fall.n_W.dot(here.v_W)), std::abs(fall.n_W.dot(next.v_W)));
  return 4 * speed <= fall.gravity * dt &&
         4 * std::abs(fall.n_W.dot(next.p_W - here.p_W)) <= fall.gravity * dt * dt;
}

std::vector<Bounce> BouncesOf(const Motion& motion, const Fall& fall) {
  const Trajectory& trajectory = motion.trajectory;
  std::vector<Bounce> bounces;
  for (std::size_t s = 1; s < trajectory.samples.size(); ++s) {
    const double time = trajectory.times[s] - trajectory.times[s - 1];
    const PointState first = fall.point.In(trajectory.samples[s - 1]);
    const PointState second = fall.point.In(trajectory.samples[s]);
    const double before = -fall.n_W.dot(first.v_W);
    const double after = fall.n_W.dot(second.v_W);
    // Gravity alone would make it fall faster by g Δt: whatever stops half of the fall is
    // a bounce.
    if (before > 0 && after + before + fall.gravity * time > before / 2) {
      bounces.push_back({before, after, fall.n_W.dot(second.p_W - first.p_W),
                         trajectory.times[s], std::round(time / motion.world.dt),
                         Lies(motion, fall, s)});
    }
  }
  return bounces;
}

/** The impact of a bounce. */
struct BounceSpeeds {
  double came;     ///< Downward speed before the impact. [m/s]
  double left;     ///< Upward speed after the impact. [m/s]
  double unknown;  ///< Time for which gravity may act on either speed unobserved. [s]
};

/** Returns the impact of a bounce. Its time τ is where the flights through both samples
 intersect: the heights differ by h₁ − h₀ there, which is linear in τ,

    −v₀ τ − ½ g τ² = h₁ − h₀ − v₁ (Δt − τ) − ½ g (Δt − τ)²,

 with v₀ down and v₁ up. So exact flights yield exact speeds at any height. A body that
 may have hit the ground again by the second sample is not in flight there: it has left
 with at least the speed of the sample. */
BounceSpeeds SpeedsOf(const Bounce& bounce, const Fall& fall, double dt) {
  const double g = fall.gravity;
  const double between = bounce.steps * dt;
  if (2 * fall.restitution * bounce.before < g * (between + dt))
    return {bounce.before, bounce.after, between + dt};
  // A body at rest has not left the ground: otherwise the samples would show its flight.
  if (bounce.stays) {
    const double fallen = std::max(0.0, -bounce.higher);
    return {std::sqrt(bounce.before * bounce.before + 2 * g * fallen), 0, dt};
  }
  const double meet = ((bounce.after + g * between / 2) * between - bounce.higher) /
                      (bounce.before + bounce.after + g * between);
  const double fallen = g * std::clamp(meet, 0.0, between);
  return {bounce.before + fallen, bounce.after + g * between - fallen, dt};
}

/** Whether v' = −e (v − g h j) − g h (k − j) holds for a whole number j, to rounding: a
 fall of j >= 1 of the k steps is reflected, and the body rises for the others. */
bool ReflectsAfterGravity(const Bounce& bounce, const Fall& fall, double dt,
                          double rounding) {
  const double gh = fall.gravity * dt;
  const double e = fall.restitution;
  const double j =
      (bounce.after - e * bounce.before + gh * bounce.steps) / (gh * (1 + e));
  return std::round(j) >= 1 && std::round(j) <= bounce.steps &&
         std::abs(j - std::round(j)) * gh <= rounding;
}

/** Whether a bounce shows which velocity was reflected: the rules differ by e g h. */
bool TellsRulesApart(const Fall& fall, double dt, double rounding) {
  return fall.restitution * fall.gravity * dt > 2 * rounding;
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

namespace {

/** Returns how far a right engine may be from the place of the fall at each sample. */
std::vector<Allowed> AllowedOf(const Motion& motion, const Fall& fall) {
  const Envelope errors = StepErrors(motion, fall);
  const VerticalBounces truth = fall.Truth();
  const double V = truth.impact_speed();
  const double h = motion.world.dt;
  std::vector<Allowed> allowed;
  for (std::size_t s = 0; s < motion.trajectory.samples.size(); ++s) {
    const double t = motion.trajectory.times[s];
    const bool may_have_touched = t > truth.first_impact() - h;
    allowed.push_back({.scheme = errors.At(s).place + (may_have_touched ? V * h : 0),
                       .computed = fall.point.start.p_W.norm() + fall.size +
                                   (V + fall.v_along_W.norm()) * t,
                       .slop = may_have_touched ? motion.oracle.slop : 0});
  }
  return allowed;
}

Prediction Predict(const Motion& motion, const Fall& fall,
                   const std::vector<Allowed>& allowed) {
  return {fall.point.name, fall.point.Reader(), [&](std::size_t s) {
            const double t = motion.trajectory.times[s];
            PredictedState predicted;
            predicted.position = {fall.PlaceAt(t), allowed[s]};
            if (t > fall.Truth().first_impact() - motion.world.dt) return predicted;
            predicted.velocity = {
                fall.v_along_W + (fall.start.velocity - fall.gravity * t) * fall.n_W,
                {.computed = fall.v_along_W.norm() + std::abs(fall.start.velocity) +
                             fall.gravity * t}};
            return predicted;
          }};
}

/** Judges the restitution of every bounce, and whether all reflect the velocity after
 gravity. */
struct RestitutionOfBounces {
  Worst worst{MeasureKind::kRestitution,
              "(2 + e) g h/V: gravity in the step of a bounce and in the time by which "
              "depth correction moves it, or (2 + e) g (Δt + h)/V if the next may follow "
              "between samples; 64 roundings per step between"};
  bool after_gravity = true;
  bool any_telling = false;  ///< Whether any bounce tells the rules apart.

  void Take(const Motion& motion, const Fall& fall) {
    const double e = fall.restitution;
    const double dt = motion.world.dt;
    const double reach = fall.point.start.p_W.norm() + fall.size;
    for (const Bounce& bounce : BouncesOf(motion, fall)) {
      const BounceSpeeds speeds = SpeedsOf(bounce, fall, dt);
      const double tolerance =
          (2 + e) * fall.gravity * speeds.unknown / speeds.came +
          RoundingOf(motion.oracle, bounce.steps) *
              ((1 + e) + fall.gravity * reach / (speeds.came * speeds.came));
      if (tolerance > kSlowBounce) continue;
      const double rounding = RoundingOf(motion.oracle, bounce.time / dt) *
                              (fall.Truth().impact_speed() + bounce.before);
      after_gravity = after_gravity && ReflectsAfterGravity(bounce, fall, dt, rounding);
      any_telling = any_telling || TellsRulesApart(fall, dt, rounding);
      const double found = speeds.left / speeds.came;
      worst.Take(std::abs(found - e), tolerance, [&] {
        return Citing(
            "{} has {} leave at {:.6g} m/s before {:.6g} s after arriving at {:.6g} m/s: "
            "e = {:.6g}; the bodies' e is {:.6g}",
            motion.oracle.name, CitedName{fall.point.name}, speeds.left,
            CitedTime{bounce.time}, speeds.came, found, e);
      });
    }
  }
};

}  // namespace

std::vector<LawFinding> JudgeFalls(const Motion& motion, const std::vector<Fall>& falls) {
  std::vector<std::vector<Allowed>> allowed;
  std::vector<Prediction> predictions;
  allowed.reserve(falls.size());
  for (const Fall& fall : falls) {
    allowed.push_back(AllowedOf(motion, fall));
    predictions.push_back(Predict(motion, fall, allowed.back()));
  }
  std::vector<Worst> found = JudgePredictions(
      motion,
      {.position = {{.scheme =
                         "the largest error so far of engines that detect contacts "
                         "once per step, stepped next to the truth, with V h for an "
                         "impact one step late",
                     .slop = true},
                    "its fall with bounces puts it at"},
       .velocity = {{}, "v₀ + g t, before it first touches, is"}},
      predictions);
  RestitutionOfBounces restitution;
  for (std::size_t i = 0; i < falls.size(); ++i) {
    if (found.front().IsBeyond()) {
      std::vector<double> granted;
      for (std::size_t s = 0; s < allowed[i].size(); ++s) {
        granted.push_back(
            ToleranceOf(allowed[i][s], motion.oracle, StepsBefore(motion, s)));
      }
      restitution.after_gravity =
          restitution.after_gravity && FollowsAfterGravity(motion, falls[i], granted);
    }
    restitution.Take(motion, falls[i]);
  }
  const bool recognised = restitution.any_telling && restitution.after_gravity;
  std::vector<LawFinding> findings = FindingsOf(found);
  if (recognised) findings.front() = found.front().RecognisedAs(kReflectsAfterGravity);
  if (restitution.worst.IsTaken()) findings.push_back(restitution.worst.finding());
  return findings;
}

}  // namespace touchstone
