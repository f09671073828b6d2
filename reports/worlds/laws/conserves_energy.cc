#include "reports/worlds/laws/conserves_energy.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

#include "reports/text/told_apart.h"
#include "reports/worlds/law_support/energy_bound.h"
#include "reports/worlds/law_support/numbers.h"
#include "reports/worlds/law_support/subjects.h"
#include "reports/worlds/law_support/worst.h"

namespace touchstone {
namespace {

/** Whether `anchor` is on something that moves and is not a subject. */
bool IsForeign(const World& world, const Subjects& subjects, const Anchor& anchor) {
  const auto missing = [&](const std::vector<int>& indices) {
    return std::find(indices.begin(), indices.end(), anchor.index) == indices.end();
  };
  const auto index = static_cast<std::size_t>(anchor.index);
  return (anchor.on == AnchorKind::kBody && world.bodies[index].mass > 0 &&
          missing(subjects.bodies)) ||
         (anchor.on == AnchorKind::kParticle && world.particles[index].mass > 0 &&
          missing(subjects.particles));
}

template <typename Links>
void AddForeign(const World& world, const Subjects& subjects, const Links& links,
                std::string_view kind, std::vector<Fault>& faults) {
  for (std::size_t i = 0; i < links.size(); ++i) {
    const bool A = IsForeign(world, subjects, links[i].A);
    const bool B = IsForeign(world, subjects, links[i].B);
    if (A == B) continue;
    faults.push_back({"about", fmt::format("leaves out one end of {}[{}]", kind, i),
                      "both ends that move, or none"});
  }
}

std::vector<Fault> Faults(const World& world, const Claim& claim) {
  std::vector<Fault> faults = FaultsOfEnergy(world, claim, false);
  if (!faults.empty()) return faults;
  const Energy energy = EnergyOf(world, StateAtStart(world), SubjectsOf(world, claim));
  return FaultsOfNumbers(claim, {{"expected_energy", energy.total()}});
}

std::vector<LawFinding> Judge(const Motion& motion, const Claim& claim) {
  const World& world = motion.world;
  const Subjects subjects = SubjectsOf(world, claim);
  const double E_0 = EnergyOf(world, StateAtStart(world), subjects).total();
  const EnergyAlong along = EnergyAlongOf(motion, subjects);
  Worst worst(MeasureKind::kEnergyDrift, BecauseOfEnergy());
  bool reflects = true;
  for (std::size_t s = 0; s < along.energies.size(); ++s) {
    const double E = along.energies[s].total();
    worst.Take(std::abs(E - E_0), along.tolerances[s], [&] {
      const ToldApart told = TellApart(E, E_0, 9);
      return fmt::format("{} has {} J after {:.6g} s; it started with {} J",
                         motion.oracle.name, told.a, motion.trajectory.times[s], told.b);
    });
    reflects = reflects && along.ReflectsAfterGravity(E - E_0, 0, s);
  }
  return FindingsOf({worst}, reflects ? kReflectsAfterGravity : "");
}

constexpr std::array<std::string_view, 1> kNumbers = {"expected_energy"};

}  // namespace

std::vector<Fault> FaultsOfEnergy(const World& world, const Claim& claim, bool damped) {
  std::vector<Fault> faults =
      FaultsOfSubjects(world, claim, {.bodies = true, .particles = true, .cloths = true});
  if (!faults.empty()) return faults;
  const Subjects subjects = SubjectsOf(world, claim);
  AddForeign(world, subjects, world.springs, "springs", faults);
  AddForeign(world, subjects, world.joints, "joints", faults);
  for (const int i : subjects.bodies) {
    if (!IsPushed(world, i)) continue;
    const std::string& name = world.bodies[static_cast<std::size_t>(i)].name;
    faults.push_back({WhereAbout(claim, name),
                      fmt::format("is {}, which is pushed", name),
                      "a body without pushes"});
  }
  if (damped) return faults;
  bool any = std::any_of(world.springs.begin(), world.springs.end(),
                         [](const Spring& spring) { return spring.damping > 0; });
  for (const int i : subjects.particles)
    any = any || world.particles[static_cast<std::size_t>(i)].damping > 0;
  for (const int i : subjects.cloths) {
    const Cloth& cloth = world.cloths[static_cast<std::size_t>(i)];
    any = any || cloth.damping > 0 || cloth.structural.damping > 0 ||
          cloth.shear.damping > 0 || cloth.bend.damping > 0;
  }
  if (any) {
    faults.push_back({"about", "is damped, or held by a damped spring",
                      "no damping (energy_never_rises covers damped motion)"});
  }
  return faults;
}

constinit const Law kConservesEnergy = {
    .name = "conserves_energy",
    .documentation =
        "The sum of the energies of motion, gravity, "
        "constant forces and springs is constant.",
    .numbers = kNumbers,
    .faults = Faults,
    .judge = Judge,
};

}  // namespace touchstone
