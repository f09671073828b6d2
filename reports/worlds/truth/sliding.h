#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include <Eigen/Core>

namespace touchstone {

/** The set that holds the tangential impulse of one contact, of which μ times the normal
 impulse is the size. Coulomb's is the circle; the others are what solvers with two
 friction directions have. */
enum class FrictionCone {
  kCircle,   ///< |J_t| <= μ J_n.
  kBox,      ///< Each component <= μ J_n: the L∞ norm.
  kDiamond,  ///< The sum of the components <= μ J_n: the L1 norm.
};

/** Returns "circular friction cone", "L∞ friction cone", "L1 friction cone". */
std::string_view NameOf(FrictionCone cone);

/** Where a slip has led, and what is left of it, in the plane of contact. */
struct Slip {
  Eigen::Vector2d travelled;  ///< ∫ s dt. [m]
  Eigen::Vector2d velocity;   ///< s. [m/s]
};

/** Returns the slip after `t` that starts as `velocity` and that friction alone brakes,
 with up to `deceleration` μ g (a positive number [m/s²]) within the cone, always so that
 it takes the most energy:

 circle: s falls along its own direction at μ g, to rest after |s|/μg;
 box: each component falls at μ g on its own;
 diamond: the larger component alone falls at μ g until both are equal, then both at half
 of it. */
Slip SlipAfter(FrictionCone cone, const Eigen::Vector2d& velocity, double deceleration,
               double t);

/** Returns the acceleration of what is pushed from rest along the plane by the
 acceleration `drive` and held by friction of up to `deceleration`: zero where the cone
 holds it. [m/s²] */
Eigen::Vector2d DrivenFromRest(FrictionCone cone, const Eigen::Vector2d& drive,
                               double deceleration);

/** Returns the point of the cone of size `radius` nearest to `impulse`: the tangential
 impulse that leaves the least slip where its effective mass is the same in all
 directions. */
Eigen::Vector2d NearestInCone(FrictionCone cone, const Eigen::Vector2d& impulse,
                              double radius);

/** Two directions that span the plane of a contact. */
using TangentFrame = Eigen::Matrix<double, 3, 2>;

/** Returns the frame whose first direction is the world's axis 0, 1 or 2 projected onto
 the plane with normal `n_W`; none where that axis is nearly the normal. */
std::optional<TangentFrame> TangentFrameAlong(const Eigen::Vector3d& n_W, int axis);

/** Returns the frames in which a solver may have its friction directions on a plane with
 normal `n_W`, as far as they follow from it: the world's axes projected onto the plane.
 */
std::vector<TangentFrame> TangentFramesOf(const Eigen::Vector3d& n_W);

/** A cone with its directions. */
struct PlacedCone {
  FrictionCone cone;
  TangentFrame frame;
};

/** Returns the circle, in some frame, and after it every box and diamond in every frame.
 */
std::vector<PlacedCone> ConesOn(const Eigen::Vector3d& n_W);

}  // namespace touchstone
