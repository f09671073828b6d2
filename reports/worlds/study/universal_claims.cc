#include "reports/worlds/study/universal_claims.h"

#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "reports/worlds/law_support/isolated_system.h"
#include "reports/worlds/laws/laws.h"

namespace touchstone {
namespace {

/** Returns whether a motion that obeys the law `claimed` obeys `universal` too. */
bool Implies(std::string_view claimed, std::string_view universal) {
  return claimed == universal ||
         (claimed == "conserves_energy" && universal == "energy_never_rises");
}

/** Returns what is left of `universal` beside the claims of a file; empty: nothing. */
std::optional<Claim> BesideClaimed(Claim universal, const std::vector<Claim>& claimed) {
  const bool of_each = !universal.about.empty();
  for (const Claim& claim : claimed) {
    if (!Implies(claim.law, universal.law)) continue;
    if (claim.about.empty() && ProjectionOf(claim).isIdentity(0)) return std::nullopt;
    if (!of_each) continue;
    for (const std::string& name : claim.about) {
      std::erase(universal.about, name);
      universal.claimed.push_back(name);
    }
  }
  if (of_each && universal.about.empty()) return std::nullopt;
  return universal;
}

}  // namespace

std::vector<Claim> UniversalClaims(const WorldScenario& scenario) {
  std::vector<Claim> claims;
  for (const Law& law : Laws()) {
    if (!law.universal) continue;
    std::optional<Claim> claim = law.universal(scenario.world);
    if (claim) claim = BesideClaimed(std::move(*claim), scenario.claims);
    if (claim) claims.push_back(std::move(*claim));
  }
  return claims;
}

}  // namespace touchstone
