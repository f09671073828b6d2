#pragma once

#include <string>

#include "reports/worlds/law_support/landing.h"

namespace touchstone {

/** A body that starts on a static plane, pressed against it by gravity and its force. */
struct OnPlane {
  Landing plane;
  double press = 0;           ///< The part of g + F/m into the plane, > 0. [m/s²]
  Eigen::Vector3d along_W;    ///< The part of g + F/m along it. [m/s²]
  Eigen::Vector3d v_along_W;  ///< The start's velocity along it. [m/s]
  double v_out = 0;           ///< And away from it. [m/s]

  /** How far a right engine may have the body from the plane: what it starts from it, and
   what it falls before the contact is seen and resisted, g h² and once more. [m] */
  double Settling(double dt) const;

  /** How fast a right engine may have the body move across the plane while it settles:
   what it falls at in a step or through the gap that it starts with, turned back by
   restitution; or what parts it in a step from a plane that it starts inside. [m/s] */
  double SettlingSpeed(double dt) const;

  /** Returns the speed across the plane of a body that moves with `v_WB`, up to
   SettlingSpeed(): friction acts on what presses the contact too, but a body that
   flies off the plane is not excused by that. [m/s] */
  double SpeedAcross(const Eigen::Vector3d& v_WB, double dt) const;
};

/** Returns how body `index` lies on a plane. @pre WhyNotOnPlane() is empty. */
OnPlane OnPlaneOf(const World& world, int index);

/** Returns why body `index` does not start on a static plane, to within a thousandth of
 its size, with a face where it is a box; empty where it does. */
std::string WhyNotOnPlane(const World& world, int index);

}  // namespace touchstone
