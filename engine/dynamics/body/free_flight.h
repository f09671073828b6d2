#pragma once

#include "engine/dynamics/body/rigid_body.h"
#include "engine/dynamics/body/settings.h"

namespace cookbook {

/** The way of a rigid body under a constant force and torque, while nothing touches it.
 */
struct FreeFlight {
  RigidBody start;
  double from = 0;                                     ///< When it starts. [s]
  Eigen::Vector3d a_W = Eigen::Vector3d::Zero();       ///< [m/s²]
  Eigen::Vector3d torque_W = Eigen::Vector3d::Zero();  ///< [N m]
  /** What forces would make of it if nothing held it: decides what strikes. [m/s²] */
  Eigen::Vector3d load_W = Eigen::Vector3d::Zero();

  /** Returns the body at time `t` [s]. What is static stays. */
  RigidBody At(double t, Gyroscopic rule) const;

  /** The same, but that a ball, which fills the same room however it is turned, stays
   turned as it was. */
  RigidBody RoomAt(double t, Gyroscopic rule) const;
};

/** Returns a bound of how fast a point of `body` moves because it turns; 0 of a ball,
 whose surface stays where it is. [m/s] */
double TurningSpeed(const RigidBody& body);

/** The same, along `n_W` alone. */
double TurningSpeed(const RigidBody& body, const Eigen::Vector3d& n_W);

/** Returns a bound of how far any point of `body` gets from where it is in `time` [s], in
 which the velocity of its centre goes to `v_W` at a constant rate; 0 of what is static.
 [m] */
double Reach(const RigidBody& body, const Eigen::Vector3d& v_W, double time);

}  // namespace cookbook
