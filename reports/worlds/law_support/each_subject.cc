#include "reports/worlds/law_support/each_subject.h"

#include <utility>

#include <fmt/format.h>

#include "reports/worlds/law_support/numbers.h"
#include "reports/worlds/law_support/subjects.h"

namespace touchstone {
namespace {

/** Returns the faults of the claim about one subject. */
template <typename Subject, typename ConditionsOfSubject>
std::vector<Fault> FaultsOfOne(const std::string& name, const Subject& subject,
                               const World& world, const Claim& claim,
                               const ConditionsOfSubject& conditions) {
  const std::string why = conditions.why_not(world, subject);
  if (why.empty()) return FaultsOfNumbers(claim, conditions.numbers(world, subject));
  return {FaultAbout(claim, name, why, conditions.expected)};
}

}  // namespace

std::vector<Fault> FaultsOfEachBody(const World& world, const Claim& claim,
                                    const Conditions& conditions) {
  std::vector<Fault> faults = FaultsOfSubjects(world, claim, {.bodies = true});
  if (!faults.empty()) return faults;
  for (const int i : SubjectsOf(world, claim).bodies) {
    const std::string& name = world.bodies[static_cast<std::size_t>(i)].name;
    faults = Joined(std::move(faults), FaultsOfOne(name, i, world, claim, conditions));
  }
  return faults;
}

std::vector<Fault> FaultsOfEachPoint(const World& world, const Claim& claim,
                                     const ConditionsOfPoint& conditions) {
  std::vector<Fault> faults =
      FaultsOfSubjects(world, claim, {.bodies = true, .particles = true});
  if (!faults.empty()) return faults;
  for (const PointMass& point : PointMassesOf(world, SubjectsOf(world, claim))) {
    faults = Joined(std::move(faults),
                    FaultsOfOne(point.name, point, world, claim, conditions));
  }
  return faults;
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
