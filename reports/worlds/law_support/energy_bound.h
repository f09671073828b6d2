#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "reports/worlds/law_support/law.h"
#include "reports/worlds/law_support/subjects.h"
#include "reports/worlds/truth/mechanics.h"

namespace touchstone {

/** The energy of a motion at its samples, and the largest error of a first-order
 scheme. */
struct EnergyAlong {
  std::vector<Energy> energies;
  /** Indexed by sample. [J]

   Semi-implicit Euler conserves H ∓ ½ h dU/dt + O(h²) instead of the energy H (Hairer,
   Lubich, Wanner, Geometric Numerical Integration, 2nd ed., IX.3). So E may differ from
   E(0) by ½ h times the power dU/dt at that time and at the start; in free fall by
   exactly ½ m g h (v − v₀). The largest power so far stands for both, since a bounce
   changes its sign; h² |F|²/m of each body bounds the next order. The losses of the
   gyroscopic term and of rods are added (law_support/scheme_drift.h), all × 1.5, and 64
   roundings per step. */
  std::vector<double> tolerances;
  /** Σ m |g·v̂| h |v| over the reversals of a body's fall so far: the energy added by
   rules that reflect the velocity after gravity has acted. [J] */
  std::vector<double> reflected_gravity;
  /** Uncertainty of that sum: the speed at a sample differs from that of the bounce by up
   to g times the time between samples, before and after it. [J] */
  std::vector<double> reflected_slack;

  /** Returns whether a rise of the energy by `rise` [J] from sample `from` to sample `to`
   is what such a rule adds; that is nothing if no fall was reversed between them. */
  bool ReflectsAfterGravity(double rise, std::size_t from, std::size_t to) const;
};

/** The model under which a motion is recognised that ReflectsAfterGravity()
 throughout. */
inline constexpr std::string_view kReflectsAfterGravity =
    "reflects the velocity after gravity";

/** Returns the energy of the subjects along `motion`. */
EnergyAlong EnergyAlongOf(const Motion& motion, const Subjects& subjects);

/** Returns the origin of the tolerances, for reports. */
std::string BecauseOfEnergy();

}  // namespace touchstone
