#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string_view>

#include <fmt/format.h>

#include "reports/worlds/law_support/envelope.h"
#include "reports/worlds/law_support/numbers.h"
#include "reports/worlds/law_support/point_mass.h"
#include "reports/worlds/law_support/prediction.h"
#include "reports/worlds/law_support/subjects.h"
#include "reports/worlds/laws/every_law.h"
#include "reports/worlds/truth/oscillator.h"

namespace touchstone {
namespace {

/** Largest part of a velocity or a force across the spring that an author means to be
 zero; quaternions and coordinates have nine digits. [-] */
constexpr double kAcross = 1e-9;

/** A mass that oscillates on a spring, at `rest` + x from the fixed end along d. */
struct OnSpring {
  PointMass mass;
  Eigen::Vector3d p_W;  ///< The fixed end.
  Eigen::Vector3d d_W;
  double sag;   ///< Stretch of the spring by gravity and force. [m]
  double rest;  ///< Length at rest. [m]
  Oscillator oscillator;
  Swing start;

  /** Returns an upper bound of the displacement, from the energy. [m] */
  double Amplitude() const { return std::hypot(start.x, start.v / oscillator.omega); }

  PointState StateAt(const Swing& swing) const {
    return {p_W + (rest + swing.x) * d_W, swing.v * d_W};
  }
};

const Spring* SpringOf(const World& world, const PointMass& mass) {
  const Spring* found = nullptr;
  for (const Spring& spring : world.springs) {
    if (!mass.IsAt(spring.A) && !mass.IsAt(spring.B)) continue;
    if (found) return nullptr;
    found = &spring;
  }
  return found;
}

const Anchor& FarEnd(const Spring& spring, const PointMass& mass) {
  return mass.IsAt(spring.A) ? spring.B : spring.A;
}

OnSpring OnSpringOf(const World& world, const PointMass& mass) {
  const Spring& spring = *SpringOf(world, mass);
  OnSpring on;
  on.mass = mass;
  on.p_W = *FixedPointOf(world, FarEnd(spring, mass));
  const Eigen::Vector3d arm_W = mass.start.p_W - on.p_W;
  on.d_W = arm_W.normalized();
  on.oscillator = {std::sqrt(spring.stiffness / mass.mass),
                   spring.damping / mass.mass + mass.damping};
  on.sag = on.d_W.dot(mass.a_W) / (on.oscillator.omega * on.oscillator.omega);
  on.rest = spring.rest_length + on.sag;
  on.start = {arm_W.norm() - on.rest, on.d_W.dot(mass.start.v_W)};
  return on;
}

std::string WhyNot(const World& world, const PointMass& mass) {
  const Spring* spring = SpringOf(world, mass);
  if (!spring) return "is not held at its centre by exactly one spring";
  const auto jointed = [&](const DistanceJoint& joint) {
    return mass.IsAt(joint.A) || mass.IsAt(joint.B);
  };
  if (std::any_of(world.joints.begin(), world.joints.end(), jointed) ||
      (mass.on == AnchorKind::kBody && IsPushed(world, mass.index)))
    return "is held by a rod or pushed";
  if (spring->stiffness <= 0) return "is on a spring without stiffness";
  if (!FixedPointOf(world, FarEnd(*spring, mass)))
    return "is on a spring to something that moves";
  const OnSpring on = OnSpringOf(world, mass);
  const auto across = [&](const Eigen::Vector3d& v_W) {
    return v_W.cross(on.d_W).norm() > kAcross * v_W.norm();
  };
  // Written so that a mass at the fixed end, where the spring has no direction, is
  // refused.
  if (!(on.Amplitude() < on.rest)) return "reaches the other end of its spring";
  if (across(mass.start.v_W) || across(mass.a_W))
    return "moves or is accelerated across its spring";
  if (on.oscillator.omega * world.dt >= 2)
    return "is on a spring too stiff for this step";
  return "";
}

std::vector<Fault> Faults(const World& world, const Claim& claim) {
  std::vector<Fault> faults =
      FaultsOfSubjects(world, claim, {.bodies = true, .particles = true});
  if (!faults.empty()) return faults;
  const std::vector<PointMass> masses = PointMassesOf(world, SubjectsOf(world, claim));
  if (masses.size() != 1)
    return {
        {"about", fmt::format("are {} bodies or particles", masses.size()), "one mass"}};
  const std::string why = WhyNot(world, masses.front());
  if (!why.empty()) {
    return {FaultAbout(claim, masses.front().name, why,
                       "a mass that swings along one spring to a fixed point")};
  }
  const OnSpring on = OnSpringOf(world, masses.front());
  const double omega = on.oscillator.omega;
  const double c = on.oscillator.damping;
  const double damped = std::sqrt(omega * omega - c * c / 4);
  return FaultsOfNumbers(claim, {{"expected_period", 2 * std::numbers::pi / damped},
                                 {"expected_angular_frequency", damped},
                                 {"expected_damping_ratio", c / (2 * omega)},
                                 {"expected_sag", on.sag}});
}

/** Judges the motion by `truth`, a swing at each sample, within the errors of legal
 schemes; null: within rounding. */
std::vector<Worst> JudgeBy(const Motion& motion, const OnSpring& on,
                           const std::vector<Swing>& truth, const Envelope* errors) {
  const double reach = on.p_W.norm() + on.rest + on.Amplitude();
  const AllowedWords stepped = {
      .scheme = errors
                    ? "the largest error so far of semi-implicit Euler and its adjoint, "
                      "stepped next to the truth"
                    : ""};
  return JudgePredictions(
      motion,
      {.position = {stepped,
                    fmt::format("with ω = {:.6g} rad/s and c = {:.6g}/s it is at",
                                on.oscillator.omega, on.oscillator.damping)},
       .velocity = {stepped, "the exact swing moves at"}},
      {{on.mass.name, on.mass.Reader(), [&](std::size_t s) {
          const PointState is = on.StateAt(truth[s]);
          const Apart off = errors ? errors->At(s) : Apart{};
          return PredictedState{
              .position = {{is.p_W, {.scheme = off.place, .computed = reach}}},
              .velocity = {
                  {is.v_W,
                   {.scheme = off.speed, .computed = on.oscillator.omega * reach}}}};
        }}});
}

/** Returns the swing at each sample, stepped by `scheme`. */
std::vector<Swing> SteppedAlong(const Motion& motion, const OnSpring& on,
                                SwingScheme scheme) {
  std::vector<Swing> along;
  Swing swing = on.start;
  long done = 0;
  for (std::size_t s = 0; s < motion.trajectory.samples.size(); ++s) {
    for (; done < WholeStepsBefore(motion, s); ++done)
      swing = Stepped(scheme, on.oscillator, motion.world.dt, swing);
    along.push_back(swing);
  }
  return along;
}

std::vector<LawFinding> Judge(const Motion& motion, const Claim& claim) {
  const OnSpring on = OnSpringOf(
      motion.world, PointMassesOf(motion.world, SubjectsOf(motion.world, claim)).front());
  std::vector<Swing> truth;
  for (std::size_t s = 0; s < motion.trajectory.samples.size(); ++s)
    truth.push_back(on.oscillator.After(on.start, motion.trajectory.times[s]));
  Envelope errors(motion);
  for (const SwingScheme scheme : kSymplecticSwings) {
    Swing swing = on.start;
    errors.Include(
        [&] { swing = Stepped(scheme, on.oscillator, motion.world.dt, swing); },
        [&](std::size_t s) {
          return Apart{std::abs(swing.x - truth[s].x), std::abs(swing.v - truth[s].v)};
        });
  }
  const std::vector<Worst> found = JudgeBy(motion, on, truth, &errors);
  std::string_view recognised;
  if (AnyBeyond(found)) {
    for (const auto& [scheme, name] :
         {std::pair(SwingScheme::kImplicit, "implicit Euler"),
          std::pair(SwingScheme::kExplicit, "explicit Euler")}) {
      if (!AnyBeyond(JudgeBy(motion, on, SteppedAlong(motion, on, scheme), nullptr)))
        recognised = name;
    }
  }
  return FindingsOf(found, recognised);
}

std::vector<Eigen::Vector3d> Places(const World& world, const Claim& claim,
                                    const std::vector<double>& times) {
  const OnSpring on =
      OnSpringOf(world, PointMassesOf(world, SubjectsOf(world, claim)).front());
  std::vector<Eigen::Vector3d> places;
  places.reserve(times.size());
  for (const double t : times)
    places.push_back(on.StateAt(on.oscillator.After(on.start, t)).p_W);
  return places;
}

constexpr std::array<std::string_view, 4> kNumbers = {"expected_angular_frequency",
                                                      "expected_damping_ratio",
                                                      "expected_period", "expected_sag"};

}  // namespace

/** A mass on one spring to a fixed point oscillates along it: ẍ = −ω² x − c ẋ with ω² =
 k/m and c = b/m plus the damping of a particle. x is measured from the rest length L +
 a/ω² under the acceleration a of gravity and force along the spring (truth/oscillator.h).
 [m], [m/s]

 Semi-implicit Euler and its adjoint keep the phase to ω² h²/24 and are off by up to ½ ω h
 of the amplitude. Both, and a variant with implicit damping, are stepped next to the
 truth. The tolerance is 1.5 times the largest error so far, and 64 roundings per step.
 Implicit and explicit Euler, which lose and gain energy, are recognised by their own
 discrete forms.

 About: one body, held at its centre, or one particle, that only moves along the spring
 and never reaches the spring's other end. Numbers: expected_period,
 expected_angular_frequency (damped), expected_damping_ratio, expected_sag a/ω². */
constinit const Law kSpringOscillation = {
    .name = "spring_oscillation",
    .documentation =
        "A mass on one spring to a fixed point oscillates along it, damped or not.",
    .numbers = kNumbers,
    .faults = Faults,
    .judge = Judge,
    .smooth = true,
    .places = Places,
};

}  // namespace touchstone
