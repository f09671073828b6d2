#pragma once

#include <Eigen/Geometry>

#include "engine/dynamics/body/settings.h"

namespace cookbook {

/** Whether a body of these moments, or their inverses, is as easy to turn about any axis,
 as a ball and a cube are. */
bool IsRound(const Eigen::Vector3d& moments);

/** The square of an angle below which Exp() is a series. [rad²] */
inline constexpr double kSmallTurnSquared = 0.01;

/** Returns the rotation by |phi| about phi: the exponential map. */
Eigen::Quaterniond Exp(const Eigen::Vector3d& phi);

/** Returns R diag(moments) Rᵀ u. */
Eigen::Vector3d TurnedInertiaTimes(const Eigen::Matrix3d& R_WB,
                                   const Eigen::Vector3d& moments,
                                   const Eigen::Vector3d& u_W);

/** How a body turns: its orientation and how fast. */
struct Turning {
  Eigen::Quaterniond q_WB;
  Eigen::Vector3d w_WB;  ///< [rad/s]
};

/** Returns the orientation after `h` of a body that is `q_WB` and whose spin goes from
 `from_W` to `to_W` [rad/s] at a constant rate, to fourth order in h. */
Eigen::Quaterniond Turned(const Eigen::Quaterniond& q_WB, const Eigen::Vector3d& from_W,
                          const Eigen::Vector3d& to_W, double h);

/** Returns the state after `h` of a free body whose angular momentum goes from L_W at a
 constant rate to L_W + dL_W. The momentum at the end is that to rounding; the
 orientation is of fourth order in h, and exact about a fixed axis at constant ω. The
 energy differs from the work by 1e-6 of it at most: where the step is too long for that
 it is taken in parts, up to 256.
 @pre `moments` > 0, [kg m²]; L_W = R I Rᵀ ω. */
Turning TurnWithMomentum(const Turning& start, const Eigen::Vector3d& moments,
                         const Eigen::Vector3d& L_W, const Eigen::Vector3d& dL_W,
                         double h);

/** Returns the change of ω [rad/s] that ω × (I ω) makes in `h`, by `rule`; for kExact,
 the explicit estimate. */
Eigen::Vector3d GyroscopicChange(const Eigen::Matrix3d& R_WB,
                                 const Eigen::Vector3d& moments,
                                 const Eigen::Vector3d& w_WB, double h, Gyroscopic rule);

}  // namespace cookbook
