#include "reports/worlds/law_support/ball_on_plane.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "reports/worlds/law_support/at_sample.h"
#include "reports/worlds/law_support/error_laws.h"
#include "reports/worlds/law_support/round_body.h"
#include "reports/worlds/law_support/slop.h"

namespace touchstone {
namespace {

/** Largest cosine of an angle that counts as right; quaternions have 16 digits. [-] */
constexpr double kAcross = 1e-9;

}  // namespace

std::string WhyNoBallOnPlane(const World& world, int index) {
  std::string why = WhyNotOnPlane(world, index);
  if (!why.empty()) return why;
  if (!IsEvenSphere(world.bodies[static_cast<std::size_t>(index)]))
    return "is no sphere with equal moments of inertia";
  return "";
}

std::string WhyNoRollerOnPlane(const World& world, int index) {
  const RigidBody& body = world.bodies[static_cast<std::size_t>(index)];
  if (!IsEvenRoller(body)) return WhyNoBallOnPlane(world, index);
  std::string why = WhyNotOnPlane(world, index);
  if (!why.empty()) return why;
  const OnPlane on = OnPlaneOf(world, index);
  const Eigen::Vector3d axis_W = body.placed.X_WB.R_WB.col(2);
  const auto is_across = [&](const Eigen::Vector3d& x_W) {
    return std::abs(axis_W.dot(x_W)) <= kAcross * x_W.norm();
  };
  if (!is_across(on.plane.n_W)) return "does not lie on its side";
  if (!is_across(on.along_W) || !is_across(on.v_along_W))
    return "does not move across its axis";
  if (axis_W.cross(body.w_WB).norm() > kAcross * body.w_WB.norm())
    return "does not spin about its axis";
  return "";
}

BallOnPlane::BallOnPlane(const Motion& motion, int body, const OnPlane& on,
                         std::string how, const std::string& velocity_because,
                         const std::string& position_because)
    : motion_(motion),
      body_(body),
      on_(on),
      how_(std::move(how)),
      position_(MeasureKind::kPositionError, WithSlop(position_because, motion.oracle)),
      velocity_(MeasureKind::kVelocityError, WithSlop(velocity_because, motion.oracle)),
      spin_(MeasureKind::kSpinError, WithSlop(velocity_because, motion.oracle)) {}

void BallOnPlane::Take(std::size_t s, const BodyState& truth, const Errors& errors) {
  const auto i = static_cast<std::size_t>(body_);
  const RigidBody& body = motion_.world.bodies[i];
  const BodyState& is = motion_.trajectory.samples[s].bodies[i];
  const double t = motion_.trajectory.times[s];
  const double h = motion_.world.dt;
  const double r = RadiusOf(body);
  const double k = InertiaRatioOf(body);
  const double rounding = RoundingOf(motion_.oracle, StepsBefore(motion_, s));
  const double share = kSolverResidual + rounding;
  const double inside = on_.Settling(h) / r;
  const double across = (1 + on_.plane.friction) * on_.SpeedAcross(is.v_WB, h);
  const double allowed =
      kSafety * (across + inside * errors.surface + errors.ending) + share * errors.speed;
  const AtSample at{motion_, s, body.name};
  at.Compare(velocity_, is.v_WB, truth.v_WB, allowed, how_ + " it moves at");
  at.Compare(spin_, is.w_WB, truth.w_WB, allowed / (r * std::min(1.0, k)),
             how_ + " it spins at");
  at.Compare(position_, is.p_WB, truth.p_WB,
             kSafety * (errors.lag + on_.Settling(h) + inside * errors.speed * t) +
                 share * errors.speed * t + rounding * body.placed.X_WB.p_WB.norm(),
             how_ + " it is at");
}

}  // namespace touchstone
