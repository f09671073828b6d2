#pragma once

#include <algorithm>
#include <array>

#include "engine/dynamics/body/body.h"

namespace cookbook {

/** A body as the world keeps it: in whole lines of a cache, so that what looks at all
 bodies reads of each the lines that it asks for. */
struct alignas(64) RigidBody {
  // Where it is and how it moves, in two lines.
  BodyState state;
  double radius;  ///< Of the smallest ball about the origin that holds it. [m]
  bool collides;
  bool is_ball;    ///< What it turns by moves none of its surface.
  bool is_round;   ///< As easy to turn about any axis, as a ball and a cube are.
  bool is_point;   ///< Has no volume, and does not turn.
  bool is_pushed;  ///< Whether any of the forces below may differ from zero.
  // What contacts ask for, in one line.
  double inverse_mass;  ///< 0: static. [1/kg]
  double margin = 0;    ///< Contacts apart by less are kept ready. [m]
  double restitution;
  double friction;
  // How hard it is pulled, and so what counts for rest, see ExternalLoads.
  double load = 0;         ///< What loads at it, by its mass. [m/s²]
  double island_load = 0;  ///< The same of its island. [m/s²]
  double slop = 0;         ///< Depth that is left. [m]
  double drag;             ///< See BodyDefinition.
  // How it is turned and what it is, in two lines.
  Eigen::Matrix3d R_WB;             ///< That of state.q_WB.
  Eigen::Vector3d inverse_moments;  ///< Zero where static, or a point.
  BodyShape shape;
  // What few ask for.
  Eigen::Vector3d moments;  ///< Principal moments of inertia; zero where unused.
  Eigen::Vector3d force_W;  ///< Constant, through the centre of mass. [N]
  Eigen::Vector3d applied_force_W = Eigen::Vector3d::Zero();   ///< For one step. [N]
  Eigen::Vector3d applied_torque_W = Eigen::Vector3d::Zero();  ///< For one step. [N m]

  bool is_static() const { return inverse_mass == 0; }
  /** Whether it moves, and turns as easily about any axis. */
  bool moves_round() const { return is_round && !is_static(); }
  Pose pose() const { return {R_WB, state.p_WB}; }
  /** All forces beside gravity. [N] */
  Eigen::Vector3d Push_W() const {
    return is_pushed ? Eigen::Vector3d(force_W + applied_force_W)
                     : Eigen::Vector3d::Zero();
  }
  /** [N m] */
  Eigen::Vector3d Torque_W() const {
    return is_pushed ? applied_torque_W : Eigen::Vector3d::Zero();
  }
};

/** Returns the body that `definition` describes.
 @throws std::invalid_argument where it is refused, see Validate(). */
RigidBody MakeRigidBody(const BodyDefinition& definition);

// What counts for rest between two bodies of which one moves at least.

/** Returns how far contacts of the two may be apart that are kept ready. [m] */
inline double SpeculativeMarginBetween(const RigidBody& A, const RigidBody& B) {
  return A.is_static()   ? B.margin
         : B.is_static() ? A.margin
                         : std::min(A.margin, B.margin);
}

/** Returns the depth that is left. [m] */
inline double SlopBetween(const RigidBody& A, const RigidBody& B) {
  return A.is_static() ? B.slop : B.is_static() ? A.slop : std::min(A.slop, B.slop);
}

/** Returns how hard the two are pulled, each by itself. [m/s²] */
inline double LoadBetween(const RigidBody& A, const RigidBody& B) {
  return A.is_static() ? B.load : B.is_static() ? A.load : std::max(A.load, B.load);
}

/** Returns how hard their islands are. [m/s²] */
inline double IslandLoadBetween(const RigidBody& A, const RigidBody& B) {
  return A.is_static()   ? B.island_load
         : B.is_static() ? A.island_load
                         : std::max(A.island_load, B.island_load);
}

/** Returns the radius of the largest ball in a body. [m] */
double InnerRadius(const RigidBody& body);

/** Returns a bound of how far any point of `body` is from the room that it filled before:
 of a ball, which turns in its place, the way of the centre. [m] */
double Travel(const BodyState& before, const RigidBody& body);

/** The velocity of a body while a step is solved: six doubles in a row and two of no
 concern. */
struct alignas(64) Velocity {
  Eigen::Vector3d v = Eigen::Vector3d::Zero();  ///< Of the centre of mass. [m/s]
  Eigen::Vector3d w = Eigen::Vector3d::Zero();  ///< [rad/s]

  /** Returns the velocity of the body's point at `r` from its centre. */
  Eigen::Vector3d At(const Eigen::Vector3d& r) const { return v + w.cross(r); }
};

/** What resists a change of velocity, in one line of a cache. */
struct alignas(64) InverseInertia {
  /** xx, xy, xz, yy, yz, zz of I⁻¹ = R diag(1/moments) Rᵀ. [1/(kg m²)] */
  std::array<double, 6> tensor_W{};
  double mass = 0;    ///< 1/m. [1/kg]
  double unused = 0;  ///< Read with the mass, four numbers at once.

  /** Returns I⁻¹ u. */
  Eigen::Vector3d Turn(const Eigen::Vector3d& u_W) const {
    const auto& [xx, xy, xz, yy, yz, zz] = tensor_W;
    return {xx * u_W[0] + xy * u_W[1] + xz * u_W[2],
            xy * u_W[0] + yy * u_W[1] + yz * u_W[2],
            xz * u_W[0] + yz * u_W[1] + zz * u_W[2]};
  }
};

/** Returns the inverse inertia of `body` as it is turned now. */
InverseInertia InverseInertiaOf(const RigidBody& body);

}  // namespace cookbook
