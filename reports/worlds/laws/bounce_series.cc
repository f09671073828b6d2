#include "reports/worlds/laws/bounce_series.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "reports/worlds/laws/energy_bound.h"
#include "reports/worlds/laws/error_laws.h"
#include "reports/worlds/laws/landing.h"
#include "reports/worlds/laws/numbers.h"
#include "reports/worlds/laws/subjects.h"
#include "reports/worlds/laws/words.h"
#include "reports/worlds/laws/worst.h"
#include "reports/worlds/truth/vertical_bounces.h"

namespace touchstone {
namespace {

/** Largest angle between directions that an author means to be one: those of quaternions
 with 16 digits. [rad] */
constexpr double kParallel = 1e-9;

/** How much of a restitution may be unknown before a bounce is too slow to tell. [-] */
constexpr double kSlowBounce = 0.25;

/** One body that falls on a plane. */
struct Fall {
  Landing landing;
  Height start;
  double gravity;  ///< Along the plane's normal, > 0. [m/s²]

  VerticalBounces Truth() const { return {start, gravity, landing.restitution}; }
};

Fall FallOf(const World& world, int index) {
  const Landing landing = *LandingOf(world, index);
  const RigidBody& body = world.bodies[static_cast<std::size_t>(index)];
  const Eigen::Vector3d a_W = world.gravity_W + body.force_W / body.mass;
  return {landing,
          {std::max(landing.gap, 0.0), landing.n_W.dot(body.v_WB)},
          -landing.n_W.dot(a_W)};
}

bool IsAlong(const Eigen::Vector3d& v, const Eigen::Vector3d& n) {
  return v.cross(n).norm() <= kParallel * v.norm();
}

std::string WhyNot(const World& world, int index) {
  const RigidBody& body = world.bodies[static_cast<std::size_t>(index)];
  const std::optional<Landing> landing = LandingOf(world, index);
  if (!landing) return "is above no static half-space or box, or no sphere or box itself";
  const Fall fall = FallOf(world, index);
  const Eigen::Vector3d a_W = world.gravity_W + body.force_W / body.mass;
  if (fall.gravity <= 0 || !IsAlong(a_W, landing->n_W))
    return "does not fall along the normal of what is below it";
  if (!IsAlong(body.v_WB, landing->n_W) || !body.w_WB.isZero(0))
    return "does not start straight down";
  if (landing->gap < 0) return "starts inside what is below it";
  if (std::holds_alternative<Box>(body.placed.shape)) {
    const Eigen::Vector3d n_B = body.placed.X_WB.R_WB.transpose() * landing->n_W;
    if (n_B.cwiseAbs().maxCoeff() < 1 - kParallel)
      return "is a box that does not lie flat";
  }
  if (IsHeld(world, AnchorKind::kBody, index) || IsPushed(world, index))
    return "is held or struck";
  return "";
}

std::vector<Fault> Faults(const World& world, const Claim& claim) {
  std::vector<Fault> faults = FaultsOfSubjects(world, claim, {true, false, false});
  if (!faults.empty()) return faults;
  for (const int i : SubjectsOf(world, claim).bodies) {
    const std::string& name = world.bodies[static_cast<std::size_t>(i)].name;
    const std::string why = WhyNot(world, i);
    if (!why.empty()) {
      faults.push_back({WhereAbout(claim, name),
                        fmt::format("is {}, which {}", name, why),
                        "a sphere, or a box that lies flat, falling straight on a static "
                        "half-space or box"});
      continue;
    }
    const Fall fall = FallOf(world, i);
    const VerticalBounces truth = fall.Truth();
    const double V = truth.impact_speed() * fall.landing.restitution;
    faults = Joined(
        std::move(faults),
        FaultsOfNumbers(claim, {{"expected_first_impact", truth.first_impact()},
                                {"expected_impact_speed", truth.impact_speed()},
                                {"expected_total_time", truth.total_time()},
                                {"expected_first_apex", V * V / (2 * fall.gravity)}}));
  }
  return faults;
}

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
          BounceRule::kStartOfStep, seen,         fall.gravity, fall.landing.restitution,
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

std::vector<Bounce> BouncesOf(const Motion& motion, int index, const Fall& fall) {
  const Trajectory& trajectory = motion.trajectory;
  const auto speed = [&](std::size_t s) {
    return fall.landing.n_W.dot(
        trajectory.samples[s].bodies[static_cast<std::size_t>(index)].v_WB);
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
  const double e = fall.landing.restitution;
  const double j =
      (bounce.after - e * bounce.before + gh * bounce.steps) / (gh * (1 + e));
  return std::round(j) >= 1 && std::round(j) <= bounce.steps &&
         std::abs(j - std::round(j)) * gh <= rounding;
}

std::vector<LawFinding> Judge(const Motion& motion, const Claim& claim) {
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
  for (const int i : SubjectsOf(world, claim).bodies) {
    const RigidBody& body = world.bodies[static_cast<std::size_t>(i)];
    const Fall fall = FallOf(world, i);
    const VerticalBounces truth = fall.Truth();
    const double V = truth.impact_speed();
    const std::vector<double> errors = StepErrors(motion, fall);
    const double reach = body.placed.X_WB.p_WB.norm() + BoundingRadius(body.placed.shape);
    for (std::size_t s = 0; s < trajectory.samples.size(); ++s) {
      const double t = trajectory.times[s];
      const Eigen::Vector3d& is =
          trajectory.samples[s].bodies[static_cast<std::size_t>(i)].p_WB;
      const Eigen::Vector3d p_W =
          body.placed.X_WB.p_WB + (truth.At(t).gap - fall.start.gap) * fall.landing.n_W;
      const double late = t > truth.first_impact() - world.dt ? V * world.dt : 0;
      position.Take(
          (is - p_W).norm(),
          kSafety * (errors[s] + late) +
              RoundingOf(motion.oracle, StepsBefore(motion, s)) * (reach + V * t),
          [&] {
            return fmt::format(
                "{} has {} at {} after {:.6g} s; falling from {:.6g} m with "
                "e = {:.6g} puts it at {}",
                motion.oracle.name, body.name, Words(is), t, fall.start.gap,
                fall.landing.restitution, Words(p_W));
          });
    }
    const double e = fall.landing.restitution;
    for (const Bounce& bounce : BouncesOf(motion, i, fall)) {
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
            motion.oracle.name, body.name, bounce.after, bounce.time, bounce.before,
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

Eigen::Vector3d Place(const World& world, const Claim& claim, double t) {
  const int index = SubjectsOf(world, claim).bodies.front();
  const Fall fall = FallOf(world, index);
  const Eigen::Vector3d& p_WB =
      world.bodies[static_cast<std::size_t>(index)].placed.X_WB.p_WB;
  return p_WB + (fall.Truth().At(t).gap - fall.start.gap) * fall.landing.n_W;
}

}  // namespace

constinit const Law kBounceSeries = {
    "bounce_series",
    "A sphere or a flat box falls straight on a static plane and leaves with e times its "
    "speed, again and again.",
    Faults,
    Judge,
    false,
    Place};

}  // namespace touchstone
