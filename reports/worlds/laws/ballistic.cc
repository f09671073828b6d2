#include <algorithm>
#include <array>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include "reports/worlds/law_support/each_subject.h"
#include "reports/worlds/law_support/envelope.h"
#include "reports/worlds/law_support/point_mass.h"
#include "reports/worlds/law_support/prediction.h"
#include "reports/worlds/laws/every_law.h"
#include "reports/worlds/truth/damped_flight.h"

namespace touchstone {
namespace {

/** One body or particle in free flight. */
struct Flight {
  PointMass point;
  std::vector<std::pair<double, Eigen::Vector3d>> kicks;  ///< Time [s], Δv [m/s].

  /** Returns its state after `t` [s], without the kicks. */
  PointState Unkicked(double t) const {
    return DampedFlight(point.start, point.a_W, point.damping, t);
  }

  PointState At(double t, double dt) const {
    PointState at = Unkicked(t);
    for (const auto& [time, dv_W] : kicks) {
      // Half a step of tolerance: times are multiples of the step.
      if (t < time + dt / 2) continue;
      at.p_W += dv_W * (t - time);
      at.v_W += dv_W;
    }
    return at;
  }

  /** Returns an upper bound of its speed until `t`. [m/s] */
  double SpeedUntil(double t) const {
    double speed = point.start.v_W.norm() + point.a_W.norm() * t;
    for (const auto& [time, dv_W] : kicks) speed += dv_W.norm();
    return speed;
  }

  /** Returns the largest error so far of the schemes for such a flight. Kicks move them
   as they move the truth. */
  Envelope Errors(const Motion& motion) const {
    Envelope errors(motion);
    for (const FlightScheme& scheme : FlightSchemes()) {
      PointState stepped = point.start;
      errors.Include(
          [&] { StepFlight(scheme, point.a_W, point.damping, motion.world.dt, stepped); },
          [&](std::size_t s) {
            const PointState truth = Unkicked(motion.trajectory.times[s]);
            return Apart{(stepped.p_W - truth.p_W).norm(),
                         (stepped.v_W - truth.v_W).norm()};
          });
    }
    return errors;
  }
};

/** Returns the flights of the subjects, bodies first. */
std::vector<Flight> FlightsOf(const World& world, const Claim& claim) {
  std::vector<Flight> flights;
  for (PointMass& point : PointMassesOf(world, SubjectsOf(world, claim))) {
    Flight flight{std::move(point), {}};
    for (const Push& push : world.pushes) {
      if (flight.point.on == AnchorKind::kBody && push.body == flight.point.index)
        flight.kicks.emplace_back(push.time, push.J_W / flight.point.mass);
    }
    flights.push_back(std::move(flight));
  }
  return flights;
}

std::string WhyNot(const World& world, const PointMass& point) {
  return IsHeld(world, point.on, point.index) ? "is held by a spring or a joint" : "";
}

ExpectedNumbers NumbersOfPoint(const World& /*world*/, const PointMass& point) {
  if (point.damping == 0) return {};
  return {{"expected_terminal_speed", point.a_W.norm() / point.damping}};
}

std::vector<Fault> Faults(const World& world, const Claim& claim) {
  return FaultsOfEachPoint(world, claim,
                           {.why_not = WhyNot,
                            .expected = "a body or particle that nothing holds",
                            .numbers = NumbersOfPoint});
}

Prediction Predict(const Motion& motion, const Flight& flight) {
  const auto errors = std::make_shared<const Envelope>(flight.Errors(motion));
  const bool damped = flight.point.damping > 0;
  return {flight.point.name, flight.point.Reader(),
          [&motion, &flight, errors, damped](std::size_t s) -> PredictedState {
            const double t = motion.trajectory.times[s];
            const PointState truth = flight.At(t, motion.world.dt);
            const double speed = flight.SpeedUntil(t);
            const double reach = flight.point.start.p_W.norm() + speed * t;
            // Without damping every scheme integrates the constant force exactly.
            const double off_speed = damped ? errors->At(s).speed : 0;
            return {.position = {{truth.p_W,
                                  {.scheme = errors->At(s).place, .computed = reach}}},
                    .velocity = {{truth.v_W, {.scheme = off_speed, .computed = speed}}}};
          }};
}

/** Returns how far a motion without damping is from semi-implicit Euler's parabola, which
 is ½ a h t off. */
NearestScheme FromEuler(const Motion& motion, const std::vector<Flight>& flights) {
  NearestScheme scheme{"semi-implicit Euler"};
  for (std::size_t s = 0; s < motion.trajectory.samples.size(); ++s) {
    const double t = motion.trajectory.times[s];
    for (const Flight& flight : flights) {
      const Eigen::Vector3d euler_W = flight.point.a_W * (motion.world.dt * t / 2);
      const Eigen::Vector3d is_W = flight.point.In(motion.trajectory.samples[s]).p_W;
      const Eigen::Vector3d off_W = is_W - flight.At(t, motion.world.dt).p_W - euler_W;
      scheme.error = std::max(scheme.error, off_W.norm());
    }
  }
  return scheme;
}

/** Judges flights that are all damped, or all not. */
std::vector<LawFinding> JudgeAlike(const Motion& motion,
                                   const std::vector<Flight>& flights, bool damped) {
  if (flights.empty()) return {};
  std::vector<Prediction> predictions;
  predictions.reserve(flights.size());
  for (const Flight& flight : flights) predictions.push_back(Predict(motion, flight));
  const AllowedWords stepped = {
      .scheme =
          "the largest error so far of first-order schemes, stepped next to the truth"};
  if (damped) {
    return FindingsOf(
        JudgePredictions(motion,
                         {.position = {stepped, "its damped flight leads to"},
                          .velocity = {stepped, "its damped flight has it moving at"}},
                         predictions));
  }
  std::vector<LawFinding> findings = FindingsOf(JudgePredictions(
      motion,
      {.position = {stepped, "x₀ + v₀ t + ½ a t² is"}, .velocity = {{}, "v₀ + a t is"}},
      predictions));
  findings.front().scheme = FromEuler(motion, flights);
  return findings;
}

std::vector<LawFinding> Judge(const Motion& motion, const Claim& claim) {
  std::vector<Flight> flights = FlightsOf(motion.world, claim);
  const auto undamped =
      std::stable_partition(flights.begin(), flights.end(),
                            [](const Flight& f) { return f.point.damping > 0; });
  const std::vector<Flight> free(undamped, flights.end());
  flights.erase(undamped, flights.end());
  return WorstOfEach({0, 1}, [&](int damped) {
    return damped ? JudgeAlike(motion, flights, true) : JudgeAlike(motion, free, false);
  });
}

std::vector<Eigen::Vector3d> Places(const World& world, const Claim& claim,
                                    const std::vector<double>& times) {
  const Flight flight = FlightsOf(world, claim).front();
  std::vector<Eigen::Vector3d> places;
  places.reserve(times.size());
  for (const double t : times) places.push_back(flight.At(t, world.dt).p_W);
  return places;
}

constexpr std::array<std::string_view, 1> kAliases = {"particle_flight"};
constexpr std::array<std::string_view, 1> kNumbers = {"expected_terminal_speed"};

}  // namespace

/** A body or particle in free flight moves along x = x₀ + v₀ t + ½ a t², v = v₀ + a t,
 with a = g + F/m. A push J at t_J adds (t − t_J) J/m and J/m. The velocity of a damped
 particle decays as e^{−c t}: v̇ = g − c v (truth/damped_flight.h). [m/s], [m]

 Tolerance: 1.5 times the largest error so far of eight schemes that are stepped next to
 the truth: damping or gravity first, position or velocity first, and damping by e^(−c h)
 or by 1 − c h. All are of first order. Without damping they
 are semi-implicit and explicit Euler, off by ±½ a h t in position and exact in velocity:
 N steps of v += a h, x += v h sum to v₀ t + a h² N (N+1)/2. 64 roundings per step are
 added.

 About: bodies and particles that no spring, joint or contact holds. Numbers:
 expected_terminal_speed, |g|/c. Measures: position, velocity. */
constinit const Law kBallistic = {
    .name = "ballistic",
    .aliases = kAliases,
    .documentation =
        "A body in free flight moves along x₀ + v₀ t + ½ (g + F/m) t²; a damped particle "
        "by v̇ = g − c v.",
    .numbers = kNumbers,
    .faults = Faults,
    .judge = Judge,
    .smooth = true,
    .places = Places,
};

}  // namespace touchstone
