#include "reports/worlds/law_support/on_plane.h"

#include <algorithm>
#include <cmath>

#include "reports/worlds/law_support/subjects.h"
#include "reports/worlds/truth/mechanics.h"

namespace touchstone {
namespace {

/** Largest initial distance of a body from its plane, over its size: scenes give contacts
 a small penetration so that they are detected at once. [-] */
constexpr double kSurfaceSlack = 1e-3;

/** Largest angle of the initial velocity to the plane, and largest slope that counts as
 level; quaternions have 16 digits. [rad] */
constexpr double kParallel = 1e-9;

}  // namespace

bool OnPlane::IsLevel() const {
  return !(along_W.norm() > kParallel * press);
}

double OnPlane::Settling(double dt) const {
  return std::abs(plane.gap) + 2 * press * dt * dt + slop;
}

double OnPlane::SettlingSpeed(double dt) const {
  const double parting = std::max(0.0, -plane.gap) / dt;
  const double falling = press * dt + std::sqrt(2 * press * std::max(0.0, plane.gap));
  return parting + (1 + plane.restitution) * falling;
}

double OnPlane::SpeedAcross(const Eigen::Vector3d& v_WB, double dt) const {
  return std::min(std::abs(v_WB.dot(plane.n_W)), SettlingSpeed(dt));
}

OnPlane OnPlaneOf(const World& world, int index) {
  const RigidBody& body = world.bodies[static_cast<std::size_t>(index)];
  const Landing plane = *LandingOf(world, index);
  const Eigen::Vector3d a_W = AccelerationOf(world, body);
  const double out = a_W.dot(plane.n_W);
  const double v_out = body.v_WB.dot(plane.n_W);
  return {plane, -out, a_W - out * plane.n_W, body.v_WB - v_out * plane.n_W, v_out};
}

OnPlane OnPlaneOf(const Motion& motion, int index) {
  OnPlane on = OnPlaneOf(motion.world, index);
  on.slop = motion.oracle.slop;
  return on;
}

std::string WhyNotOnPlane(const World& world, int index) {
  const RigidBody& body = world.bodies[static_cast<std::size_t>(index)];
  const std::optional<Landing> plane = LandingOf(world, index);
  if (!plane) return "is not on a static half-space or box";
  const double size = BoundingRadius(body.placed.shape);
  if (std::abs(plane->gap) > kSurfaceSlack * size) return "does not start on the ground";
  if (!LiesFlat(body, plane->n_W)) return "does not lie flat";
  const OnPlane on = OnPlaneOf(world, index);
  if (on.press <= 0) return "is not pressed against the ground";
  if (std::abs(on.v_out) > kParallel * body.v_WB.norm())
    return "does not start along the ground";
  if (IsHeld(world, AnchorKind::kBody, index) || IsPushed(world, index))
    return "is held or pushed";
  return "";
}

}  // namespace touchstone
