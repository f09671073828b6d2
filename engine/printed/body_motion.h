#pragma once

#include <Eigen/Core>

#include "engine/printed/errata.h"
#include "engine/printed/world.h"

namespace cookbook::printed {

/** Returns the principal moments of a solid body: sphere 2/5 m r², box m/12 (Y²+Z²,
 X²+Z², X²+Y²) with full sizes. [kg m²] */
Eigen::Vector3d SolidInertia(const Body& body);

/** Returns 1/m; 0 for a static body. [1/kg] */
double InverseMass(const Body& body);

/** Returns the inverse inertia tensor in the world frame, R I⁻¹ Rᵀ; under E-14 it is not
 rotated. Zero for a static body. [1/(kg m²)] */
Eigen::Matrix3d InverseInertia(const Body& body, const Errata& errata);

/** Applies the impulse `J_W` at `p_W`: Δv = J/m, Δω = I⁻¹ (r × J). */
void Give(Body& body, const Eigen::Vector3d& p_W, const Eigen::Vector3d& J_W,
          const Errata& errata);

/** Rotates a body by the small rotation vector `turn_W`. [rad] */
void Turn(Body& body, const Eigen::Vector3d& turn_W, const Errata& errata);

/** Integrates the velocity and the pose of a body over a step. */
void Integrate(Body& body, const Eigen::Vector3d& gravity_W, double dt,
               const Errata& errata);

/** Returns the velocity of the point of the body at `p_W`. [m/s] */
Eigen::Vector3d VelocityAt(const Body& body, const Eigen::Vector3d& p_W);

}  // namespace cookbook::printed
