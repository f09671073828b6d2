#include "reports/worlds/laws/energy_never_rises.h"

#include <algorithm>

#include <fmt/format.h>

#include "reports/text/told_apart.h"
#include "reports/worlds/law_support/energy_bound.h"
#include "reports/worlds/law_support/isolated_system.h"
#include "reports/worlds/law_support/numbers.h"
#include "reports/worlds/law_support/subjects.h"
#include "reports/worlds/law_support/universal.h"
#include "reports/worlds/law_support/worst.h"

namespace touchstone {
namespace {

/** The least restitution at which an eccentric impact with friction was seen to gain
 energy. [-] */
constexpr double kGainingRestitution = 0.5;

std::vector<Fault> Faults(const World& world, const Claim& claim) {
  std::vector<Fault> faults =
      FaultsOfSubjects(world, claim, {.bodies = true, .particles = true, .cloths = true});
  if (!faults.empty()) return faults;
  faults = FaultsOfEnergy(world, claim);
  if (!faults.empty()) return faults;
  for (const int i : SubjectsOf(world, claim).bodies) {
    const RigidBody& body = world.bodies[static_cast<std::size_t>(i)];
    if (!body.collides || std::holds_alternative<Sphere>(body.placed.shape)) continue;
    const auto gains = [&](const RigidBody& other) {
      return &other != &body && other.collides && body.friction * other.friction > 0 &&
             std::min(body.restitution, other.restitution) >= kGainingRestitution;
    };
    if (std::any_of(world.bodies.begin(), world.bodies.end(), gains)) {
      faults.push_back(FaultAbout(
          claim, body.name,
          fmt::format("may hit another with e >= {} and friction", kGainingRestitution),
          "a sphere, less restitution, or no friction: Newton's rule may gain energy in "
          "eccentric impacts"));
    }
  }
  return Joined(std::move(faults), FaultsOfNumbers(claim, {}));
}

std::vector<LawFinding> Judge(const Motion& motion, const Claim& claim) {
  const World& world = motion.world;
  const Subjects subjects = SubjectsOf(world, claim);
  const EnergyAlong along = EnergyAlongOf(motion, subjects);
  Worst worst(MeasureKind::kEnergyDrift, BecauseOfEnergy());
  const auto earlier = along.WorstEarlier(1);
  bool reflects = true;
  for (std::size_t s = 0; s < along.energies.size(); ++s) {
    const double E = along.energies[s].total();
    for (const std::size_t from : earlier[s]) {
      const double before = along.Earlier(from);
      const double tolerance = along.Tolerance(from, s);
      worst.Take(std::max(0.0, E - before), tolerance, [&] {
        const ToldApart told = TellApart(E, before, 9);
        return fmt::format("{} has {} J after {:.6g} s; it had {} J after {:.6g} s",
                           motion.oracle.name, told.a, motion.trajectory.times[s], told.b,
                           motion.trajectory.times[from]);
      });
      reflects = reflects && (E - before <= tolerance ||
                              along.ReflectsAfterGravity(E - before, from, s));
    }
  }
  return FindingsOf({worst}, reflects ? kReflectsAfterGravity : "");
}

}  // namespace

constinit const Law kEnergyNeverRises = {
    .name = "energy_never_rises",
    .documentation = "Contacts, friction and damping only take energy.",
    .faults = Faults,
    .judge = Judge,
    .universal =
        [](const World& world) { return ClaimAboutAll(kEnergyNeverRises, world); },
};

}  // namespace touchstone
