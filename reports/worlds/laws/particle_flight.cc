#include "reports/worlds/laws/particle_flight.h"

#include <algorithm>
#include <array>
#include <string_view>

#include <fmt/format.h>

#include "reports/text/format_vector.h"
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
    faults.push_back({WhereAbout(claim, name),
                      fmt::format("is {}, which a spring or a joint holds", name),
                      "a free particle"});
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
    position.Take(
        (is.p_W - truth.p_W).norm(),
        kSafety * off + rounding * (start.p_W.norm() + speed * t), [&] {
          return fmt::format(
              "{} has {} at {} after {:.6g} s; damped by {:.6g}/s it flies to {}",
              motion.oracle.name, particle.name, FormatVector(is.p_W, 9), t,
              particle.damping, FormatVector(truth.p_W, 9));
        });
    velocity.Take(
        (is.v_W - truth.v_W).norm(), kSafety * off_speed + rounding * speed, [&] {
          return fmt::format(
              "{} has {} moving at {} after {:.6g} s; damped by {:.6g}/s it moves at {}",
              motion.oracle.name, particle.name, FormatVector(is.v_W, 9), t,
              particle.damping, FormatVector(truth.v_W, 9));
        });
  }
  return FindingsOf({position, velocity});
}

std::vector<LawFinding> Judge(const Motion& motion, const Claim& claim) {
  std::vector<LawFinding> findings;
  for (const int i : SubjectsOf(motion.world, claim).particles) {
    for (LawFinding& finding : JudgeParticle(motion, i))
      findings.push_back(std::move(finding));
  }
  return WorstOfEach(findings);
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
