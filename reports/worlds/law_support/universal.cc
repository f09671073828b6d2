#include "reports/worlds/law_support/universal.h"

#include <algorithm>
#include <string>

namespace touchstone {

std::optional<Claim> ClaimAboutAll(const Law& law, const World& world) {
  Claim claim;
  claim.law = law.name;
  if (!law.faults(world, claim).empty()) return std::nullopt;
  return claim;
}

std::optional<Claim> ClaimAboutEach(const Law& law, const World& world) {
  Claim claim;
  claim.law = law.name;
  const auto add = [&](const auto& things) {
    for (const auto& thing : things) {
      Claim about_it;
      about_it.law = law.name;
      about_it.about = {thing.name};
      if (law.faults(world, about_it).empty()) claim.about.push_back(thing.name);
    }
  };
  add(world.bodies);
  add(world.particles);
  add(world.cloths);
  if (claim.about.empty()) return std::nullopt;
  return claim;
}

bool TouchesNothingFixed(const World& world) {
  const bool has_points = !world.particles.empty() || !world.cloths.empty();
  return std::none_of(world.bodies.begin(), world.bodies.end(),
                      [&](const RigidBody& body) {
                        return body.collides && (body.mass == 0 || has_points);
                      });
}

}  // namespace touchstone
