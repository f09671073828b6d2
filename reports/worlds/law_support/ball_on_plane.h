#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "reports/worlds/law_support/on_plane.h"
#include "reports/worlds/law_support/prediction.h"

namespace touchstone {

/** Returns the reason why body `index` is not a ball with equal moments of inertia that
 starts on a static plane; empty if it is. */
std::string WhyNoBallOnPlane(const World& world, int index);

/** The same for a ball, or for a capsule or a cylinder that lies on its side and moves
 and spins as it rolls: along the plane across its axis, and about its axis. */
std::string WhyNoRollerOnPlane(const World& world, int index);

/** The errors of an engine at one time, derived by the law. */
struct BallErrors {
  double speed;    ///< Size of what the solver makes. [m/s]
  double surface;  ///< Size of the error of a contact at depth δ. [m/s]
  double ending;   ///< Change caused by an event one step early or late. [m/s]
  double lag;      ///< Distance by which the scheme is behind or ahead. [m]
};

/** The closed form of a ball that rolls or slips on a plane, or of a roller. */
struct BallMotion {
  /** Returns the state after `t` [s]; its orientation is not read. */
  std::function<BodyState(double t)> truth;
  std::function<BallErrors(double t)> errors;
};

/** The words of what such a motion is. */
struct BallWords {
  std::string_view how;  ///< As in "rolling it moves at".
  AllowedWords velocity = {};
  AllowedWords position = {};
};

/** Judges position, velocity and spin of a ball or roller by its closed form.

 Friction acts on whatever presses the contact. So a velocity may be off by (1 + μ) of the
 ball's own velocity along the normal, and by δ/r of the velocity for a contact at depth
 δ, × 1.5. The residual of the solver and rounding come on top. The tolerance of the spin
 is that of the velocity over the radius, and over k if k < 1 (I = k m r²).

 @pre WhyNoRollerOnPlane() is empty. */
std::vector<Worst> JudgeBall(const Motion& motion, int body, const OnPlane& on,
                             const BallWords& words, const BallMotion& ball);

}  // namespace touchstone
