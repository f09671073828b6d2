#include "reports/worlds/law_support/landing.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace touchstone {
namespace {

/** Largest angle of a face to the plane it lies on; quaternions have 16 digits. [rad] */
constexpr double kFlat = 1e-9;

/** A plane that never moves. */
struct Plane {
  Eigen::Vector3d n_W;
  Eigen::Vector3d p_W;
};

std::optional<Plane> PlaneUnder(const Body& ground, const Eigen::Vector3d& p_W) {
  const Eigen::Matrix3d& R = ground.X_WB.R_WB;
  if (std::holds_alternative<HalfSpace>(ground.shape))
    return Plane{R.col(2), ground.X_WB.p_WB};
  const auto* box = std::get_if<Box>(&ground.shape);
  if (!box) return std::nullopt;
  const Eigen::Vector3d p_B = R.transpose() * (p_W - ground.X_WB.p_WB);
  int axis = 0;
  (p_B.cwiseAbs() - box->half_extents).maxCoeff(&axis);
  for (int other = 0; other < 3; ++other) {
    if (other != axis && std::abs(p_B[other]) > box->half_extents[other])
      return std::nullopt;
  }
  const double side = p_B[axis] < 0 ? -1 : 1;
  return Plane{side * R.col(axis),
               ground.X_WB.p_WB + side * box->half_extents[axis] * R.col(axis)};
}

}  // namespace

bool LiesFlat(const RigidBody& body, const Eigen::Vector3d& n_W) {
  if (!std::holds_alternative<Box>(body.placed.shape)) return true;
  const Eigen::Vector3d n_B = body.placed.X_WB.R_WB.transpose() * n_W;
  return !(n_B.cwiseAbs().maxCoeff() < 1 - kFlat);
}

Arrival ArrivalAt(const Landing& landing, const Eigen::Vector3d& v_W,
                  const Eigen::Vector3d& a_W) {
  // The first root of gap + v t + ½ a t² = 0, written so that nothing cancels.
  const double gap = std::max(0.0, landing.gap);
  const double v = landing.n_W.dot(v_W);
  const double a = landing.n_W.dot(a_W);
  const double speed = std::sqrt(v * v - 2 * a * gap);
  if (v < 0) return {2 * gap / (speed - v), speed};
  if (a < 0) return {-(v + speed) / a, speed};
  return {std::numeric_limits<double>::quiet_NaN(), speed};
}

Eigen::Vector3d SupportOf(const RigidBody& body, const Eigen::Vector3d& d_W) {
  const Pose& pose = body.placed.X_WB;
  if (const auto* sphere = std::get_if<Sphere>(&body.placed.shape))
    return pose.p_WB + sphere->radius * d_W.normalized();
  const Eigen::Vector3d& half = std::get<Box>(body.placed.shape).half_extents;
  const Eigen::Vector3d d_B = pose.R_WB.transpose() * d_W;
  Eigen::Vector3d corner;
  for (int axis = 0; axis < 3; ++axis)
    corner[axis] = std::copysign(half[axis], d_B[axis]);
  return pose * corner;
}

std::optional<Landing> LandingOf(const World& world, int index) {
  const RigidBody& body = world.bodies[static_cast<std::size_t>(index)];
  const bool known = std::holds_alternative<Sphere>(body.placed.shape) ||
                     std::holds_alternative<Box>(body.placed.shape);
  if (!body.collides || !known) return std::nullopt;
  std::optional<Landing> nearest;
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    const RigidBody& ground = world.bodies[i];
    if (ground.mass > 0 || !ground.collides) continue;
    const std::optional<Plane> plane = PlaneUnder(ground.placed, body.placed.X_WB.p_WB);
    if (!plane || plane->n_W.dot(body.placed.X_WB.p_WB - plane->p_W) <= 0) continue;
    const Eigen::Vector3d p_WC = SupportOf(body, -plane->n_W);
    const double gap = plane->n_W.dot(p_WC - plane->p_W);
    if (nearest && nearest->gap <= gap) continue;
    nearest = Landing{static_cast<int>(i),
                      plane->n_W,
                      gap,
                      p_WC,
                      std::min(body.restitution, ground.restitution),
                      std::sqrt(body.friction * ground.friction)};
  }
  return nearest;
}

std::optional<Landing> LandingOfPoint(const World& world, const Eigen::Vector3d& p_W) {
  std::optional<Landing> nearest;
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    const RigidBody& ground = world.bodies[i];
    if (ground.mass > 0 || !ground.collides) continue;
    const std::optional<Plane> plane = PlaneUnder(ground.placed, p_W);
    if (!plane) continue;
    const double gap = plane->n_W.dot(p_W - plane->p_W);
    if (gap < 0 || (nearest && nearest->gap <= gap)) continue;
    nearest = Landing{static_cast<int>(i), plane->n_W, gap, p_W};
  }
  return nearest;
}

}  // namespace touchstone
