#pragma once

#include <span>
#include <vector>

#include "engine/dynamics/joints/anchor.h"

namespace cookbook {

/** A spring with a damper, without mass: loads its ends together with the force
 k (ℓ − L) + b dℓ/dt, where ℓ is the distance of its anchors. */
struct Spring {
  Anchor A;
  Anchor B;
  double stiffness = 0;    ///< k. [N/m], >= 0
  double damping = 0;      ///< b. [N s/m], >= 0
  double rest_length = 0;  ///< L. [m], >= 0
};

/** Returns k (ℓ − L) along the line of the anchors: the force with which the spring loads
 A at rest, and B the other way. [N] */
Eigen::Vector3d LoadOnA(const Spring& spring, std::span<const RigidBody> bodies);

/** Solves the springs of a world together with its rods and contacts.

 With d from anchor A to B, of length ℓ₀ before a step of h and ℓ₁ after it, a spring
 loads during the step by

   F = (k ((ℓ₀ + ℓ₁)/2 − L) + b (ℓ₁ − ℓ₀)/h) (d₀ + d₁)/(ℓ₀ + ℓ₁).

 Since (d₀ + d₁)·(d₁ − d₀) = (ℓ₀ + ℓ₁)(ℓ₁ − ℓ₀), what it takes is k/2 ((ℓ₁ − L)² − (ℓ₀ −
 L)²) and b (ℓ₁ − ℓ₀)²/h: to rounding, energy and both momenta are what they should be, at
 any stiffness (Gonzalez, J. Nonlinear Sci. 6, 1996). F depends on where the bodies will
 be, so it is solved in rounds as the rods are. */
class SpringSolver {
 public:
  /** Sets up one row for each spring, and the impulses for bodies that go on as `before`
   says. */
  void Begin(std::span<const Spring> springs, std::span<const RigidBody> bodies,
             std::span<const InverseInertia> inertias, std::span<const Velocity> before,
             double h);

  /** As ContactSolver::Iterate(). */
  double Iterate(std::span<Velocity> velocities);

  /** The greatest change of a relative velocity that a spring makes. [m/s] */
  double GreatestLoad() const;

  /** As JointSolver::Correct(); returns whether all impulses were right: off by less than
   moves the anchors by the rounding of their distance, and than changes their relative
   velocity by `solved` [m/s], beyond that rounding. */
  bool Correct(std::span<const Spring> springs, std::span<const RigidBody> after,
               std::span<const double> share, std::span<Velocity> velocities, double h,
               double solved);

 private:
  struct Row {
    Line line;                ///< n = (d₀ + d₁)/(ℓ₀ + ℓ₁); mean lever arms.
    Eigen::Vector3d d_start;  ///< From anchor A to B before the step. [m]
    Eigen::Vector3d r_A_start;
    Eigen::Vector3d r_B_start;
    double length_start;  ///< ℓ₀. [m]
    double response;      ///< [1/kg]
    /** The impulse on B along n is to be `wanted` − give (parting − expected). */
    double wanted;    ///< [N s]
    double give;      ///< [kg]
    double expected;  ///< [m/s]
    double impulse;   ///< [N s]
  };

  /** Sets `wanted` and `give`, for anchors that will be `length` [m] apart. */
  static void Want(const Spring& spring, double length, double share, double h, Row& row);

  std::vector<Row> rows_;
  std::span<const InverseInertia> inertias_;
};

}  // namespace cookbook
