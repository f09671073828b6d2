#include <algorithm>
#include <string>
#include <utility>

#include "reports/text/told_apart.h"
#include "reports/worlds/law_support/allowed_motion.h"
#include "reports/worlds/law_support/citing.h"
#include "reports/worlds/law_support/energy_bound.h"
#include "reports/worlds/law_support/impact_gain.h"
#include "reports/worlds/law_support/isolated_system.h"
#include "reports/worlds/law_support/numbers.h"
#include "reports/worlds/law_support/subjects.h"
#include "reports/worlds/law_support/universal.h"
#include "reports/worlds/law_support/worst.h"
#include "reports/worlds/laws/every_law.h"

namespace touchstone {
namespace {

std::vector<Fault> Faults(const World& world, const Claim& claim) {
  std::vector<Fault> faults =
      FaultsOfSubjects(world, claim, {.bodies = true, .particles = true, .cloths = true});
  if (!faults.empty()) return faults;
  faults = FaultsOfEnergy(world, claim);
  if (!faults.empty()) return faults;
  return Joined(std::move(faults), FaultsOfNumbers(claim, {}));
}

std::vector<LawFinding> JudgeAlong(const Motion& motion, const EnergyAlong& along,
                                   std::string because) {
  Worst worst(MeasureKind::kEnergyDrift, std::move(because));
  const auto earlier = along.WorstEarlier(1);
  bool reflects = true;
  for (std::size_t s = 0; s < along.energies.size(); ++s) {
    const double E = along.energies[s].total();
    for (const std::size_t from : earlier[s]) {
      const double before = along.Earlier(from);
      const double tolerance = along.Tolerance(from, s);
      worst.Take(std::max(0.0, E - before), tolerance, [&] {
        const ToldApart told = TellApart(E, before, 9);
        return Citing("{} has {} J after {:.6g} s; it had {} J after {:.6g} s",
                      motion.oracle.name, told.a, CitedTime{motion.trajectory.times[s]},
                      told.b, motion.trajectory.times[from]);
      });
      reflects = reflects && (E - before <= tolerance ||
                              along.ReflectsAfterGravity(E - before, from, s));
    }
  }
  return FindingsOf({worst}, reflects ? kReflectsAfterGravity : "");
}

std::vector<LawFinding> Judge(const Motion& motion, const Claim& claim) {
  const Subjects subjects = SubjectsOf(motion.world, claim);
  EnergyAlong along = EnergyAlongOf(motion, subjects);
  std::vector<LawFinding> findings = JudgeAlong(motion, along, BecauseOfEnergy());
  const LawFinding& rise = findings.front();
  if (!IsBeyond(rise) || !rise.recognised.empty()) return findings;
  // The gain of impacts is computed only where it decides, because it takes a referee.
  const std::vector<double> gains =
      ImpactEnergyGain(motion, AllowedMotion(motion), subjects);
  if (gains.back() == 0) return findings;
  for (std::size_t s = 0; s < gains.size(); ++s) along.drifts[s] += gains[s];
  return JudgeAlong(
      motion, along,
      BecauseOfEnergy() +
          "; e² (1 + σ²) − 1 of the energy of approach in eccentric impacts that gain by "
          "Newton's rule with friction");
}

}  // namespace

/** Without pushes, the energy of a system never rises above any earlier value. [J]

 Contacts, friction and damping only take energy. The tolerance is that of
 conserves_energy (law_support/energy_bound.h), above the least energy so far:
 semi-implicit Euler lets the energy oscillate by that. Newton's restitution with Coulomb
 friction may gain energy in an eccentric impact, so pairs with enough restitution are
 granted the most that it can gain (law_support/impact_gain.h), and no others.

 About: bodies, particles and cloths. */
constinit const Law kEnergyNeverRises = {
    .name = "energy_never_rises",
    .documentation = "Contacts, friction and damping only take energy.",
    .faults = Faults,
    .judge = Judge,
    .universal =
        [](const World& world) { return ClaimAboutAll(kEnergyNeverRises, world); },
    .of_steps = true,
};

}  // namespace touchstone
