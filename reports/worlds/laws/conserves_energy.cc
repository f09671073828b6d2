#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "reports/text/told_apart.h"
#include "reports/worlds/law_support/citing.h"
#include "reports/worlds/law_support/energy_bound.h"
#include "reports/worlds/law_support/isolated_system.h"
#include "reports/worlds/law_support/numbers.h"
#include "reports/worlds/law_support/subjects.h"
#include "reports/worlds/law_support/worst.h"
#include "reports/worlds/laws/every_law.h"

namespace touchstone {
namespace {

bool IsDamped(const World& world, const Subjects& subjects) {
  return std::any_of(world.springs.begin(), world.springs.end(),
                     [](const Spring& spring) { return spring.damping > 0; }) ||
         std::any_of(subjects.particles.begin(), subjects.particles.end(),
                     [&](int i) {
                       return world.particles[static_cast<std::size_t>(i)].damping > 0;
                     }) ||
         std::any_of(subjects.cloths.begin(), subjects.cloths.end(), [&](int i) {
           const Cloth& cloth = world.cloths[static_cast<std::size_t>(i)];
           return cloth.damping > 0 || cloth.structural.damping > 0 ||
                  cloth.shear.damping > 0 || cloth.bend.damping > 0;
         });
}

std::vector<Fault> Faults(const World& world, const Claim& claim) {
  std::vector<Fault> faults =
      FaultsOfSubjects(world, claim, {.bodies = true, .particles = true, .cloths = true});
  if (!faults.empty()) return faults;
  faults = FaultsOfEnergy(world, claim);
  const Subjects subjects = SubjectsOf(world, claim);
  if (IsDamped(world, subjects)) {
    faults.push_back({"about", "is damped, or held by a damped spring",
                      "no damping (energy_never_rises covers damped motion)"});
  }
  if (!faults.empty()) return faults;
  const Energy energy = EnergyOf(world, StateAtStart(world), subjects);
  return FaultsOfNumbers(claim, {{"expected_energy", energy.total()}});
}

std::vector<LawFinding> Judge(const Motion& motion, const Claim& claim) {
  const World& world = motion.world;
  const Subjects subjects = SubjectsOf(world, claim);
  const EnergyAlong along = EnergyAlongOf(motion, subjects);
  Worst worst(MeasureKind::kEnergyDrift, BecauseOfEnergy());
  bool reflects = true;
  for (const double sign : {1.0, -1.0}) {
    const auto earlier = along.WorstEarlier(sign);
    // The start is that of the world, whatever the law.
    for (std::size_t s = 1; s < along.energies.size(); ++s) {
      const double E = along.energies[s].total();
      for (const std::size_t from : earlier[s]) {
        const double before = along.Earlier(from);
        const double tolerance = along.Tolerance(from, s);
        worst.Take(std::abs(E - before), tolerance, [&] {
          const ToldApart told = TellApart(E, before, 9);
          return Citing("{} has {} J after {:.6g} s; it had {} J after {:.6g} s",
                        motion.oracle.name, told.a, CitedTime{motion.trajectory.times[s]},
                        told.b, motion.trajectory.times[from]);
        });
        reflects = reflects && (std::abs(E - before) <= tolerance ||
                                along.ReflectsAfterGravity(E - before, from, s));
      }
    }
  }
  return FindingsOf({worst}, reflects ? kReflectsAfterGravity : "");
}

constexpr std::array<std::string_view, 1> kNumbers = {"expected_energy"};

}  // namespace

/** The sum of kinetic energy and the potential energies of gravity, constant forces and
 springs is constant. [J]

 Any two samples are compared. The tolerance is the error law of semi-implicit Euler
 between them, at speeds that the truth allows (law_support/energy_bound.h). A motion that
 gains m g h V at each bounce, to within that tolerance, is recognised: its engine
 reflects the velocity after gravity has acted on it. That is legal, and the error
 vanishes with the step.

 About: bodies, particles and cloths without damping, whose contacts have no friction and
 restitution 1; the author vouches for the contacts. Numbers: expected_energy at the
 start, with gravity's potential zero at the world's origin. */
constinit const Law kConservesEnergy = {
    .name = "conserves_energy",
    .documentation =
        "The sum of the energies of motion, gravity, "
        "constant forces and springs is constant.",
    .numbers = kNumbers,
    .faults = Faults,
    .judge = Judge,
    .of_steps = true,
};

}  // namespace touchstone
