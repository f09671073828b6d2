#pragma once

#include <array>
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
  double dt = 0;  ///< The step h. [s]
  std::vector<Energy> energies;
  double at_start = 0;  ///< Total energy of the start that the world specifies. [J]
  /** The error between any two samples that does not accumulate, indexed by the later.
   [J]

   Semi-implicit Euler conserves H ∓ ½ h dU/dt + O(h²) instead of the energy H (Hairer,
   Lubich, Wanner, Geometric Numerical Integration, 2nd ed., IX.3). So E may differ from
   an earlier E by ½ h times the power dU/dt at both times; in free fall by exactly ½ m g
   h (v − v₀). The largest power so far stands for both, since a bounce changes its sign;
   h² |F|²/m of each body bounds the next order. Both × 1.5, and 64 roundings per step; at
   rest, the energy of velocities that are roundings of positions (NoiseOfPositions()).
   Moving apart what overlaps at the start does work (WorkOfParting()). */
  std::vector<double> oscillations;
  /** The same without the term ½ h dU/dt. [J] */
  std::vector<double> second_orders;
  /** The losses of the gyroscopic term and of rods from the start to each sample
   (law_support/scheme_drift.h), × 1.5. [J] */
  std::vector<double> drifts;
  /** The most kinetic energy that the truth allows so far: the upper bound on the drift,
   because rates of leading order do not hold for larger errors. [J] */
  std::vector<double> most_kinetic;
  /** Σ m |g·v̂| h |v| over the reversals of a body's fall so far: the energy added by
   rules that reflect the velocity after gravity has acted. [J] */
  std::vector<double> reflected_gravity;
  /** Uncertainty of that sum: the speed at a sample differs from that of the bounce by up
   to g times the time between samples, before and after it. [J] */
  std::vector<double> reflected_slack;

  /** Returns by how much the energies at samples `from` and `to` may differ. All speeds
   in it are those that the truth allows (law_support/allowed_motion.h). [J] */
  double Tolerance(std::size_t from, std::size_t to) const;

  /** Returns the total energy at sample `s` as a reference for later samples; at the
   first sample that of the start. [J] */
  double Earlier(std::size_t s) const { return s == 0 ? at_start : energies[s].total(); }

  /** Returns, for each sample, the two earlier samples that show its worst change of
   energy in the direction `sign` (1: a rise, −1: a fall): the extreme of the energy, and
   the extreme of the energy less the granted drift. */
  std::vector<std::array<std::size_t, 2>> WorstEarlier(double sign) const;

  /** Returns whether a rise of the energy by `rise` [J] from sample `from` to sample `to`
   is what such a rule adds. Never if no fall was reversed between them, or if what the
   rule adds is not known to a tenth. */
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
