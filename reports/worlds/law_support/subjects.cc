#include "reports/worlds/law_support/subjects.h"

#include <algorithm>

#include <fmt/format.h>

namespace touchstone {
namespace {

template <typename Things>
int IndexOf(const Things& things, const std::string& name) {
  for (std::size_t i = 0; i < things.size(); ++i) {
    if (things[i].name == name) return static_cast<int>(i);
  }
  return -1;
}

bool IsFixedTo(const Anchor& anchor, AnchorKind on, int index) {
  return anchor.on == on && anchor.index == index;
}

}  // namespace

Subjects SubjectsOf(const World& world, const Claim& claim) {
  Subjects subjects;
  const auto add = [&](int body, int particle, int cloth) {
    if (body >= 0 && world.bodies[static_cast<std::size_t>(body)].mass > 0)
      subjects.bodies.push_back(body);
    if (particle >= 0 && world.particles[static_cast<std::size_t>(particle)].mass > 0)
      subjects.particles.push_back(particle);
    if (cloth >= 0) subjects.cloths.push_back(cloth);
  };
  if (claim.about.empty()) {
    for (std::size_t i = 0; i < world.bodies.size(); ++i)
      add(static_cast<int>(i), -1, -1);
    for (std::size_t i = 0; i < world.particles.size(); ++i)
      add(-1, static_cast<int>(i), -1);
    for (std::size_t i = 0; i < world.cloths.size(); ++i)
      add(-1, -1, static_cast<int>(i));
  }
  for (const std::string& name : claim.about) {
    add(IndexOf(world.bodies, name), IndexOf(world.particles, name),
        IndexOf(world.cloths, name));
  }
  return subjects;
}

std::vector<Fault> FaultsOfSubjects(const World& world, const Claim& claim,
                                    const SpeaksOf& speaks) {
  std::vector<std::string> kinds;
  if (speaks.bodies) kinds.emplace_back("body");
  if (speaks.particles) kinds.emplace_back("particle");
  if (speaks.cloths) kinds.emplace_back("cloth");
  const std::string expected =
      fmt::format("the name of a {} that moves", fmt::join(kinds, ", "));

  std::vector<Fault> faults;
  for (const std::string& name : claim.about) {
    const int body = IndexOf(world.bodies, name);
    const int particle = IndexOf(world.particles, name);
    const int cloth = IndexOf(world.cloths, name);
    const std::string where = WhereAbout(claim, name);
    if (body < 0 && particle < 0 && cloth < 0) {
      faults.push_back(
          {where, fmt::format("is {}, which is no name in this world", name), expected});
    } else if ((body >= 0 && world.bodies[static_cast<std::size_t>(body)].mass == 0) ||
               (particle >= 0 &&
                world.particles[static_cast<std::size_t>(particle)].mass == 0)) {
      faults.push_back({where, fmt::format("is {}, which never moves", name), expected});
    } else if ((body >= 0 && !speaks.bodies) || (particle >= 0 && !speaks.particles) ||
               (cloth >= 0 && !speaks.cloths)) {
      faults.push_back({where,
                        fmt::format("is {}, to which {} does not apply", name, claim.law),
                        expected});
    }
  }
  if (!faults.empty()) return faults;

  const Subjects subjects = SubjectsOf(world, claim);
  const bool none =
      subjects.bodies.empty() && subjects.particles.empty() && subjects.cloths.empty();
  const bool unspoken = (!subjects.bodies.empty() && !speaks.bodies) ||
                        (!subjects.particles.empty() && !speaks.particles) ||
                        (!subjects.cloths.empty() && !speaks.cloths);
  if (none || unspoken) {
    faults.push_back({"about",
                      none ? "is empty, and nothing moves in this world"
                           : "is everything that moves, including things of another kind",
                      expected});
  }
  return faults;
}

std::string WhereAbout(const Claim& claim, const std::string& name) {
  const auto found = std::find(claim.about.begin(), claim.about.end(), name);
  return found == claim.about.end()
             ? "about"
             : fmt::format("about[{}]", found - claim.about.begin());
}

Fault FaultAbout(const Claim& claim, const std::string& name, std::string_view why,
                 std::string_view expected) {
  return {WhereAbout(claim, name), fmt::format("is {}, which {}", name, why),
          std::string(expected)};
}

bool Moves(const World& world, const Anchor& anchor) {
  const auto i = static_cast<std::size_t>(anchor.index);
  return (anchor.on == AnchorKind::kBody && world.bodies[i].mass > 0) ||
         (anchor.on == AnchorKind::kParticle && world.particles[i].mass > 0);
}

bool IsHeld(const World& world, AnchorKind on, int index) {
  const auto holds = [&](const auto& link) {
    return IsFixedTo(link.A, on, index) || IsFixedTo(link.B, on, index);
  };
  return std::any_of(world.springs.begin(), world.springs.end(), holds) ||
         std::any_of(world.joints.begin(), world.joints.end(), holds);
}

bool IsPushed(const World& world, int index) {
  return std::any_of(world.pushes.begin(), world.pushes.end(),
                     [&](const Push& push) { return push.body == index; });
}

}  // namespace touchstone
