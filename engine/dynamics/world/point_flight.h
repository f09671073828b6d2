#pragma once

#include <span>

#include "engine/dynamics/body/rigid_body.h"

namespace cookbook {

/** What drag makes of a step of `h` [s], c being the drag [1/s]. */
struct Drag {
  Drag(double c, double h);

  double kept;  ///< Of the velocity: exp(−c h).
  double gain;  ///< Of the velocity that a constant force gives: (1 − exp(−c h))/(c h).
  double share;  ///< Of that velocity, times h, what it moves by: 1/2 without drag.
};

/** The way of a point during a step, under a constant acceleration. World frame. */
struct Flight {
  Eigen::Vector3d p;  ///< At the start. [m]
  Eigen::Vector3d v;  ///< [m/s]
  Eigen::Vector3d a;  ///< [m/s²]
};

/** Where a point is at the end of a step and how it moves. */
struct Landing {
  Eigen::Vector3d p_W;
  Eigen::Vector3d v_W;
  bool hit = false;  ///< Whether it met a solid on its way.
};

/** Follows a point for `h` [s] > 0 past the static boxes and half-spaces among `bodies`
 that collide. Where its way enters one it is sent back at once, v_n → −bounce v_n, and
 flies on; where it comes slower than `resting_speed` [m/s] or comes back again and again
 it stays on the surface and slides without friction. A point that starts inside a solid
 passes out of it. */
Landing Follow(const Flight& flight, double h, double bounce, double resting_speed,
               std::span<const RigidBody> bodies, std::span<const int> solids);

}  // namespace cookbook
