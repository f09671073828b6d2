#include "reports/worlds/laws/particle_flight.h"

#include <algorithm>
#include <array>
#include <string_view>

#include <fmt/format.h>

#include "reports/worlds/law_support/at_sample.h"
#include "reports/worlds/law_support/error_laws.h"
#include "reports/worlds/law_support/numbers.h"
#include "reports/worlds/law_support/subjects.h"
#include "reports/worlds/law_support/worst.h"
#include "reports/worlds/truth/damped_flight.h"

namespace touchstone {
namespace {

std::vector<Fault> Faults(const World& world, const Claim& claim) {
  std::vector<Fault> faults = FaultsOfSubjects(world, claim, {.particles = true});
  if (!faults.empty()) return faults;
  const std::vector<int> particles = SubjectsOf(world, claim).particles;
  for (const int i : particles) {
    if (!IsHeld(world, AnchorKind::kParticle, i)) continue;
    const std::string& name = world.particles[static_cast<std::size_t>(i)].name;
    faults.push_back(
        FaultAbout(claim, name, "a spring or a joint holds", "a free particle"));
  }
  const double c = world.particles[static_cast<std::size_t>(particles.front())].damping;
  return Joined(
      std::move(faults),
      FaultsOfNumbers(claim, {{"expected_terminal_speed", world.gravity_W.norm() / c}}));
}

std::vector<LawFinding> JudgeParticle(const Motion& motion, int index) {
  const World& world = motion.world;
  const auto i = static_cast<std::size_t>(index);
  const Particle& particle = world.particles[i];
  const PointState start{particle.p_W, particle.v_W};
  const std::string because =
      "1.5 × the largest error so far of first-order schemes, stepped next to the truth, "
      "and 64 roundings per step";
  Worst position(MeasureKind::kPositionError, because);
  Worst velocity(MeasureKind::kVelocityError, because);
  const std::array<FlightScheme, 8> schemes = FlightSchemes();
  std::array<PointState, 8> stepped;
  stepped.fill(start);
  const std::string damped = fmt::format("damped by {:.6g}/s it ", particle.damping);
  double done = 0;
  double off = 0;
  double off_speed = 0;
  for (std::size_t s = 0; s < motion.trajectory.samples.size(); ++s) {
    const double t = motion.trajectory.times[s];
    const PointState truth = DampedFlight(start, world.gravity_W, particle.damping, t);
    for (; done < StepsBefore(motion, s); ++done) {
      for (std::size_t k = 0; k < schemes.size(); ++k)
        StepFlight(schemes[k], world.gravity_W, particle.damping, world.dt, stepped[k]);
    }
    for (const PointState& state : stepped) {
      off = std::max(off, (state.p_W - truth.p_W).norm());
      off_speed = std::max(off_speed, (state.v_W - truth.v_W).norm());
    }
    const PointState& is = motion.trajectory.samples[s].particles[i];
    const double rounding = RoundingOf(motion.oracle, StepsBefore(motion, s));
    const double speed = start.v_W.norm() + world.gravity_W.norm() * t;
    const AtSample at{motion, s, particle.name};
    at.Compare(position, is.p_W, truth.p_W,
               kSafety * off + rounding * (start.p_W.norm() + speed * t),
               damped + "flies to");
    at.Compare(velocity, is.v_W, truth.v_W, kSafety * off_speed + rounding * speed,
               damped + "moves at");
  }
  return FindingsOf({position, velocity});
}

std::vector<LawFinding> Judge(const Motion& motion, const Claim& claim) {
  return WorstOfEach(SubjectsOf(motion.world, claim).particles,
                     [&](int particle) { return JudgeParticle(motion, particle); });
}

Eigen::Vector3d Place(const World& world, const Claim& claim, double t) {
  const Particle& particle = world.particles[static_cast<std::size_t>(
      SubjectsOf(world, claim).particles.front())];
  return DampedFlight({particle.p_W, particle.v_W}, world.gravity_W, particle.damping, t)
      .p_W;
}

constexpr std::array<std::string_view, 1> kNumbers = {"expected_terminal_speed"};

}  // namespace

constinit const Law kParticleFlight = {
    .name = "particle_flight",
    .documentation = "A damped particle in free flight moves by v̇ = g − c v.",
    .numbers = kNumbers,
    .faults = Faults,
    .judge = Judge,
    .smooth = true,
    .place = Place,
};

}  // namespace touchstone
