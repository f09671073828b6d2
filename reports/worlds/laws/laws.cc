#include "reports/worlds/laws/laws.h"

#include <algorithm>
#include <array>

#include "reports/worlds/laws/every_law.h"

namespace touchstone {

std::span<const Law> Laws() {
  static const std::array laws = {
      kAngularMomentumBalance,
      kBallistic,
      kBounceSeries,
      kConservesAngularMomentum,
      kConservesEnergy,
      kConservesMomentum,
      kContactsOnBodies,
      kCornerImpact,
      kCoulombCone,
      kEnergyNeverRises,
      kHangsAsCatenary,
      kIncline,
      kJointLength,
      kMinimumEnergy,
      kMomentumBalance,
      kMovesAtItsVelocity,
      kNeverPassesThrough,
      kNeverPenetrates,
      kPendulum,
      kPenetrationScore,
      kPushed,
      kRests,
      kRollingBox,
      kRolls,
      kRowImpact,
      kSlideToStop,
      kSlipToRoll,
      kSphereImpact,
      kSpinsOnPlane,
      kSpringOscillation,
      kStackSupport,
      kTorqueFree,
  };
  return laws;
}

const Law* FindLaw(std::string_view name) {
  const std::span<const Law> laws = Laws();
  const auto found = std::find_if(laws.begin(), laws.end(), [&](const Law& law) {
    return law.name == name || std::ranges::find(law.aliases, name) != law.aliases.end();
  });
  return found == laws.end() ? nullptr : &*found;
}

}  // namespace touchstone
