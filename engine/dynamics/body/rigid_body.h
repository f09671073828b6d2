#pragma once

#include <algorithm>
#include <array>

#include "engine/dynamics/body/body.h"

namespace cookbook {

/** A rigid body of a world. Its members are grouped by use into whole cache lines, so
 that a loop over all bodies reads only the lines that it needs. */
struct alignas(64) RigidBody {
  // Pose and velocity: two cache lines.
  BodyState state;
  double radius;  ///< Radius of the bounding sphere about the centre of mass. [m]
  bool collides;
  bool is_sphere;     ///< Rotation does not move its surface.
  bool is_isotropic;  ///< Moments are equal, as those of a sphere or a cube.
  bool is_point;      ///< Has no volume and does not rotate.
  bool has_forces;    ///< Whether any of the forces below may be nonzero.
  // Contact properties: one cache line.
  double inverse_mass;            ///< 0: static. [1/kg]
  double speculative_margin = 0;  ///< See Settings. Set by ExternalLoads. [m]
  double restitution;
  double friction;
  // Thresholds of rest. ExternalLoads computes them in each step.
  double load_acceleration = 0;         ///< External force per mass. [m/s²]
  double island_load_acceleration = 0;  ///< Mean by mass over the island. [m/s²]
  double slop = 0;                      ///< Depth that position correction leaves. [m]
  double drag;                          ///< See BodyDefinition.
  // Orientation and shape: two cache lines.
  Eigen::Matrix3d R_WB;             ///< The rotation matrix of state.q_WB.
  Eigen::Vector3d inverse_moments;  ///< Zero if static or a point.
  BodyShape shape;
  // Rarely used.
  Eigen::Vector3d moments;  ///< Principal moments of inertia; zero if static or a point.
  Eigen::Vector3d force_W;  ///< Constant, on the centre of mass. [N]
  Eigen::Vector3d applied_force_W = Eigen::Vector3d::Zero();   ///< For one step. [N]
  Eigen::Vector3d applied_torque_W = Eigen::Vector3d::Zero();  ///< For one step. [N m]

  bool is_static() const { return inverse_mass == 0; }
  /** Whether the body is dynamic with equal moments of inertia. */
  bool moves_isotropically() const { return is_isotropic && !is_static(); }
  Pose pose() const { return {R_WB, state.p_WB}; }
  /** Returns the sum of all forces except gravity. [N] */
  Eigen::Vector3d Force_W() const {
    return has_forces ? Eigen::Vector3d(force_W + applied_force_W)
                      : Eigen::Vector3d::Zero();
  }
  /** Returns the applied torque. [N m] */
  Eigen::Vector3d Torque_W() const {
    return has_forces ? applied_torque_W : Eigen::Vector3d::Zero();
  }
};

/** Returns the body that `definition` describes.
 @throws std::invalid_argument if it is invalid, see Validate(). */
RigidBody MakeRigidBody(const BodyDefinition& definition);

// Thresholds of rest between two bodies, at least one of which is dynamic.

/** Returns the greatest separation of the speculative contacts between A and B. [m] */
inline double SpeculativeMarginBetween(const RigidBody& A, const RigidBody& B) {
  return A.is_static()   ? B.speculative_margin
         : B.is_static() ? A.speculative_margin
                         : std::min(A.speculative_margin, B.speculative_margin);
}

/** Returns the smaller radius of the dynamic ones of A and B. [m] */
inline double SmallerRadius(const RigidBody& A, const RigidBody& B) {
  return A.is_static()   ? B.radius
         : B.is_static() ? A.radius
                         : std::min(A.radius, B.radius);
}

/** Returns the depth that position correction leaves between A and B. [m] */
inline double SlopBetween(const RigidBody& A, const RigidBody& B) {
  return A.is_static() ? B.slop : B.is_static() ? A.slop : std::min(A.slop, B.slop);
}

/** Returns the greater load of the two bodies themselves. [m/s²] */
inline double LoadAccelerationBetween(const RigidBody& A, const RigidBody& B) {
  return A.is_static()   ? B.load_acceleration
         : B.is_static() ? A.load_acceleration
                         : std::max(A.load_acceleration, B.load_acceleration);
}

/** Returns the greater load of their two islands. [m/s²] */
inline double IslandLoadAccelerationBetween(const RigidBody& A, const RigidBody& B) {
  return A.is_static() ? B.island_load_acceleration
         : B.is_static()
             ? A.island_load_acceleration
             : std::max(A.island_load_acceleration, B.island_load_acceleration);
}

/** Returns the radius of the largest inscribed sphere. [m] */
double InnerRadius(const RigidBody& body);

/** Returns the smaller such radius of the dynamic ones of A and B. [m] */
double SmallerInnerRadius(const RigidBody& A, const RigidBody& B);

/** Returns the greatest penetration of two bodies from which collision detection surely
 pushes them out on the right side. [m] */
double SafePenetration(const RigidBody& A, const RigidBody& B);

/** Returns an upper bound on the distance of any point of `body` from the volume that the
 body filled at `before`. For a sphere it is the distance between the centres. [m] */
double Travel(const BodyState& before, const RigidBody& body);

/** The velocity of a body while a step is solved: six doubles in a row, padded to a cache
 line. */
struct alignas(64) Velocity {
  Eigen::Vector3d v = Eigen::Vector3d::Zero();  ///< Velocity of the centre of mass. [m/s]
  Eigen::Vector3d w = Eigen::Vector3d::Zero();  ///< [rad/s]

  /** Returns the velocity of the point at `r` from the centre of mass. [m/s] */
  Eigen::Vector3d At(const Eigen::Vector3d& r) const { return v + w.cross(r); }
};

/** The inverse mass and inertia tensor of a body, in one cache line. */
struct alignas(64) InverseInertia {
  /** xx, xy, xz, yy, yz, zz of I⁻¹ = R diag(1/moments) Rᵀ. [1/(kg m²)] */
  std::array<double, 6> tensor_W{};
  double mass = 0;    ///< 1/m. [1/kg]
  double unused = 0;  ///< Padding: `mass` is loaded with a vector of four.

  /** Returns I⁻¹ u. */
  Eigen::Vector3d Times(const Eigen::Vector3d& u_W) const {
    const auto& [xx, xy, xz, yy, yz, zz] = tensor_W;
    return {xx * u_W[0] + xy * u_W[1] + xz * u_W[2],
            xy * u_W[0] + yy * u_W[1] + yz * u_W[2],
            xz * u_W[0] + yz * u_W[1] + zz * u_W[2]};
  }
};

/** Returns the inverse inertia of `body` in its current orientation. */
InverseInertia InverseInertiaOf(const RigidBody& body);

}  // namespace cookbook
