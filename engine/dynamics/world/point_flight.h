#pragma once

#include <span>

#include "engine/dynamics/body/rigid_body.h"

namespace cookbook {

/** The exact solution of linear drag over a step of `h` [s], for the drag c [1/s] and a
 constant force. With z = c h: */
struct Drag {
  Drag(double c, double h);

  double decay;         ///< Factor on the velocity: exp(−z).
  double force_factor;  ///< Factor on the velocity change by a force: (1 − exp(−z))/z.
  double
      travel_factor;  ///< Travel due to that change, divided by change × h; 1/2 if c = 0.
};

/** The motion of a point under a constant acceleration. World frame. */
struct PointFlight {
  Eigen::Vector3d p;  ///< Start position. [m]
  Eigen::Vector3d v;  ///< Start velocity. [m/s]
  Eigen::Vector3d a;  ///< Acceleration. [m/s²]
};

/** The state of a point at the end of a step. */
struct PointFlightEnd {
  Eigen::Vector3d p_W;  ///< [m]
  Eigen::Vector3d v_W;  ///< [m/s]
  bool hit = false;     ///< Whether the point has hit a solid.
};

/** Continuous collision of a point with the static boxes and half-spaces `solids`,
 indices into `bodies`, for `h` [s] > 0. At the time of impact the point bounces, v_n →
 −restitution v_n, and continues. If it is slower than `resting_speed` [m/s] or has
 bounced too often, it stays on the surface and slides without friction. A point that
 starts inside a solid leaves it freely. */
PointFlightEnd FollowPoint(const PointFlight& flight, double h, double restitution,
                           double resting_speed, std::span<const RigidBody> bodies,
                           std::span<const int> solids);

}  // namespace cookbook
