#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "reports/worlds/law_support/law.h"
#include "reports/worlds/law_support/subjects.h"
#include "reports/worlds/truth/mechanics.h"

namespace touchstone {

/** The energy of a motion at its samples, and how far a scheme of first order may be off.
 */
struct EnergyAlong {
  std::vector<Energy> energies;
  /** Of each sample. [J]

   Semi-implicit Euler keeps H ∓ ½ h dU/dt + O(h²) in place of the energy H (Hairer,
   Lubich, Wanner, Geometric Numerical Integration, 2nd ed., IX.3): E may differ from E(0)
   by ½ h times the power dU/dt then and at the start, in free fall by exactly ½ m g h (v
   − v₀). The largest power so far stands for both, since a bounce changes its sign; h²
   |F|²/m of each thing bounds the next order. Added: what the gyroscopic term and rods
   lose (laws/scheme_drift.h), all × 1.5, and 64 roundings a step. */
  std::vector<double> tolerances;
  /** Σ m |g·v̂| h |v| over the times that a body's fall was turned so far: what rules that
   reflect the velocity after gravity has acted add to the energy. [J] */
  std::vector<double> reflected_gravity;
  /** What that sum is known to: a sample's speed differs from that of the bounce by up to
   g times the time between samples, before it and after it. [J] */
  std::vector<double> reflected_slack;

  /** Returns whether the energy that rose by `rise` [J] from sample `from` to sample `to`
   rose by what such a rule adds: by nothing where no fall was turned between them. */
  bool ReflectsAfterGravity(double rise, std::size_t from, std::size_t to) const;
};

/** How a motion is recognised that ReflectsAfterGravity() throughout. */
inline constexpr std::string_view kReflectsAfterGravity =
    "reflects the velocity after gravity";

/** Returns the energy of the subjects along `motion`. */
EnergyAlong EnergyAlongOf(const Motion& motion, const Subjects& subjects);

/** The argument of the tolerances. */
std::string BecauseOfEnergy();

}  // namespace touchstone
