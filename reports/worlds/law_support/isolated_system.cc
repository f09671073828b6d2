#include "reports/worlds/law_support/isolated_system.h"

#include <string>
#include <string_view>

#include <fmt/format.h>

#include "reports/worlds/law_support/numbers.h"
#include "reports/worlds/law_support/subjects.h"

namespace touchstone {
namespace {

/** Returns a fault for each spring and joint with exactly one end that `counts`. */
template <typename Counts>
std::vector<Fault> FaultsOfSplitLinks(const World& world, const Counts& counts,
                                      std::string_view expected) {
  std::vector<Fault> faults;
  const auto add = [&](const auto& links, std::string_view kind) {
    for (std::size_t i = 0; i < links.size(); ++i) {
      if (counts(links[i].A) == counts(links[i].B)) continue;
      faults.push_back({"about", fmt::format("leaves out one end of {}[{}]", kind, i),
                        std::string(expected)});
    }
  };
  add(world.springs, "springs");
  add(world.joints, "joints");
  return faults;
}

}  // namespace

std::vector<Fault> FaultsOfIsolation(const World& world, const Claim& claim) {
  std::vector<Fault> faults =
      FaultsOfSubjects(world, claim, {.bodies = true, .particles = true, .cloths = true});
  if (!faults.empty()) return faults;
  const Subjects subjects = SubjectsOf(world, claim);
  faults = FaultsOfSplitLinks(
      world, [&](const Anchor& anchor) { return Has(subjects, anchor); },
      "both ends or none: what is outside acts on what is inside");
  for (const int i : subjects.particles) {
    const Particle& particle = world.particles[static_cast<std::size_t>(i)];
    if (particle.damping == 0) continue;
    faults.push_back(
        FaultAbout(claim, particle.name, "is damped", "a particle without damping"));
  }
  for (const int i : subjects.cloths) {
    const Cloth& cloth = world.cloths[static_cast<std::size_t>(i)];
    if (cloth.damping == 0 && cloth.pinned.empty()) continue;
    faults.push_back(FaultAbout(claim, cloth.name,
                                cloth.damping == 0 ? "is pinned" : "is damped",
                                "a cloth without damping, pinned nowhere"));
  }
  return faults;
}

std::vector<Fault> FaultsOfEnergy(const World& world, const Claim& claim) {
  const Subjects subjects = SubjectsOf(world, claim);
  std::vector<Fault> faults = FaultsOfSplitLinks(
      world,
      [&](const Anchor& anchor) {
        return Moves(world, anchor) && !Has(subjects, anchor);
      },
      "both ends that move, or none");
  for (const int i : subjects.bodies) {
    if (!IsPushed(world, i)) continue;
    faults.push_back(FaultAbout(claim, world.bodies[static_cast<std::size_t>(i)].name,
                                "is pushed", "a body without pushes"));
  }
  return faults;
}

Eigen::Matrix3d ProjectionOf(const Claim& claim) {
  const Eigen::Vector3d direction{NumberOr(claim, "x", 0), NumberOr(claim, "y", 0),
                                  NumberOr(claim, "z", 0)};
  if (direction.isZero(0)) return Eigen::Matrix3d::Identity();
  return direction.normalized() * direction.normalized().transpose();
}

}  // namespace touchstone
