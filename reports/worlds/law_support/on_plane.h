#pragma once

#include <string>

#include "reports/worlds/law_support/landing.h"
#include "reports/worlds/law_support/law.h"

namespace touchstone {

/** A body that starts on a static plane, pressed against it by gravity and its force. */
struct OnPlane {
  Landing plane;
  double press = 0;           ///< Component of g + F/m into the plane, > 0. [m/s²]
  Eigen::Vector3d along_W;    ///< Part of g + F/m along the plane. [m/s²]
  Eigen::Vector3d v_along_W;  ///< Initial velocity along the plane. [m/s]
  double v_out = 0;           ///< Initial velocity away from the plane. [m/s]
  double slop = 0;            ///< OracleInfo::slop of the engine that is judged. [m]

  /** Returns whether the plane is level: gravity and force do not pull the body along
   it. */
  bool IsLevel() const;

  /** Returns the settling distance: the largest distance of the body from the plane in a
   correct engine. It is the gap at the start, g h² before the contact is detected and
   g h² before it is resisted, and the slop that the engine documents. [m] */
  double Settling(double dt) const;

  /** Returns the settling speed: the largest speed along the normal of a body that
   settles in a correct engine. It is the speed gained in a step and through the gap at
   the start, with its rebound by restitution; or the speed that removes a penetration at
   the start in one step. [m/s] */
  double SettlingSpeed(double dt) const;

  /** Returns the speed along the normal of a body that moves with `v_WB`, at most
   SettlingSpeed(). Friction acts on whatever presses the contact, so this speed widens
   tolerances; the bound keeps a body that flies off the plane from profiting. [m/s] */
  double SpeedAcross(const Eigen::Vector3d& v_WB, double dt) const;
};

/** Returns how body `index` lies on a plane, without slop. @pre WhyNotOnPlane() is empty.
 */
OnPlane OnPlaneOf(const World& world, int index);

/** The same with the slop of the engine that is judged. */
OnPlane OnPlaneOf(const Motion& motion, int index);

/** Returns the reason why body `index` does not start on a static plane: it does not lie
 flat, see LiesFlat(), or not within a thousandth of its size. Empty if it does. */
std::string WhyNotOnPlane(const World& world, int index);

}  // namespace touchstone
