#pragma once

#include <span>

#include "engine/dynamics/body/rigid_body.h"

namespace cookbook {

/** An end of a joint or a spring. */
struct Anchor {
  int body = -1;  ///< −1: fixed to the world.
  /** In the frame of the body, from its centre; in the world for −1. [m] */
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
};

/** Where an anchor is. World frame. */
struct AnchorPlace {
  Eigen::Vector3d p_W;  ///< [m]
  Eigen::Vector3d r_W;  ///< From the centre of its body; zero for the world.
};

/** Returns the place of `anchor`, given the poses of the bodies. */
AnchorPlace PlaceOf(const Anchor& anchor, std::span<const RigidBody> bodies);

/** Two bodies, or the world (−1), on which a massless thing loads along one line. */
struct Line {
  int A;
  int B;
  Eigen::Vector3d n;    ///< Along it, out of A's anchor.
  Eigen::Vector3d r_A;  ///< From the centre of A to its anchor. [m]
  Eigen::Vector3d r_B;

  /** Returns what a unit impulse, n on B and −n on A, changes of Parting(). [1/kg] */
  double Response(std::span<const InverseInertia> inertias) const;

  /** Returns n·(velocity of B's anchor − that of A's). [m/s] */
  double Parting(std::span<const Velocity> velocities) const;

  /** Gives `impulse` n to B and its opposite to A. */
  void Apply(double impulse, std::span<const InverseInertia> inertias,
             std::span<Velocity> velocities) const;
};

}  // namespace cookbook
