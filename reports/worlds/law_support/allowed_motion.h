#pragma once

#include <vector>

#include "oracles/trajectory.h"
#include "reports/worlds/law_support/law.h"

namespace touchstone {

/** A motion with velocities that are no faster than the truth allows.

 A tolerance that depends on speeds is taken along this motion, not along the motion that
 is judged: an engine that gains energy must not grant itself a tolerance for it.

 Contacts, friction, rods and damping only take energy. So with H the kinetic energy plus
 that of springs, dH/dt is at most the power Σ (m g + F)·v of the loads. It is
 at most √(2H) A with A² = Σ m |g + F/m|², by the inequality of Cauchy and Schwarz. Hence
 √(2H) grows by at most A t, and by √(J·M⁻¹J) at a push J. Without pushes the kinetic
 energy is also at most E(0) − U, with the potential energy U at the places of the motion
 itself. The smaller bound counts. One more step of the loads and the springs is added,
 since velocities may belong to the places of the next step. The bound is on the sum over
 everything that moves.

 A legal scheme may gain energy, and the gain grows with the energy. No gain above the
 true kinetic energy is granted. So a sample with more than twice the kinetic energy of
 the truth is slowed, as a whole, to twice that energy. */
class AllowedMotion {
 public:
  explicit AllowedMotion(const Motion& motion);

  /** Returns the state of the motion at sample `s`, slowed if it is too fast. */
  const WorldState& At(std::size_t s) const { return states_[s]; }

  /** Returns the states at all samples. */
  const std::vector<WorldState>& states() const { return states_; }

  /** Returns the most kinetic energy that the truth allows at the samples up to `s`,
   without drift. [J] */
  double KineticEnergy(std::size_t s) const { return kinetic_[s]; }

  /** The same at any time up to sample `s`, between the samples too: H, whatever the
   places at the samples. [J] */
  double KineticEnergyBetween(std::size_t s) const { return kinetic_between_[s]; }

  /** Returns the times of the samples. [s] */
  const std::vector<double>& times() const { return *times_; }

 private:
  std::vector<WorldState> states_;
  std::vector<double> kinetic_;
  std::vector<double> kinetic_between_;
  const std::vector<double>* times_;
};

}  // namespace touchstone
