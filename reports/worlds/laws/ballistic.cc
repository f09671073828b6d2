#include "reports/worlds/laws/ballistic.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "reports/worlds/law_support/at_sample.h"
#include "reports/worlds/law_support/error_laws.h"
#include "reports/worlds/law_support/numbers.h"
#include "reports/worlds/law_support/point_mass.h"
#include "reports/worlds/law_support/subjects.h"
#include "reports/worlds/law_support/worst.h"

namespace touchstone {
namespace {

/** One body or particle in free flight. */
struct Flight {
  PointMass point;
  std::vector<std::pair<double, Eigen::Vector3d>> kicks;  ///< Time [s], Δv [m/s].

  PointState At(double t, double dt) const {
    const auto& [p_W, v_W] = point.start;
    PointState at{p_W + v_W * t + point.a_W * (t * t / 2), v_W + point.a_W * t};
    for (const auto& [time, dv_W] : kicks) {
      // Half a step of tolerance: times are multiples of the step.
      if (t < time + dt / 2) continue;
      at.p_W += dv_W * (t - time);
      at.v_W += dv_W;
    }
    return at;
  }

  /** Upper bound of the terms |x| + |v| t that a position is the sum of; Speed() is the
   same bound |v| + |a| t of the velocity. */
  double Reach(double t) const { return point.start.p_W.norm() + Speed(t) * t; }
  double Speed(double t) const {
    double speed = point.start.v_W.norm() + point.a_W.norm() * t;
    for (const auto& [time, dv_W] : kicks) speed += dv_W.norm();
    return speed;
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

std::vector<Fault> Faults(const World& world, const Claim& claim) {
  std::vector<Fault> faults =
      FaultsOfSubjects(world, claim, {.bodies = true, .particles = true});
  if (!faults.empty()) return faults;
  for (const PointMass& point : PointMassesOf(world, SubjectsOf(world, claim))) {
    if (IsHeld(world, point.on, point.index)) {
      faults.push_back(FaultAbout(claim, point.name, "a spring or a joint holds",
                                  "a body or particle that nothing holds"));
    }
    if (point.damping > 0) {
      faults.push_back(
          FaultAbout(claim, point.name, "is damped",
                     "a particle without damping (particle_flight knows damped ones)"));
    }
  }
  return Joined(std::move(faults), FaultsOfNumbers(claim, {}));
}

std::vector<LawFinding> Judge(const Motion& motion, const Claim& claim) {
  const World& world = motion.world;
  Worst position(
      MeasureKind::kPositionError,
      "1.5 × ½ |a| h t, the error of semi-implicit Euler, and 64 roundings per step");
  Worst velocity(
      MeasureKind::kVelocityError,
      "64 roundings per step: every scheme integrates a constant force exactly",
      Grants::kRounding);
  const std::vector<Flight> flights = FlightsOf(world, claim);
  NearestScheme scheme{"semi-implicit Euler"};
  for (std::size_t s = 0; s < motion.trajectory.samples.size(); ++s) {
    const double t = motion.trajectory.times[s];
    const double rounding = RoundingOf(motion.oracle, StepsBefore(motion, s));
    for (const Flight& flight : flights) {
      const PointState is = flight.point.In(motion.trajectory.samples[s]);
      const PointState truth = flight.At(t, world.dt);
      const AtSample at{motion, s, flight.point.name};
      const Eigen::Vector3d euler_W = flight.point.a_W * (world.dt * t / 2);
      at.Compare(position, is.p_W, truth.p_W,
                 kSafety * euler_W.norm() + rounding * flight.Reach(t),
                 "x₀ + v₀ t + ½ a t² is");
      scheme.error = std::max(scheme.error, (is.p_W - truth.p_W - euler_W).norm());
      at.Compare(velocity, is.v_W, truth.v_W, rounding * flight.Speed(t), "v₀ + a t is");
    }
  }
  std::vector<LawFinding> findings = FindingsOf({position, velocity});
  findings.front().scheme = scheme;
  return findings;
}

Eigen::Vector3d Place(const World& world, const Claim& claim, double t) {
  return FlightsOf(world, claim).front().At(t, world.dt).p_W;
}

}  // namespace

constinit const Law kBallistic = {
    .name = "ballistic",
    .documentation = "A body in free flight moves along x₀ + v₀ t + ½ (g + F/m) t².",
    .faults = Faults,
    .judge = Judge,
    .smooth = true,
    .place = Place,
};

}  // namespace touchstone
