#include "reports/worlds/study/run_claims.h"

#include <algorithm>

namespace touchstone {

const Claim* FindClaim(const WorldScenario& scenario, std::string_view law) {
  const auto claim = std::find_if(scenario.claims.begin(), scenario.claims.end(),
                                  [&](const Claim& c) { return c.law == law; });
  return claim == scenario.claims.end() ? nullptr : &*claim;
}

}  // namespace touchstone
