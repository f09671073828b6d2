#include "reports/worlds/laws/ballistic.h"

#include <fmt/format.h>

#include "reports/text/format_vector.h"
#include "reports/worlds/law_support/error_laws.h"
#include "reports/worlds/law_support/numbers.h"
#include "reports/worlds/law_support/subjects.h"
#include "reports/worlds/law_support/worst.h"

namespace touchstone {
namespace {

/** One body or particle in free flight. */
struct Flight {
  std::string name;
  PointState start;
  Eigen::Vector3d a_W;                                    ///< [m/s²]
  std::vector<std::pair<double, Eigen::Vector3d>> kicks;  ///< Time [s], Δv [m/s].

  PointState At(double t, double dt) const {
    PointState at{start.p_W + start.v_W * t + a_W * (t * t / 2), start.v_W + a_W * t};
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
  double Reach(double t) const { return start.p_W.norm() + Speed(t) * t; }
  double Speed(double t) const {
    double speed = start.v_W.norm() + a_W.norm() * t;
    for (const auto& [time, dv_W] : kicks) speed += dv_W.norm();
    return speed;
  }
};

Flight FlightOfBody(const World& world, int index) {
  const RigidBody& body = world.bodies[static_cast<std::size_t>(index)];
  Flight flight{body.name,
                {body.placed.X_WB.p_WB, body.v_WB},
                world.gravity_W + body.force_W / body.mass,
                {}};
  for (const Push& push : world.pushes) {
    if (push.body == index) flight.kicks.emplace_back(push.time, push.J_W / body.mass);
  }
  return flight;
}

Flight FlightOfParticle(const World& world, int index) {
  const Particle& particle = world.particles[static_cast<std::size_t>(index)];
  return {particle.name, {particle.p_W, particle.v_W}, world.gravity_W, {}};
}

std::vector<Fault> Faults(const World& world, const Claim& claim) {
  std::vector<Fault> faults =
      FaultsOfSubjects(world, claim, {.bodies = true, .particles = true});
  if (!faults.empty()) return faults;
  const Subjects subjects = SubjectsOf(world, claim);
  const auto held = [&](AnchorKind on, int index, const std::string& name) {
    if (!IsHeld(world, on, index)) return;
    faults.push_back({WhereAbout(claim, name),
                      fmt::format("is {}, which a spring or a joint holds", name),
                      "a body or particle that nothing holds"});
  };
  for (const int i : subjects.bodies)
    held(AnchorKind::kBody, i, world.bodies[static_cast<std::size_t>(i)].name);
  for (const int i : subjects.particles) {
    const Particle& particle = world.particles[static_cast<std::size_t>(i)];
    held(AnchorKind::kParticle, i, particle.name);
    if (particle.damping > 0) {
      faults.push_back(
          {WhereAbout(claim, particle.name),
           fmt::format("is {}, which is damped", particle.name),
           "a particle without damping (particle_flight knows damped ones)"});
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
      "64 roundings per step: every scheme integrates a constant force exactly");
  const auto hold = [&](const Flight& flight, std::size_t s, const PointState& is) {
    const double t = motion.trajectory.times[s];
    const double rounding = RoundingOf(motion.oracle, StepsBefore(motion, s));
    const PointState truth = flight.At(t, world.dt);
    position.Take(
        (is.p_W - truth.p_W).norm(),
        kSafety * flight.a_W.norm() * world.dt * t / 2 + rounding * flight.Reach(t), [&] {
          return fmt::format("{} has {} at {} after {:.6g} s; x₀ + v₀ t + ½ a t² is {}",
                             motion.oracle.name, flight.name, FormatVector(is.p_W, 9), t,
                             FormatVector(truth.p_W, 9));
        });
    velocity.Take((is.v_W - truth.v_W).norm(), rounding * flight.Speed(t), [&] {
      return fmt::format("{} has {} moving at {} after {:.6g} s; v₀ + a t is {}",
                         motion.oracle.name, flight.name, FormatVector(is.v_W, 9), t,
                         FormatVector(truth.v_W, 9));
    });
  };
  const Subjects subjects = SubjectsOf(world, claim);
  for (std::size_t s = 0; s < motion.trajectory.samples.size(); ++s) {
    const WorldState& state = motion.trajectory.samples[s];
    for (const int i : subjects.bodies) {
      const BodyState& is = state.bodies[static_cast<std::size_t>(i)];
      hold(FlightOfBody(world, i), s, {is.p_WB, is.v_WB});
    }
    for (const int i : subjects.particles) {
      hold(FlightOfParticle(world, i), s, state.particles[static_cast<std::size_t>(i)]);
    }
  }
  return FindingsOf({position, velocity});
}

Eigen::Vector3d Place(const World& world, const Claim& claim, double t) {
  const Subjects subjects = SubjectsOf(world, claim);
  if (!subjects.bodies.empty())
    return FlightOfBody(world, subjects.bodies.front()).At(t, world.dt).p_W;
  return FlightOfParticle(world, subjects.particles.front()).At(t, world.dt).p_W;
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
