#pragma once

#include <functional>
#include <vector>

#include "oracles/trajectory.h"
#include "reports/worlds/law_support/allowed_motion.h"
#include "reports/worlds/law_support/law.h"
#include "reports/worlds/law_support/subjects.h"

namespace touchstone {

// The drift that schemes cause in quantities that the true motion conserves, from the
// start to each sample: rates to leading order at the states of the allowed motion. So
// they need no truth and also hold for chaotic motion. Where a body may tumble between
// two samples, the rate is the largest of a free rotation with its energy.

/** Returns the drift of the angular momentum of free bodies by the gyroscopic term.
 [N m s]

 With L = R I Rᵀ ω and ω̇ = −I⁻¹ (ω × L), one step I (ω' − ω) = −h ω × L followed by the
 rotation by h ω' leaves L' − L = h² (ω̇ × L − ½ ω × (ω × L)) + O(h³). The implicit steps I
 (ω' − ω) = −h ω' × I ω' and I ω' = L − h ω' × L leave ±½ h² ω × (ω × L). The larger of
 the two magnitudes is taken and summed over the bodies. An engine with a
 documented_rotation_error is granted that fraction of L per step instead. */
std::vector<double> GyroscopicMomentumDrift(const Motion& motion,
                                            const AllowedMotion& allowed,
                                            const Subjects& subjects);

/** Returns the drift of their energy: the same schemes change it by ±½ h² (ω × L)·I⁻¹(ω ×
 L) per step, exactly so for the explicit one. An engine with a documented_rotation_error
 is granted that fraction per step. [J] */
std::vector<double> GyroscopicEnergyDrift(const Motion& motion,
                                          const AllowedMotion& allowed,
                                          const Subjects& subjects);

/** Returns the drift of angular momentum by distance joints among the subjects. A step
 along the tangent lengthens the rod by ½ v² h²/L, where v is the velocity across it.
 Pulling the ends together moves a momentum m v by that distance, with m = 1/(1/m_A +
 1/m_B). [N m s] */
std::vector<double> RodMomentumDrift(const Motion& motion, const AllowedMotion& allowed,
                                     const Subjects& subjects);

/** Returns the drift of energy by distance joints at the subjects: rotating the velocity
 from one tangent to the next loses ½ m (v · v h/L)² per step. [J] */
std::vector<double> RodEnergyDrift(const Motion& motion, const AllowedMotion& allowed,
                                   const Subjects& subjects);

/** Returns the drift of energy by impacts of turning bodies. A rule of restitution takes
 the velocity of the contact point before the step or after its forces; in between the
 point is accelerated by a = I⁻¹ (ω × L) × r + ω × (ω × r), and the impulse J gives up to
 ½ J h |a| more or less. With |r| at most the bounding radius, and J the change of
 momentum beyond the loads. The contact point of a sphere does not turn with it. [J] */
std::vector<double> ImpactEnergyDrift(const Motion& motion, const AllowedMotion& allowed,
                                      const Subjects& subjects);

/** Returns ∫ rate dt from the start to each sample of the allowed motion, with the larger
 of the rates at the two ends of an interval. [unit of the rate × s] */
std::vector<double> IntegralAlong(const AllowedMotion& allowed,
                                  const std::function<double(const WorldState&)>& rate);

}  // namespace touchstone
