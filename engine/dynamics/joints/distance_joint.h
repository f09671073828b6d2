#pragma once

#include <span>
#include <vector>

#include "engine/dynamics/joints/anchor.h"

namespace cookbook {

/** A massless rod: keeps two anchors at one distance. */
struct DistanceJoint {
  Anchor A;
  Anchor B;
  double length = 1;  ///< [m], > 0
};

/** Solves the rods of a world together with its contacts.

 With d from anchor A to B, the impulse of a step acts along d̄, the mean of d before and
 after it, and makes |d| after the step the length of the rod. Since the bodies move by
 the mean of their velocities, the rod does the work λ d̄·(d₁ − d₀) = λ (|d₁|² − |d₀|²)/2 =
 0: a pendulum keeps its energy to rounding (Gonzalez, Physica D 132, 1999, the discrete
 gradient of |d|²/2). The equation is not linear in λ, so it is solved in rounds: sweep
 over the rows, look where the bodies would go, correct the rows. */
class JointSolver {
 public:
  /** Sets up one row for each joint, along the rod as it is now. */
  void Begin(std::span<const DistanceJoint> joints, std::span<const RigidBody> bodies,
             std::span<const InverseInertia> inertias);

  /** The greatest speed at which `velocities` change the length of a rod. [m/s] */
  double FastestStretching(std::span<const Velocity> velocities) const;

  /** Forgets the impulses of the step before. */
  void Forget() { impulses_.assign(impulses_.size(), 0); }

  /** Applies the impulses of the step before, as those of one of `h` [s]. */
  void WarmStart(std::span<Velocity> velocities, double h);

  /** As ContactSolver::Iterate(). */
  double Iterate(std::span<Velocity> velocities);

  /** The greatest change of a relative velocity that a rod makes. [m/s] */
  double GreatestLoad() const;

  /** Corrects the rows, given where the bodies would be after the step. `share` says of
   each body how much of a change of its velocity moves it: 1/2 for one that moves by the
   mean of its velocities, 1 for one that moves by the last. Returns the greatest error of
   a length, relative to it. */
  double Correct(std::span<const DistanceJoint> joints, std::span<const RigidBody> after,
                 std::span<const double> share, std::span<Velocity> velocities, double h);

  /** Adds to `moves` [m], [rad] what removes `share` of the error of every rod that is
   off its length by more than rounding. Returns whether there was one. */
  bool Project(std::span<const DistanceJoint> joints, double share,
               std::span<const RigidBody> bodies, std::span<Velocity> moves);

 private:
  struct Row {
    Line line;                ///< n is unit, along d̄; mean lever arms.
    Eigen::Vector3d d_start;  ///< From anchor A to B before the step. [m]
    Eigen::Vector3d r_A_start;
    Eigen::Vector3d r_B_start;
    double length;          ///< To have after the step. [m]
    double effective_mass;  ///< [kg]; 0 where nothing moves.
    double target;          ///< Of the relative velocity along n. [m/s]
  };

  /** Turns the line of `row` along `d_mean`. */
  void Aim(const Eigen::Vector3d& d_mean, const Eigen::Vector3d& r_A,
           const Eigen::Vector3d& r_B, Row& row) const;

  std::vector<Row> rows_;
  std::vector<double> impulses_;  ///< Along n, on B. [N s]
  double h_ = 0;                  ///< The step that they are of; 0: of none. [s]
  std::span<const InverseInertia> inertias_;
};

}  // namespace cookbook
