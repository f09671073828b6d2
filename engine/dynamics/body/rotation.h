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

/** Returns the change of ω [rad/s] by the gyroscopic torque −ω × (I ω) over a time `h`
 [s], as `rule` computes it; for kExact, the explicit estimate. */
Eigen::Vector3d GyroscopicChange(const Eigen::Matrix3d& R_WB,
                                 const Eigen::Vector3d& moments,
                                 const Eigen::Vector3d& w_WB, double h, Gyroscopic rule);

}  // namespace cookbook
