#include <array>
#include <string_view>

#include "reports/text/told_apart.h"
#include "reports/worlds/law_support/citing.h"
#include "reports/worlds/law_support/error_laws.h"
#include "reports/worlds/law_support/isolated_system.h"
#include "reports/worlds/law_support/numbers.h"
#include "reports/worlds/law_support/subjects.h"
#include "reports/worlds/law_support/universal.h"
#include "reports/worlds/law_support/worst.h"
#include "reports/worlds/laws/every_law.h"
#include "reports/worlds/truth/mechanics.h"

namespace touchstone {
namespace {

std::vector<Fault> Faults(const World& world, const Claim& claim) {
  std::vector<Fault> faults = FaultsOfIsolation(world, claim);
  if (!faults.empty()) return faults;
  const double at_start =
      MomentumOf(world, StateAtStart(world), SubjectsOf(world, claim)).norm();
  return FaultsOfNumbers(claim, {{"expected_momentum", at_start}});
}

std::vector<LawFinding> Judge(const Motion& motion, const Claim& claim) {
  const World& world = motion.world;
  const Subjects subjects = SubjectsOf(world, claim);
  Eigen::Vector3d force_W = MassOf(world, subjects) * world.gravity_W;
  double kicks = 0;
  for (const int i : subjects.bodies)
    force_W += world.bodies[static_cast<std::size_t>(i)].force_W;
  for (const Push& push : world.pushes) kicks += push.J_W.norm();

  Worst drift(MeasureKind::kMomentumDrift,
              "64 roundings per step: impulses are equal and opposite, and every scheme "
              "integrates a constant force exactly; and velocities that are roundings of "
              "positions over a step",
              Grants::kRounding);
  const Eigen::Matrix3d kept = ProjectionOf(claim);
  const Trajectory& trajectory = motion.trajectory;
  const Eigen::Vector3d P_0 = MomentumOf(world, StateAtStart(world), subjects);
  double size = 0;
  for (std::size_t s = 0; s < trajectory.samples.size(); ++s) {
    const double t = trajectory.times[s];
    const WorldState& state = trajectory.samples[s];
    Eigen::Vector3d truth = P_0 + force_W * t;
    for (const Push& push : world.pushes) {
      const bool counts = std::find(subjects.bodies.begin(), subjects.bodies.end(),
                                    push.body) != subjects.bodies.end();
      if (counts && t > push.time + world.dt / 2) truth += push.J_W;
    }
    size = std::max(size, MomentumSize(world, state, subjects));
    const Eigen::Vector3d P = MomentumOf(world, state, subjects);
    drift.Take((kept * (P - truth)).norm(),
               RoundingOf(motion.oracle, StepsBefore(motion, s)) *
                       (size + force_W.norm() * t + kicks) +
                   NoiseOfPositions(world, state, subjects, motion.oracle.unit_roundoff)
                       .momentum,
               [&] {
                 const ToldApart told = TellApart(P, truth, 9);
                 return Citing(
                     "{} has a momentum of {} N s after {:.6g} s; the start and the "
                     "external impulses give {}",
                     motion.oracle.name, told.a, CitedTime{t}, told.b);
               });
  }
  return FindingsOf({drift});
}

std::optional<Claim> Universal(const World& world) {
  if (!TouchesNothingFixed(world)) return std::nullopt;
  return ClaimAboutAll(kConservesMomentum, world);
}

constexpr std::array<std::string_view, 4> kNumbers = {"expected_momentum", "x", "y", "z"};

}  // namespace

/** The linear momentum of an isolated system is changed only by external forces and
 pushes: P(t) = P(0) + t Σ (m g + F) + Σ J. [N s]

 Contacts, springs and joints within the system apply equal and opposite impulses, for any
 step and however badly they are solved. Every scheme integrates a constant force exactly.
 So the tolerance is rounding alone.

 About: bodies, particles and cloths that nothing else holds. Numbers: x, y, z, a
 direction along which momentum is conserved if the rest is not (a frictionless floor); if
 absent, all of it is. expected_momentum: |P(0)|. */
constinit const Law kConservesMomentum = {
    .name = "conserves_momentum",
    .documentation =
        "Linear momentum is changed by gravity, forces and pushes alone; x, y, z: only "
        "along "
        "that direction.",
    .numbers = kNumbers,
    .faults = Faults,
    .judge = Judge,
    .universal = Universal,
    .of_steps = true,
};

}  // namespace touchstone
