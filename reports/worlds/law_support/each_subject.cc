#include "reports/worlds/law_support/each_subject.h"

#include <utility>

#include <fmt/format.h>

#include "reports/worlds/law_support/numbers.h"
#include "reports/worlds/law_support/subjects.h"

namespace touchstone {
namespace {

/** Returns the faults of the subjects that are `things[i]` for each of `indices`. */
template <typename Things>
std::vector<Fault> FaultsOfEach(const Things& things, const std::vector<int>& indices,
                                const World& world, const Claim& claim,
                                const Conditions& conditions) {
  std::vector<Fault> faults;
  for (const int i : indices) {
    const std::string why = conditions.why_not(world, i);
    if (why.empty()) {
      faults =
          Joined(std::move(faults), FaultsOfNumbers(claim, conditions.numbers(world, i)));
      continue;
    }
    faults.push_back(FaultAbout(claim, things[static_cast<std::size_t>(i)].name, why,
                                conditions.expected));
  }
  return faults;
}

}  // namespace

std::vector<Fault> FaultsOfEachBody(const World& world, const Claim& claim,
                                    const Conditions& conditions) {
  std::vector<Fault> faults = FaultsOfSubjects(world, claim, {.bodies = true});
  if (!faults.empty()) return faults;
  return FaultsOfEach(world.bodies, SubjectsOf(world, claim).bodies, world, claim,
                      conditions);
}

std::vector<Fault> FaultsOfEachParticle(const World& world, const Claim& claim,
                                        const Conditions& conditions) {
  std::vector<Fault> faults = FaultsOfSubjects(world, claim, {.particles = true});
  if (!faults.empty()) return faults;
  return FaultsOfEach(world.particles, SubjectsOf(world, claim).particles, world, claim,
                      conditions);
}

std::vector<Fault> FaultsOfOneBody(const World& world, const Claim& claim,
                                   std::string_view one, const Conditions& conditions) {
  std::vector<Fault> faults = FaultsOfSubjects(world, claim, {.bodies = true});
  if (!faults.empty()) return faults;
  const std::size_t bodies = SubjectsOf(world, claim).bodies.size();
  if (bodies > 1)
    return {{"about", fmt::format("are {} bodies", bodies), std::string(one)}};
  return FaultsOfEachBody(world, claim, conditions);
}

}  // namespace touchstone
