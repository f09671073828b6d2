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

  /** Returns n·(velocity of B's anchor − velocity of A's anchor). [m/s] */
  double RelativeVelocity(std::span<const Velocity> velocities) const;

  /** Applies the impulse `impulse` n to B and its opposite to A. `impulse`: [N s]. */
  void ApplyImpulse(double impulse, std::span<const InverseInertia> inertias,
                    std::span<Velocity> velocities) const;
};

}  // namespace cookbook
