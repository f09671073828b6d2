#pragma once

#include <span>
#include <vector>

#include "engine/dynamics/joints/axial_constraint.h"
#include "engine/dynamics/joints/spring.h"

namespace cookbook {

/** Returns the force of the spring on A if the anchors are at rest, k (ℓ − L) along the
 line from A's anchor to B's. The force on B is the opposite. [N] */
Eigen::Vector3d ForceOnA(const Spring& spring, std::span<const RigidBody> bodies);

/** The constraint solver of the springs, to be iterated together with the distance joints
 and the contacts. It keeps energy at any stiffness; the textbook's explicit force is
 unstable for stiff springs, and its implicit force damps.

 Let d be the vector from anchor A to anchor B, of length ℓ₀ before a step of h and ℓ₁
 after it. The force during the step is

   F = (k ((ℓ₀ + ℓ₁)/2 − L) + b (ℓ₁ − ℓ₀)/h) (d₀ + d₁)/(ℓ₀ + ℓ₁).

 Since (d₀ + d₁)·(d₁ − d₀) = (ℓ₀ + ℓ₁)(ℓ₁ − ℓ₀), the spring takes up the energy
 k/2 ((ℓ₁ − L)² − (ℓ₀ − L)²) and the damper b (ℓ₁ − ℓ₀)²/h. Energy, momentum and angular
 momentum are hence right to rounding at any stiffness (Gonzalez, J. Nonlinear Sci. 6,
 1996). F depends on the poses at the end of the step, so it is solved in rounds like
 JointSolver. */
class SpringSolver {
 public:
  /** Sets up a constraint for each spring, linearized about bodies that keep the
   velocities `before`. */
  void Begin(std::span<const Spring> springs, std::span<const RigidBody> bodies,
             std::span<const InverseInertia> inertias, std::span<const Velocity> before,
             double h);

  /** Solves each constraint once. Returns the greatest change of a relative velocity,
   like ContactSolver::Iterate(). [m/s] */
  double Iterate(std::span<Velocity> velocities);

  /** Returns the greatest change of a relative velocity by the impulse of a spring alone.
   [m/s] */
  double MaxVelocityChange() const;

  /** Relinearizes the constraints, like JointSolver::Relinearize(). Returns whether all
   impulses were right. The error of an impulse must move the anchors by less than the
   rounding of their distance. It must also change their relative velocity by less than
   `solved` [m/s], beyond that rounding. */
  bool Relinearize(std::span<const Spring> springs, std::span<const RigidBody> after,
                   std::span<const double> moved_fraction, std::span<Velocity> velocities,
                   double h, double solved);

 private:
  struct Constraint {
    AxialConstraint axis;       ///< n = (d₀ + d₁)/(ℓ₀ + ℓ₁); mean lever arms.
    Eigen::Vector3d d_start;    ///< From anchor A to B before the step. [m]
    Eigen::Vector3d r_A_start;  ///< Lever arms before the step. [m]
    Eigen::Vector3d r_B_start;
    double length_start;            ///< ℓ₀. [m]
    double inverse_effective_mass;  ///< [1/kg]
    /** The linearized impulse on B along n, for a relative velocity u along n:
     target_impulse − impulse_per_speed (u − expected_speed). */
    double target_impulse;     ///< [N s]
    double impulse_per_speed;  ///< [kg]
    double expected_speed;     ///< [m/s]
    double impulse;            ///< Accumulated. [N s]
  };

  /** Sets `target_impulse` and `impulse_per_speed`, for anchors at the distance `length`
   [m] at the end of the step. `fraction`: see JointSolver::Relinearize(). */
  static void Linearize(const Spring& spring, double length, double fraction, double h,
                        Constraint& constraint);

  std::vector<Constraint> constraints_;
  std::span<const InverseInertia> inertias_;
};

}  // namespace cookbook
