#pragma once

#include <span>
#include <vector>

#include "engine/dynamics/solver/contact_constraint.h"

namespace cookbook {

/** Accelerates the iterations of projected Gauss-Seidel to those of a conjugate gradient
 method.

 Gauss-Seidel passes a heavy body's momentum on through a light one by a share of about
 their mass ratio in an iteration: a ball of 50 kg on a plate of 0.5 kg takes thousands.
 The change that an iteration makes is taken for a negative gradient, and the iterates are
 moved on along conjugate directions by the rule of Fletcher and Reeves. If the gradient
 has grown, it starts again from plain iterations. Each iteration projects the impulses
 onto the friction cones, so the fixed points are those of Gauss-Seidel. The end of the
 iterations must be one of these, not a step along a direction.

 Source: M. Silcowitz-Hansen, S. Niebe, K. Erleben, "A nonsmooth nonlinear conjugate
 gradient method for interactive contact force problems", The Visual Computer 26 (2010).
 */
class IterationAcceleration {
 public:
  /** Begins new iterations. */
  void Reset() { iterations_ = 0; }

  /** Moves the impulses and velocities that an iteration has left on along the conjugate
   direction. `velocities` are sums of the impulses, so both move alike. */
  void Extrapolate(const ConstraintView<double>& constraints,
                   std::span<Velocity> velocities);

 private:
  /** Returns the squared norm of the change of the impulses by the last iteration, in the
   energy norm of the separate contacts. [J] */
  double ChangeOfImpulses(const ConstraintView<double>& constraints) const;

  long iterations_ = 0;
  double last_change_ = 0;  ///< ChangeOfImpulses() of the iteration before. [J]
  // Impulses of all lanes, then velocities.
  std::vector<double> now_;        ///< After the last iteration.
  std::vector<double> before_;     ///< Before the last iteration.
  std::vector<double> direction_;  ///< The conjugate direction.
};

}  // namespace cookbook
