#include "reports/worlds/laws/laws.h"

#include <algorithm>
#include <array>

#include "reports/worlds/laws/angular_momentum_balance.h"
#include "reports/worlds/laws/ballistic.h"
#include "reports/worlds/laws/bounce_series.h"
#include "reports/worlds/laws/conserves_angular_momentum.h"
#include "reports/worlds/laws/conserves_energy.h"
#include "reports/worlds/laws/conserves_momentum.h"
#include "reports/worlds/laws/contacts_on_bodies.h"
#include "reports/worlds/laws/corner_impact.h"
#include "reports/worlds/laws/coulomb_cone.h"
#include "reports/worlds/laws/double_pendulum.h"
#include "reports/worlds/laws/energy_never_rises.h"
#include "reports/worlds/laws/hangs_as_catenary.h"
#include "reports/worlds/laws/incline.h"
#include "reports/worlds/laws/joint_length.h"
#include "reports/worlds/laws/minimum_energy.h"
#include "reports/worlds/laws/momentum_balance.h"
#include "reports/worlds/laws/moves_at_its_velocity.h"
#include "reports/worlds/laws/never_passes_through.h"
#include "reports/worlds/laws/never_penetrates.h"
#include "reports/worlds/laws/oblique_impact.h"
#include "reports/worlds/laws/particle_bounce.h"
#include "reports/worlds/laws/particle_flight.h"
#include "reports/worlds/laws/pendulum.h"
#include "reports/worlds/laws/penetration_score.h"
#include "reports/worlds/laws/pushed.h"
#include "reports/worlds/laws/rests.h"
#include "reports/worlds/laws/rolling_box.h"
#include "reports/worlds/laws/rolls.h"
#include "reports/worlds/laws/row_impact.h"
#include "reports/worlds/laws/slide_to_stop.h"
#include "reports/worlds/laws/slip_to_roll.h"
#include "reports/worlds/laws/sphere_impact.h"
#include "reports/worlds/laws/spins_on_plane.h"
#include "reports/worlds/laws/spring_oscillation.h"
#include "reports/worlds/laws/stack_support.h"
#include "reports/worlds/laws/torque_free.h"

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
      kDoublePendulum,
      kEnergyNeverRises,
      kHangsAsCatenary,
      kIncline,
      kJointLength,
      kMinimumEnergy,
      kMomentumBalance,
      kMovesAtItsVelocity,
      kNeverPassesThrough,
      kNeverPenetrates,
      kObliqueImpact,
      kParticleBounce,
      kParticleFlight,
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
  const auto found = std::find_if(laws.begin(), laws.end(),
                                  [&](const Law& law) { return law.name == name; });
  return found == laws.end() ? nullptr : &*found;
}

}  // namespace touchstone
