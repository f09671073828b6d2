#include "reports/worlds/law_support/isolated_system.h"

#include <algorithm>

#include <fmt/format.h>

#include "reports/worlds/law_support/subjects.h"

namespace touchstone {
namespace {

bool Has(const Subjects& subjects, const Anchor& anchor) {
  const auto among = [&](const std::vector<int>& indices) {
    return std::find(indices.begin(), indices.end(), anchor.index) != indices.end();
  };
  return (anchor.on == AnchorKind::kBody && among(subjects.bodies)) ||
         (anchor.on == AnchorKind::kParticle && among(subjects.particles));
}

}  // namespace

std::vector<Fault> FaultsOfIsolation(const World& world, const Claim& claim) {
  std::vector<Fault> faults = FaultsOfSubjects(world, claim, {.bodies = true, .particles = true, .cloths = true});
  if (!faults.empty()) return faults;
  const Subjects subjects = SubjectsOf(world, claim);
  const auto reaches_out = [&](const auto& links, std::string_view kind) {
    for (std::size_t i = 0; i < links.size(); ++i) {
      if (Has(subjects, links[i].A) == Has(subjects, links[i].B)) continue;
      faults.push_back({"about", fmt::format("leaves out one end of {}[{}]", kind, i),
                        "both ends or none: what is outside acts on what is inside"});
    }
  };
  reaches_out(world.springs, "springs");
  reaches_out(world.joints, "joints");
  for (const int i : subjects.particles) {
    const Particle& particle = world.particles[static_cast<std::size_t>(i)];
    if (particle.damping == 0) continue;
    faults.push_back({WhereAbout(claim, particle.name),
                      fmt::format("is {}, which is damped", particle.name),
                      "a particle without damping"});
  }
  for (const int i : subjects.cloths) {
    const Cloth& cloth = world.cloths[static_cast<std::size_t>(i)];
    if (cloth.damping == 0 && cloth.pinned.empty()) continue;
    faults.push_back({WhereAbout(claim, cloth.name),
                      fmt::format("is {}, which is {}", cloth.name,
                                  cloth.damping == 0 ? "pinned" : "damped"),
                      "a cloth without damping, pinned nowhere"});
  }
  return faults;
}

}  // namespace touchstone
