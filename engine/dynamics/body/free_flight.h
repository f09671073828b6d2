#pragma once

#include <limits>

#include "engine/dynamics/body/rigid_body.h"
#include "engine/dynamics/body/settings.h"

namespace cookbook {

/** The motion of a rigid body in free flight, under a constant force and torque. */
struct FreeFlight {
  RigidBody start;                                     ///< The body at time `from`.
  double from = 0;                                     ///< Start time. [s]
  Eigen::Vector3d a_W = Eigen::Vector3d::Zero();       ///< Acceleration. [m/s²]
  Eigen::Vector3d torque_W = Eigen::Vector3d::Zero();  ///< [N m]
  /** Acceleration by gravity and forces if nothing held the body. It decides whether a
   contact is an impact. [m/s²] */
  Eigen::Vector3d load_acceleration_W = Eigen::Vector3d::Zero();

  /** The time from which on the body stays where it is and keeps its velocity. [s] */
  double until = std::numeric_limits<double>::infinity();

  /** Returns the body at time `t` [s]. A static body stays where it is. */
  RigidBody At(double t, Gyroscopic rule) const;

  /** Like At(), but only the shape is valid: a sphere keeps its initial orientation,
   which is cheaper and does not move its surface. */
  RigidBody ShapeAt(double t, Gyroscopic rule) const;
};

/** Returns an upper bound on the speed of the points of `body` due to rotation; 0 for a
 sphere, whose surface rotation does not move. [m/s] */
double RotationalSpeed(const RigidBody& body);

/** The same for the component of the velocity along the unit vector `n_W`. [m/s] */
double RotationalSpeed(const RigidBody& body, const Eigen::Vector3d& n_W);

/** Returns an upper bound on the distance that a rotation moves any point of `body` in
 `time` [s]; 0 for a sphere and a static body. [m] */
double MaxTravelByRotation(const RigidBody& body, double time);

/** Returns an upper bound on the distance that any point of `body` travels in `time` [s],
 while the velocity of its centre changes to `v_W` at a constant rate; 0 for a static
 body. [m] */
double MaxTravel(const RigidBody& body, const Eigen::Vector3d& v_W, double time);

}  // namespace cookbook
