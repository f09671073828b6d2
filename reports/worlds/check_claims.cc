#include "reports/worlds/check_claims.h"

#include <string_view>

#include <fmt/format.h>

#include "reports/worlds/law.h"
#include "reports/worlds/run_worlds.h"
#include "scenarios/schema/nearest_name.h"

namespace touchstone {

std::vector<std::string> FaultsOfClaims(const WorldScenario& scenario) {
  std::vector<std::string> faults;
  for (std::size_t i = 0; i < scenario.claims.size(); ++i) {
    const Claim& claim = scenario.claims[i];
    if (claim.law == kDeterministic) continue;
    const std::string where = fmt::format("{}: claims[{}]", scenario.id, i);
    const Law* law = FindLaw(claim.law);
    if (!law) {
      std::vector<std::string_view> names = {kDeterministic};
      for (const Law& known : Laws()) names.push_back(known.name);
      const std::string_view nearest = NearestName(claim.law, names);
      faults.push_back(fmt::format(
          "{}: no law is called '{}'{}", where, claim.law,
          nearest.empty() ? "." : fmt::format("; did you mean {}?", nearest)));
      continue;
    }
    for (const Fault& fault : law->faults(scenario.world, claim))
      faults.push_back(fmt::format("{} ({}): {} {}; expected {}.", where, claim.law,
                                   fault.where, fault.what, fault.expected));
  }
  return faults;
}

}  // namespace touchstone
