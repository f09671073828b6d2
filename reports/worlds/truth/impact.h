#pragma once

#include <Eigen/Core>

#include "reports/worlds/truth/sliding.h"

namespace touchstone {

/** One of the two bodies of an impact, at the time of the impact. World frame. */
struct Striker {
  double inverse_mass = 0;  ///< 0: static. [1/kg]
  Eigen::Matrix3d inverse_inertia_W =
      Eigen::Matrix3d::Zero();                     ///< About the centre. [1/(kg m²)]
  Eigen::Vector3d p_WB = Eigen::Vector3d::Zero();  ///< [m]
  Eigen::Vector3d v_WB = Eigen::Vector3d::Zero();  ///< [m/s]
  Eigen::Vector3d w_WB = Eigen::Vector3d::Zero();  ///< [rad/s]

  /** Returns the velocity of the body's point at `p_W`. [m/s] */
  Eigen::Vector3d VelocityAt(const Eigen::Vector3d& p_W) const;

  /** Applies the impulse `J_W` [N s] at `p_W`. */
  void Strike(const Eigen::Vector3d& J_W, const Eigen::Vector3d& p_W);
};

/** Returns K of u' = u + K J for the impulse J on a body at `p_W`: 1/m − [r]× I⁻¹ [r]×.
 [1/kg] */
Eigen::Matrix3d ImpulseResponse(const Striker& body, const Eigen::Vector3d& p_W);

/** Returns the impulse by Newton's restitution and Coulomb's friction if the normal and
 all tangents are axes of the response K, as for spheres. J_n = (1+e) |u_n|/K_nn. J_t =
 −u_t/K_tt, which ends the slip, or as much of it as the cone allows (Walton & Braun, J.
 Rheol. 30 (1986) 949, without tangential restitution). There Newton's, Poisson's and
 Stronge's restitution agree. Zero if the bodies separate. [N s]

 `u_W` is the velocity of B relative to A at the contact; `n_W` points from A into B. */
Eigen::Vector3d CentralImpulse(const Eigen::Matrix3d& K, const Eigen::Vector3d& u_W,
                               const Eigen::Vector3d& n_W, double restitution,
                               double friction, const PlacedCone& cone);

/** A velocity or an impulse in the plane of motion: components along the normal and the
 tangent. */
using InPlane = Eigen::Vector2d;

/** The outcome of an impact in a plane in which K_nt couples normal and tangent. */
enum class ImpactRule {
  /** u_n' = −e u_n, and friction by the remaining slip: solvers that treat an impact as
   one equation do that. */
  kNewton,
  /** The impulse of restitution is e times that of compression, and friction acts
   throughout: Routh, Dynamics of a System of Rigid Bodies, part I, §§184–196. */
  kPoisson,
};

/** Returns the impulse on a contact with the velocity `u` = (u_n, u_t), u_n < 0, in a
 plane with response `K` (symmetric, positive). [N s] */
InPlane PlanarImpulse(ImpactRule rule, const Eigen::Matrix2d& K, const InPlane& u,
                      double restitution, double friction);

}  // namespace touchstone
