#pragma once

#include <functional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "engine/dynamics/joints/axial_constraint.h"
#include "engine/dynamics/joints/distance_joint.h"
#include "engine/dynamics/joints/spring.h"

namespace cookbook {

/** Newton's method for the equations of all distance joints and springs of a step, see
 JointSolver and SpringSolver. The linear equations are solved directly.

 The rounds of JointSolver are a fixed-point iteration: they take the direction of a rod
 from the last round. It diverges where h² T / (ℓ m) is more than about 4, with the
 tension T of the rod and the mass m at its end: a light body between a support and a
 heavy one. Newton's method has the derivative of the direction, the *geometric stiffness*
 T/ℓ across the rod, on the left-hand side.

 The unknowns are the velocities v at the end of the step and the impulses μ d̄ of the rods
 and springs, with d̄ = (d₀ + d₁)/2. The equations are

   M (v − v_g) = Σ μ W,  W = (d̄, r̄ × d̄) for B and its opposite for A,
   |d₁|² = |d₀|² for a rod,  μ = 2 s(ℓ₁) for a spring,

 where v_g are the velocities without these impulses and s is the factor of (d₀ + d₁) in
 the impulse of SpringSolver. d₁ depends on v by the integration of the bodies, with the
 derivative of LeverArmResponse(). The step is halved as long as it does not reduce the
 residual. */
class DirectJointSolver {
 public:
  /** The system to be solved. Spans are indexed by body, joint or spring. */
  struct System {
    std::span<const DistanceJoint> joints;
    std::span<const Spring> springs;
    std::span<const RigidBody> bodies;  ///< At the start of the step.
    std::span<const InverseInertia> inertias;
    std::span<const Velocity> given;         ///< Without the impulses of the links.
    std::span<const double> moved_fraction;  ///< See JointSolver::Relinearize().
    /** Whether IntegrateWithLeverArms() turns bodies that links hold at an arm. */
    bool turns_with_lever_arms;
    double h;  ///< Time step. [s]
  };
  /** The place of the solution. In `velocities` and `joint_impulses` the solver finds its
   initial guess. */
  struct Solution {
    std::span<Velocity> velocities;
    std::span<double> joint_impulses;  ///< Along the unit vector of d̄, on B. [N s]
    /** The bodies at the end of the step; valid if linked. */
    std::span<const RigidBody> after;
  };

  /** Solves the system. `integrate` computes `after` from `velocities`. Returns whether
   lengths and impulses are right to rounding; otherwise the solution is of no use. */
  bool Solve(const System& system, const Solution& solution,
             const std::function<void()>& integrate);

 private:
  /** A rod or spring between two bodies, of which at least one moves. Vectors are in the
   world frame, distances from anchor A to anchor B. */
  struct Link {
    int A = 0;
    int B = 0;
    std::size_t index = 0;  ///< Index of the joint or the spring.
    bool is_spring = false;
    double inverse_effective_mass = 0;  ///< At the start of the step. [1/kg]
    double length_start = 0;            ///< |d_start|. [m]
    /** Distance and lever arms at the start of the step. [m] */
    Eigen::Vector3d d_start{0, 0, 0};
    Eigen::Vector3d r_A_start{0, 0, 0};
    Eigen::Vector3d r_B_start{0, 0, 0};
    double mu = 0;  ///< μ. [N s/m]
    /** Distance and lever arms at its end, by the current velocities. [m] */
    Eigen::Vector3d d{0, 0, 0};
    Eigen::Vector3d r_A{0, 0, 0};
    Eigen::Vector3d r_B{0, 0, 0};
    Eigen::Vector3d d_mean{0, 0, 0};  ///< d̄. [m]
    /** The linearized equation of the link: slope·δd + compliance δμ = residual. */
    Eigen::Vector3d slope{0, 0, 0};
    double compliance = 0;
    double residual = 0;
  };
  /** The unknowns of a moving body, from `first` on: three, or six if it rotates. */
  struct LinkedBody {
    int body = 0;
    int first = 0;
    bool rotates = false;
    double mass = 0;  ///< [kg]
    /** World frame, at the start of the step. [kg m²] */
    Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
    /** The angle by which a change of ω turns the body further. [s] */
    Eigen::Matrix3d turn = Eigen::Matrix3d::Zero();
    Eigen::Vector3d dp{0, 0, 0};  ///< Residual of the momentum. [N s]
    Eigen::Vector3d dL{0, 0, 0};  ///< Residual of the angular momentum. [N m s]
    double p_scale = 0;  ///< Sum of the magnitudes of which `dp` is the difference. [N s]
    double L_scale = 0;  ///< The same of `dL`. [N m s]
  };

  void CollectLinks(const System& system, std::span<const double> joint_impulses);
  void CollectBodies(const System& system);
  /** Computes the residuals of all equations. Returns a measure of them: an energy [J].
   */
  double UpdateResiduals(const System& system, const Solution& solution);
  /** Returns the moving body with this index; null if it does not move. */
  LinkedBody* Find(int body);
  /** Solves the linearized equations. Returns false if they are singular. */
  bool FindChange(const System& system, Eigen::VectorXd& change);
  void Add(const Eigen::VectorXd& change, double fraction, const Solution& solution);
  /** Sets the velocities to the given ones and the effect of the impulses. */
  void ApplyImpulses(const System& system, const Solution& solution) const;

  std::vector<Link> links_;
  std::vector<LinkedBody> linked_bodies_;
  std::vector<int> linked_body_of_;  ///< Index in linked_bodies_ or −1, by body.
  int unknowns_ = 0;                 ///< Number of velocities.
  double worst_error_ = 0;  ///< The greatest residual, in multiples of its tolerance.
};

}  // namespace cookbook
