#include "reports/worlds/law_support/each_body.h"

#include <utility>
#include <variant>

#include <fmt/format.h>

#include "reports/worlds/law_support/numbers.h"
#include "reports/worlds/law_support/subjects.h"

namespace touchstone {

std::vector<Fault> FaultsOfEachBody(const World& world, const Claim& claim,
                                    std::string (*why_not)(const World&, int),
                                    std::string_view expected,
                                    ExpectedNumbers (*numbers)(const World&, int)) {
  std::vector<Fault> faults = FaultsOfSubjects(world, claim, {.bodies = true});
  if (!faults.empty()) return faults;
  for (const int i : SubjectsOf(world, claim).bodies) {
    const std::string why = why_not(world, i);
    if (why.empty()) {
      faults = Joined(std::move(faults), FaultsOfNumbers(claim, numbers(world, i)));
      continue;
    }
    const std::string& name = world.bodies[static_cast<std::size_t>(i)].name;
    faults.push_back({WhereAbout(claim, name), fmt::format("is {}, which {}", name, why),
                      std::string(expected)});
  }
  return faults;
}

std::vector<Fault> FaultsOfOneBody(const World& world, const Claim& claim,
                                   std::string_view one,
                                   std::string (*why_not)(const World&, int),
                                   std::string_view expected,
                                   ExpectedNumbers (*numbers)(const World&, int)) {
  std::vector<Fault> faults = FaultsOfSubjects(world, claim, {.bodies = true});
  if (!faults.empty()) return faults;
  const std::size_t bodies = SubjectsOf(world, claim).bodies.size();
  if (bodies > 1)
    return {{"about", fmt::format("are {} bodies", bodies), std::string(one)}};
  return FaultsOfEachBody(world, claim, why_not, expected, numbers);
}

bool IsEvenSphere(const RigidBody& body) {
  const Eigen::Vector3d inertia = InertiaOf(body);
  return std::holds_alternative<Sphere>(body.placed.shape) &&
         inertia == Eigen::Vector3d::Constant(inertia.x());
}

}  // namespace touchstone
