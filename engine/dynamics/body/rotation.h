#pragma once

#include <optional>

#include <Eigen/Geometry>

#include "engine/dynamics/body/settings.h"

namespace cookbook {

/** Whether these principal moments of inertia, or their inverses, are equal, as those of
 a sphere or a cube. */
bool IsIsotropic(const Eigen::Vector3d& moments);

/** Squared angle below which Exp() uses a series. [rad²] */
inline constexpr double kSmallAngleSquared = 0.01;

/** Returns the rotation by |phi| about phi: the exponential map. */
Eigen::Quaterniond Exp(const Eigen::Vector3d& phi);

/** Returns R diag(moments) Rᵀ u, the product of the inertia tensor in the world frame and
 u. */
Eigen::Vector3d WorldInertiaTimes(const Eigen::Matrix3d& R_WB,
                                  const Eigen::Vector3d& moments,
                                  const Eigen::Vector3d& u_W);

/** Orientation and angular velocity of a body. */
struct AngularState {
  Eigen::Quaterniond q_WB;
  Eigen::Vector3d w_WB;  ///< [rad/s]
};

/** Integrates the orientation `q_WB` over a time `h` [s] in which the angular velocity
 changes from `from_W` to `to_W` [rad/s] at a constant rate. Fourth order in h. */
Eigen::Quaterniond IntegrateRotation(const Eigen::Quaterniond& q_WB,
                                     const Eigen::Vector3d& from_W,
                                     const Eigen::Vector3d& to_W, double h);

/** A change of the angular momentum of a body in a step. */
struct AngularImpulse {
  Eigen::Vector3d dL_W;  ///< [N m s]
  /** The work that it does. Absent: that of a constant torque, which follows the
   rotation. [J] */
  std::optional<double> work;
};

/** Integrates the rotation of a body over a time `h` [s] in which its angular momentum
 changes from L_W to L_W + dL_W at a constant rate. The final angular momentum and the
 final kinetic energy, which grows by the work, are right to rounding. The orientation is
 of fourth order in h, and exact about a fixed axis at constant ω. If the energy of the
 fourth-order step differs from that by more than 1e-6, the step is divided into
 sub-steps, at most 256.
 @pre `moments` > 0, [kg m²]; L_W = R I Rᵀ ω. */
AngularState IntegrateAngularMomentum(const AngularState& start,
                                      const Eigen::Vector3d& moments,
                                      const Eigen::Vector3d& L_W,
                                      const AngularImpulse& impulse, double h);

/** The result of IntegrateWithLeverArms(). */
struct LeverArmState : AngularState {
  bool is_solved = true;  ///< Whether its equation is solved; if not, energy is not kept.
};

/** Integrates the rotation of a body over a time `h` [s] in which constant forces change
 its angular momentum from L_W to L_W + dL_W. Each force F acts at the mean r̄ = (r₀ +
 r₁)/2 of the lever arms to a point of the body before and after, so that dL = Σ r̄ × F.
 The energy grows by the work Σ F·(r₁ − r₀) to rounding. A constant torque in the sense of
 IntegrateAngularMomentum() does another work, by O((h ω)²) of itself.

 With the angular momentum Π = Rᵀ L in the body frame, the body turns by the Cayley map:

   R₁ = R₀ cay(x),  x = h I⁻¹ (Π₀ + Π₁)/2,  so that R₁ − R₀ = (R₀ + R₁)/2 [x]×

 and hence Π₁ − Π₀ = −x × (R₀ + R₁)ᵀ (L₀ + L₁)/4 + (R₀ + R₁)ᵀ dL/2. Times x, this is the
 work (Austin, Krishnaprasad & Wang, J. Comput. Phys. 107, 1993; Simo & Wong, Int. J.
 Numer. Meth. Eng. 31, 1991). Second order, symmetric in time. The equation has a
 solution, because it maps a ball of x into itself (Brouwer). If Newton's method does not
 find it, the solutions of shorter steps lead to it.
 @pre `moments` > 0, [kg m²]; L_W = R I Rᵀ ω. */
LeverArmState IntegrateWithLeverArms(const AngularState& start,
                                     const Eigen::Vector3d& moments,
                                     const Eigen::Vector3d& L_W,
                                     const Eigen::Vector3d& dL_W, double h);

/** Returns the derivative of the rotation that IntegrateWithLeverArms() returns: the
 angle [rad], in the world frame, by which `end` turns further for a change of dL_W.
 [1/(kg m²/s)] @pre The moments are not equal, and `end` is the result for `start`. */
Eigen::Matrix3d LeverArmResponse(const AngularState& start, const AngularState& end,
                                 const Eigen::Vector3d& moments, double h);

/** Returns the angular velocity [rad/s] of a body that is turned from the orientation
 `R_from` to `R_to` outside of its motion. It keeps the rotational energy, by the one of
 two rules that changes the angular momentum less: the angular velocity turns with the
 body, so that the momentum turns by as much; or the momentum keeps its direction. The
 former is better for a thin bar that spins about its length, the latter for a body that
 is nearly isotropic. @pre `moments` > 0, [kg m²]. */
Eigen::Vector3d SpinAfterCorrection(const Eigen::Matrix3d& R_from,
                                    const Eigen::Matrix3d& R_to,
                                    const Eigen::Vector3d& moments,
                                    const Eigen::Vector3d& w_WB);

/** Returns the change of ω [rad/s] by the gyroscopic torque −ω × (I ω) over a time `h`
 [s], as `rule` computes it; for kExact, the explicit estimate. */
Eigen::Vector3d GyroscopicChange(const Eigen::Matrix3d& R_WB,
                                 const Eigen::Vector3d& moments,
                                 const Eigen::Vector3d& w_WB, double h, Gyroscopic rule);

}  // namespace cookbook
