#pragma once

#include <functional>
#include <vector>

#include "oracles/trajectory.h"
#include "reports/worlds/law_support/subjects.h"
#include "scenarios/worlds/world.h"

namespace touchstone {

// What schemes of first order do to quantities that the true motion keeps: rates to
// leading order, divided by the step h, at a state of the motion itself. So they need no
// truth, and hold where the motion is chaotic.

/** Returns how fast the angular momentum of free bodies drifts, over h. [N m]

 With L = R I Rᵀ ω and ω̇ = −I⁻¹ (ω × L), one step I (ω' − ω) = −h ω × L followed by the
 turn by h ω' leaves L' − L = h² (ω̇ × L − ½ ω × (ω × L)) + O(h³); the implicit steps I (ω'
 − ω) = −h ω' × I ω' and I ω' = L − h ω' × L leave ±½ h² ω × (ω × L). The larger of the
 two sizes is taken, summed over the bodies. */
double GyroscopicMomentumRate(const World& world, const WorldState& state,
                              const Subjects& subjects);

/** Returns how fast the energy of free bodies drifts, over h: the same schemes change it
 by ±½ h² (ω × L)·I⁻¹(ω × L) a step. [W/s] */
double GyroscopicPowerRate(const World& world, const WorldState& state,
                           const Subjects& subjects);

/** Returns how fast distance joints among the subjects change angular momentum, over h:
 a step along the tangent leaves the rod longer by ½ v² h²/L, v being the velocity across
 it; pulling the ends together moves a momentum m v by that much, m = 1/(1/m_A + 1/m_B).
 [N m/s] */
double JointMomentumRate(const World& world, const WorldState& state,
                         const Subjects& subjects);

/** Returns how fast distance joints at the subjects change the energy, over h: turning
 the velocity from one tangent to the next loses ½ m (v · v h/L)² a step. [W/s] */
double JointPowerRate(const World& world, const WorldState& state,
                      const Subjects& subjects);

/** Returns ∫ rate dt from the start to each sample, with the larger of the rates at both
 ends of an interval. */
std::vector<double> IntegralAlong(const Trajectory& trajectory,
                                  const std::function<double(const WorldState&)>& rate);

}  // namespace touchstone
