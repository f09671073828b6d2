#pragma once

#include <span>

#include "engine/dynamics/body/rigid_body.h"
#include "engine/dynamics/joints/anchor.h"

namespace cookbook {

/** The position of an anchor. World frame. */
struct AnchorPoint {
  Eigen::Vector3d p_W;  ///< [m]
  Eigen::Vector3d r_W;  ///< From the centre of its body; zero for body −1. [m]
};

/** Returns the position of `anchor`, given the poses of the bodies. */
AnchorPoint LocateAnchor(const Anchor& anchor, std::span<const RigidBody> bodies);

/** A constraint along one axis between two bodies, or a body and the world (−1). */
struct AxialConstraint {
  int A;
  int B;
  Eigen::Vector3d n;    ///< The axis, from A's anchor to B's. A unit vector, or shorter.
  Eigen::Vector3d r_A;  ///< From the centre of A to its anchor. [m]
  Eigen::Vector3d r_B;  ///< From the centre of B to its anchor. [m]

  /** Returns the change of RelativeVelocity() by a unit impulse, n on B and −n on A.
   [1/kg] */
  double InverseEffectiveMass(std::span<const InverseInertia> inertias) const;

  // The two functions below are inline: solvers call them up to millions of times a step.

  /** Returns n·(velocity of B's anchor − velocity of A's anchor). [m/s] */
  double RelativeVelocity(std::span<const Velocity> velocities) const {
    Eigen::Vector3d u = Eigen::Vector3d::Zero();
    if (B >= 0) u += VelocityAt(r_B, velocities[static_cast<std::size_t>(B)]);
    if (A >= 0) u -= VelocityAt(r_A, velocities[static_cast<std::size_t>(A)]);
    return n.dot(u);
  }

  /** Applies the impulse `impulse` n to B and its opposite to A. `impulse`: [N s]. */
  void ApplyImpulse(double impulse, std::span<const InverseInertia> inertias,
                    std::span<Velocity> velocities) const {
    const Eigen::Vector3d J = impulse * n;
    ApplyToBody(A, -J, r_A, inertias, velocities);
    ApplyToBody(B, J, r_B, inertias, velocities);
  }

 private:
  // An anchor in the centre of its body, as every one of a point, has no lever arm. That
  // halves the chain of operations from one constraint to the next.

  static Eigen::Vector3d VelocityAt(const Eigen::Vector3d& r, const Velocity& velocity) {
    return r.isZero(0) ? velocity.v : velocity.At(r);
  }

  static void ApplyToBody(int body, const Eigen::Vector3d& J, const Eigen::Vector3d& r,
                          std::span<const InverseInertia> inertias,
                          std::span<Velocity> velocities) {
    if (body < 0) return;
    const InverseInertia& inertia = inertias[static_cast<std::size_t>(body)];
    Velocity& velocity = velocities[static_cast<std::size_t>(body)];
    velocity.v += inertia.mass * J;
    if (!r.isZero(0)) velocity.w += inertia.Times(r.cross(J));
  }
};

}  // namespace cookbook
