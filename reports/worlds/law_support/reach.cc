#include "reports/worlds/law_support/reach.h"

#include <variant>

#include "reports/worlds/law_support/error_laws.h"
#include "reports/worlds/truth/mechanics.h"

namespace touchstone {
namespace {

/** Radii are larger by this share, for the rounding of distances. */
constexpr double kRounding = 1e-9;

}  // namespace

Reach::Reach(const Motion& motion) : motion_(motion) {
  for (const RigidBody& body : motion.world.bodies) {
    Bounds bounds;
    bounds.is_half_space = std::holds_alternative<HalfSpace>(body.placed.shape);
    bounds.is_static = body.mass == 0;
    bounds.p_W = body.placed.X_WB.p_WB;
    bounds.n_W = body.placed.X_WB.R_WB.col(2);
    if (!bounds.is_half_space)
      bounds.radius = BoundingRadius(body.placed.shape) * (1 + kRounding);
    bounds_.push_back(bounds);
  }
  for (std::size_t i = 0; i < bounds_.size(); ++i) {
    Bounds& bounds = bounds_[i];
    if (bounds.is_half_space) continue;
    for (std::size_t s = 0; s < motion.trajectory.samples.size(); ++s) {
      bounds.way.extend(CentreOf(s, i));
      if (bounds.is_static) break;
    }
    if (bounds.way.isEmpty()) continue;
    const Eigen::Vector3d radii = Eigen::Vector3d::Constant(
        bounds.radius + kRounding * bounds.way.max().cwiseMax(-bounds.way.min()).norm());
    bounds.way = {bounds.way.min() - radii, bounds.way.max() + radii};
  }
}

const Eigen::Vector3d& Reach::CentreOf(std::size_t s, std::size_t body) const {
  const Bounds& bounds = bounds_[body];
  return bounds.is_static ? bounds.p_W : motion_.trajectory.samples[s].bodies[body].p_WB;
}

bool Reach::IsNearPlane(std::size_t s, const Bounds& plane, std::size_t body) const {
  const Eigen::Vector3d& p_W = CentreOf(s, body);
  const double rounding = kRounding * (p_W.norm() + plane.p_W.norm());
  // Written so that a NaN may touch.
  return !(plane.n_W.dot(p_W - plane.p_W) > bounds_[body].radius + rounding);
}

bool Reach::MayEverTouch(int A, int B) const {
  const auto a = static_cast<std::size_t>(A);
  const auto b = static_cast<std::size_t>(B);
  if (!bounds_[a].is_half_space && !bounds_[b].is_half_space)
    return bounds_[a].way.intersects(bounds_[b].way);
  for (std::size_t s = 0; s < motion_.trajectory.samples.size(); ++s)
    if (MayTouch(s, A, B)) return true;
  return false;
}

bool Reach::MayTouch(std::size_t s, int A, int B) const {
  const auto a = static_cast<std::size_t>(A);
  const auto b = static_cast<std::size_t>(B);
  if (bounds_[a].is_half_space) return IsNearPlane(s, bounds_[a], b);
  if (bounds_[b].is_half_space) return IsNearPlane(s, bounds_[b], a);
  const Eigen::Vector3d& p_WA = CentreOf(s, a);
  const Eigen::Vector3d& p_WB = CentreOf(s, b);
  const double rounding = kRounding * (p_WA.norm() + p_WB.norm());
  return !((p_WB - p_WA).norm() > bounds_[a].radius + bounds_[b].radius + rounding);
}

double WayAfter(const Motion& motion, std::size_t s, int body) {
  const auto i = static_cast<std::size_t>(body);
  const RigidBody& asked = motion.world.bodies[i];
  if (asked.mass == 0) return 0;
  const BodyState& is = motion.trajectory.samples[s].bodies[i];
  const double speed =
      is.v_WB.norm() + is.w_WB.norm() * BoundingRadius(asked.placed.shape);
  const double spacing = SampleSpacing(motion.world);
  return spacing * (speed + spacing * AccelerationOf(motion.world, asked).norm());
}

}  // namespace touchstone
