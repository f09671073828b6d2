#include "scenarios/worlds/validate_world.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "scenarios/validate_scenario.h"
#include "scenarios/worlds/magnitudes.h"

namespace touchstone {
namespace {

void Append(std::string_view prefix, const std::vector<Fault>& from,
            std::vector<Fault>& to) {
  for (const Fault& fault : from) {
    to.push_back({fmt::format("{}{}", prefix, fault.where), fault.what, fault.expected});
  }
}

/** Collects the faults of a world. */
class WorldCheck {
 public:
  WorldCheck(const World& world, std::vector<Fault>& faults)
      : world_(world), faults_(faults) {}

  void operator()() {
    const std::vector<Fault> clock = FaultsOfClock(world_);
    Append("world.", clock, faults_);
    Named("bodies", world_.bodies);
    Named("particles", world_.particles);
    Named("cloths", world_.cloths);
    Tied("springs", world_.springs);
    Tied("joints", world_.joints);
    for (std::size_t i = 0; i < world_.pushes.size(); ++i) {
      Add(fmt::format("pushes[{}]", i), world_.pushes[i], clock.empty());
    }
    Append("", FaultsOfMagnitudes(world_), faults_);
    if (!Moves(world_)) {
      faults_.push_back({"world", "has nothing that moves",
                         "a body, a particle or a cloth that can move"});
    }
  }

 private:
  template <class Part>
  void Named(std::string_view key, const std::vector<Part>& parts) {
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const std::string& name = parts[i].name;
      std::string path = fmt::format("{}.{}", key, name);
      if (!IsBodyName(name)) {
        path = fmt::format("{}[{}]", key, i);
        faults_.push_back({path, fmt::format("is named \"{}\"", name),
                           "a name of A-Z, a-z, 0-9, _ and -"});
      } else if (const auto [first, is_new] = path_of_.emplace(name, path); !is_new) {
        faults_.push_back(
            {path, fmt::format("has the name of {}", first->second), "a unique name"});
      }
      Append(path + '.', FaultsOf(parts[i]), faults_);
    }
  }

  template <class Part>
  void Tied(std::string_view key, const std::vector<Part>& parts) {
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const std::string path = fmt::format("{}[{}].", key, i);
      Append(path, FaultsOf(parts[i]), faults_);
      const bool has_A = Exists(path + 'A', parts[i].A);
      const bool has_B = Exists(path + 'B', parts[i].B);
      if (has_A && has_B)
        Append(path, FaultsOfEnds(world_, parts[i].A, parts[i].B), faults_);
    }
  }

  /** Returns whether the body or particle of `anchor` exists; adds a fault if not. */
  bool Exists(const std::string& where, const Anchor& anchor) {
    const bool exists = anchor.on == AnchorKind::kWorld ? anchor.index == -1
                        : anchor.on == AnchorKind::kBody
                            ? IsIndex(anchor.index, world_.bodies.size())
                            : IsIndex(anchor.index, world_.particles.size());
    if (!exists) {
      faults_.push_back({where, fmt::format("has index {}", anchor.index),
                         anchor.on == AnchorKind::kWorld ? "-1 for the world"
                         : anchor.on == AnchorKind::kBody
                             ? "an index into the bodies"
                             : "an index into the particles"});
    }
    return exists;
  }

  static bool IsIndex(int index, std::size_t size) {
    return index >= 0 && static_cast<std::size_t>(index) < size;
  }

  void Add(const std::string& path, const Push& push, bool clock_is_good) {
    Append(path + '.', FaultsOf(push), faults_);
    if (!IsIndex(push.body, world_.bodies.size())) {
      faults_.push_back(
          {path + ".body", fmt::format("is {}", push.body), "an index into the bodies"});
    } else if (clock_is_good) {
      Append(path + '.', FaultsIn(world_, push), faults_);
    }
  }

  const World& world_;
  std::vector<Fault>& faults_;
  std::map<std::string, std::string> path_of_;  ///< Path of the first part with a name.
};

bool HasName(const World& world, const std::string& name) {
  const auto is_it = [&name](const auto& part) { return part.name == name; };
  return std::any_of(world.bodies.begin(), world.bodies.end(), is_it) ||
         std::any_of(world.particles.begin(), world.particles.end(), is_it) ||
         std::any_of(world.cloths.begin(), world.cloths.end(), is_it);
}

}  // namespace

bool Moves(const World& world) {
  const auto moves = [](const auto& part) { return part.mass != 0; };
  return std::any_of(world.bodies.begin(), world.bodies.end(), moves) ||
         std::any_of(world.particles.begin(), world.particles.end(), moves) ||
         !world.cloths.empty();
}

std::vector<Fault> FaultsOf(const World& world) {
  std::vector<Fault> faults;
  WorldCheck(world, faults)();
  return faults;
}

std::vector<Fault> FaultsOf(const WorldScenario& scenario) {
  std::vector<Fault> faults =
      FaultsOfHeading(scenario.id, scenario.title, scenario.source);
  if (scenario.horizon) Append("", FaultsOfHorizon(*scenario.horizon), faults);
  Append("", FaultsOf(scenario.world), faults);
  for (std::size_t i = 0; i < scenario.claims.size(); ++i) {
    const Claim& claim = scenario.claims[i];
    const std::string path = fmt::format("claims[{}].", i);
    Append(path, FaultsOf(claim), faults);
    for (std::size_t j = 0; j < claim.about.size(); ++j) {
      if (HasName(scenario.world, claim.about[j])) continue;
      faults.push_back(
          {fmt::format("{}about[{}]", path, j),
           fmt::format("is \"{}\", which the world does not have", claim.about[j]),
           "the name of a body, a particle or a cloth"});
    }
  }
  const bool clock_is_good = FaultsOfClock(scenario.world).empty();
  for (std::size_t i = 0; i < scenario.expectations.size(); ++i) {
    const MotionExpectation& expectation = scenario.expectations[i];
    const std::string path = fmt::format("expect[{}].", i);
    Append(path, FaultsOf(expectation), faults);
    if (clock_is_good) Append(path, FaultsIn(scenario.world, expectation), faults);
  }
  if (scenario.ensemble) Append("ensemble.", FaultsOf(*scenario.ensemble), faults);
  Append("", FaultsOf(scenario.indicts), faults);
  return faults;
}

}  // namespace touchstone
