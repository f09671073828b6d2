#pragma once

#include <span>
#include <vector>

#include "engine/dynamics/joints/axial_constraint.h"
#include "engine/dynamics/joints/distance_joint.h"

namespace cookbook {

/** The constraint solver of the distance joints, to be iterated together with the
 contacts. It keeps energy, which the constraint d·ḋ = 0 of the textbook does not.

 Let d be the vector from anchor A to anchor B, d₀ before and d₁ after a step. The impulse
 λ of the step acts along the mean d̄ = (d₀ + d₁)/2, and |d₁| = |d₀|.
 Bodies move by the mean of their velocities, so the rod does the work
 λ d̄·(d₁ − d₀) = λ (|d₁|² − |d₀|²)/2 = 0: a pendulum keeps its energy to rounding
 (Gonzalez, Physica D 132, 1999, the discrete gradient of |d|²/2). The equation is not
 linear in λ, so it is solved in rounds: iterate over the constraints, predict the poses
 at the end of the step, relinearize. */
class JointSolver {
 public:
  /** Sets up a constraint for each joint, along the current direction of the rod. */
  void Begin(std::span<const DistanceJoint> joints, std::span<const RigidBody> bodies,
             std::span<const InverseInertia> inertias);

  /** Returns the greatest rate at which `velocities` change the length of a rod. [m/s] */
  double MaxStretchSpeed(std::span<const Velocity> velocities) const;

  /** Sets the impulses that WarmStart() applies to zero. */
  void ResetImpulses() { impulses_.assign(impulses_.size(), 0); }

  /** The impulses of the rods along their mean directions, on B. [N s] */
  std::span<double> impulses() { return impulses_; }

  /** Applies the impulses of the previous step, scaled to a step of `h` [s]. */
  void WarmStart(std::span<Velocity> velocities, double h);

  /** Solves each constraint once. Returns the greatest change of a relative velocity,
   like ContactSolver::Iterate(). [m/s] */
  double Iterate(std::span<Velocity> velocities);

  /** Returns the greatest change of a relative velocity by the accumulated impulse of a
   rod alone. [m/s] */
  double MaxVelocityChange() const;

  /** Returns the greatest error of a rod between bodies that end the step at `after`:
   that of its length, or the distance along which its impulse does work, relative to the
   length and the places of its anchors. */
  double MaxError(std::span<const DistanceJoint> joints,
                  std::span<const RigidBody> after) const;

  /** Relinearizes the constraints about `after`, the poses that the bodies would have at
   the end of the step. `moved_fraction`, indexed by body, is the fraction of a change of
   velocity with which the body moves during the step: 1/2 if it moves by the mean of its
   velocities, 1 if it moves by the last one. Returns the greatest relative error of a
   length. */
  double Relinearize(std::span<const DistanceJoint> joints,
                     std::span<const RigidBody> after,
                     std::span<const double> moved_fraction,
                     std::span<Velocity> velocities, double h);

  /** Position correction: adds to `corrections` [m], [rad] the pseudo-velocities that
   remove `fraction` of the error of each rod whose length is off by more than the
   rounding of its anchors' places. Returns whether there was such a rod. */
  bool CorrectPositions(std::span<const DistanceJoint> joints, double fraction,
                        std::span<const RigidBody> bodies,
                        std::span<Velocity> corrections);

 private:
  struct Constraint {
    AxialConstraint axis;       ///< n is the unit vector along d̄; mean lever arms.
    Eigen::Vector3d d_start;    ///< From anchor A to B before the step. [m]
    Eigen::Vector3d r_A_start;  ///< Lever arms before the step. [m]
    Eigen::Vector3d r_B_start;
    double length;          ///< Length after the step. [m]
    double effective_mass;  ///< [kg]; 0 if neither body can move.
    double target;          ///< Relative velocity along n to be reached. [m/s]
  };

  /** Sets the axis of `constraint` to the direction of `d_mean`. */
  void SetDirection(const Eigen::Vector3d& d_mean, const Eigen::Vector3d& r_A,
                    const Eigen::Vector3d& r_B, Constraint& constraint) const;

  std::vector<Constraint> constraints_;
  std::vector<double> impulses_;  ///< Along n on B, indexed by joint. [N s]
  double h_ = 0;                  ///< Time step of `impulses_`; 0: no step yet. [s]
  std::span<const InverseInertia> inertias_;
};

}  // namespace cookbook
