#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include <Eigen/Core>

namespace touchstone {

/** The set that bounds the tangential impulse of a contact; its size is μ times the
 normal impulse. Coulomb's is the circle; solvers with two friction directions have the
 others. */
enum class FrictionCone {
  kCircle,   ///< |J_t| <= μ J_n.
  kBox,      ///< Each component <= μ J_n: the L∞ norm.
  kDiamond,  ///< The sum of the components <= μ J_n: the L1 norm.
};

/** Returns "circular friction cone", "L∞ friction cone", "L1 friction cone". */
std::string_view NameOf(FrictionCone cone);

/** The displacement and the remaining velocity of a slip, in the plane of contact. */
struct Slip {
  Eigen::Vector2d travelled;  ///< ∫ s dt. [m]
  Eigen::Vector2d velocity;   ///< s. [m/s]
};

/** Returns the slip after `t` that starts as `velocity` and is braked by friction alone.
 Friction decelerates by up to `deceleration` = μ g (a positive number [m/s²]) within the
 cone, always in the direction of maximum dissipation.

 Circle: s decreases along its own direction at μ g, to rest after |s|/μg.
 Box: each component decreases at μ g on its own.
 Diamond: the larger component alone decreases at μ g until both are equal, then both at
 half of that. */
Slip SlipAfter(FrictionCone cone, const Eigen::Vector2d& velocity, double deceleration,
               double t);

/** Returns the acceleration of a body at rest under the acceleration `drive` along the
 plane and friction of up to `deceleration`: zero if the cone holds it. [m/s²] */
Eigen::Vector2d DrivenFromRest(FrictionCone cone, const Eigen::Vector2d& drive,
                               double deceleration);

/** Returns the point of the cone of size `radius` nearest to `impulse`: the tangential
 impulse that leaves the least slip if the effective mass is the same in all
 directions. */
Eigen::Vector2d NearestInCone(FrictionCone cone, const Eigen::Vector2d& impulse,
                              double radius);

/** Two directions that span the plane of a contact. */
using TangentFrame = Eigen::Matrix<double, 3, 2>;

/** Returns the frame whose first direction is world axis 0, 1 or 2 projected onto the
 plane with normal `n_W`; empty if that axis is nearly the normal. */
std::optional<TangentFrame> TangentFrameAlong(const Eigen::Vector3d& n_W, int axis);

/** Returns the frames in which a solver may have its friction directions on a plane with
 normal `n_W`, as far as the normal determines them: the world axes projected onto the
 plane. */
std::vector<TangentFrame> TangentFramesOf(const Eigen::Vector3d& n_W);

/** A cone with its directions. */
struct PlacedCone {
  FrictionCone cone;
  TangentFrame frame;
};

/** Returns the circle, in some frame, followed by the box and the diamond in every
 frame. */
std::vector<PlacedCone> ConesOn(const Eigen::Vector3d& n_W);

}  // namespace touchstone
