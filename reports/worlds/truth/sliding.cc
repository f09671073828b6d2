#include "reports/worlds/truth/sliding.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace touchstone {
namespace {

/** Distance and speed after `t` of a body that decelerates uniformly from `speed` >=
 0. */
struct Braked {
  double travelled;
  double speed;
};

Braked BrakedAfter(double speed, double deceleration, double t) {
  const double until = deceleration > 0 ? std::min(t, speed / deceleration) : t;
  return {until * (speed - deceleration * until / 2),
          std::max(0.0, speed - deceleration * until)};
}

}  // namespace

std::string_view NameOf(FrictionCone cone) {
  switch (cone) {
    case FrictionCone::kCircle:
      return "circular friction cone";
    case FrictionCone::kBox:
      return "L∞ friction cone";
    case FrictionCone::kDiamond:
      return "L1 friction cone";
  }
  return "";
}

Slip SlipAfter(FrictionCone cone, const Eigen::Vector2d& velocity, double deceleration,
               double t) {
  Slip slip{Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero()};
  if (cone == FrictionCone::kCircle) {
    const double speed = velocity.norm();
    if (speed == 0) return slip;
    const Braked braked = BrakedAfter(speed, deceleration, t);
    return {velocity * (braked.travelled / speed), velocity * (braked.speed / speed)};
  }
  if (cone == FrictionCone::kBox) {
    for (int axis = 0; axis < 2; ++axis) {
      const Braked braked = BrakedAfter(std::abs(velocity[axis]), deceleration, t);
      slip.travelled[axis] = std::copysign(braked.travelled, velocity[axis]);
      slip.velocity[axis] = std::copysign(braked.speed, velocity[axis]);
    }
    return slip;
  }
  const int larger = std::abs(velocity.x()) >= std::abs(velocity.y()) ? 0 : 1;
  const int smaller = 1 - larger;
  const double fast = std::abs(velocity[larger]);
  const double slow = std::abs(velocity[smaller]);
  const double equal = deceleration > 0 ? std::min(t, (fast - slow) / deceleration) : t;
  const Braked both = BrakedAfter(slow, deceleration / 2, t - equal);
  const Braked first = BrakedAfter(fast, deceleration, equal);
  const double left = equal < t ? both.speed : slow;
  slip.travelled[larger] =
      std::copysign(first.travelled + both.travelled, velocity[larger]);
  slip.velocity[larger] = std::copysign(equal < t ? left : first.speed, velocity[larger]);
  slip.travelled[smaller] =
      std::copysign(slow * equal + both.travelled, velocity[smaller]);
  slip.velocity[smaller] = std::copysign(left, velocity[smaller]);
  return slip;
}

Eigen::Vector2d DrivenFromRest(FrictionCone cone, const Eigen::Vector2d& drive,
                               double deceleration) {
  if (cone == FrictionCone::kCircle) {
    const double size = drive.norm();
    return size > deceleration ? Eigen::Vector2d(drive * (1 - deceleration / size))
                               : Eigen::Vector2d::Zero();
  }
  Eigen::Vector2d left = drive.cwiseAbs();
  if (cone == FrictionCone::kBox) {
    left = (left.array() - deceleration).max(0);
  } else {
    // The faster direction is braked alone as long as it stays the faster one.
    const int larger = left.x() >= left.y() ? 0 : 1;
    const int smaller = 1 - larger;
    if (left[larger] - deceleration >= left[smaller]) {
      left[larger] -= deceleration;
    } else {
      left.setConstant(std::max(0.0, (left.sum() - deceleration) / 2));
    }
  }
  return {std::copysign(left.x(), drive.x()), std::copysign(left.y(), drive.y())};
}

Eigen::Vector2d NearestInCone(FrictionCone cone, const Eigen::Vector2d& impulse,
                              double radius) {
  return impulse - DrivenFromRest(cone, impulse, radius);
}

std::optional<TangentFrame> TangentFrameAlong(const Eigen::Vector3d& n_W, int axis) {
  const Eigen::Vector3d along = Eigen::Vector3d::Unit(axis);
  const Eigen::Vector3d t_W = along - along.dot(n_W) * n_W;
  // An axis along the normal has no direction in the plane.
  if (t_W.norm() < 1e-3) return std::nullopt;
  TangentFrame frame;
  frame.col(0) = t_W.normalized();
  frame.col(1) = n_W.cross(frame.col(0));
  return frame;
}

std::vector<TangentFrame> TangentFramesOf(const Eigen::Vector3d& n_W) {
  std::vector<TangentFrame> frames;
  for (int axis = 0; axis < 3; ++axis) {
    const std::optional<TangentFrame> frame = TangentFrameAlong(n_W, axis);
    if (frame) frames.push_back(*frame);
  }
  return frames;
}

std::vector<PlacedCone> ConesOn(const Eigen::Vector3d& n_W) {
  const std::vector<TangentFrame> frames = TangentFramesOf(n_W);
  std::vector<PlacedCone> cones = {{FrictionCone::kCircle, frames.front()}};
  for (const FrictionCone cone : {FrictionCone::kBox, FrictionCone::kDiamond}) {
    for (const TangentFrame& frame : frames) cones.push_back({cone, frame});
  }
  return cones;
}

}  // namespace touchstone
