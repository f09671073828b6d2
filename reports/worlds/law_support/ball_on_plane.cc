#include "reports/worlds/law_support/ball_on_plane.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "reports/text/format_vector.h"
#include "reports/worlds/law_support/error_laws.h"

namespace touchstone {

BallOnPlane::BallOnPlane(const Motion& motion, int body, const OnPlane& on,
                         std::string how, const std::string& velocity_because,
                         const std::string& position_because)
    : motion_(motion),
      body_(body),
      on_(on),
      how_(std::move(how)),
      position_(MeasureKind::kPositionError, position_because),
      velocity_(MeasureKind::kVelocityError, velocity_because),
      spin_(MeasureKind::kSpinError, velocity_because) {}

void BallOnPlane::Take(std::size_t s, const BodyState& truth, const Errors& errors) {
  const auto i = static_cast<std::size_t>(body_);
  const RigidBody& body = motion_.world.bodies[i];
  const BodyState& is = motion_.trajectory.samples[s].bodies[i];
  const double t = motion_.trajectory.times[s];
  const double h = motion_.world.dt;
  const double r = std::get<Sphere>(body.placed.shape).radius;
  const double k = InertiaOf(body).x() / (body.mass * r * r);
  const double rounding = RoundingOf(motion_.oracle, StepsBefore(motion_, s));
  const double share = kSolverResidual + rounding;
  const double inside = on_.Settling(h) / r;
  const double across = (1 + on_.plane.friction) * on_.SpeedAcross(is.v_WB, h);
  const double allowed =
      kSafety * (across + inside * errors.surface + errors.ending) + share * errors.speed;
  velocity_.Take((is.v_WB - truth.v_WB).norm(), allowed, [&] {
    return fmt::format("{} has {} moving at {} after {:.6g} s; {} it moves at {}",
                       motion_.oracle.name, body.name, FormatVector(is.v_WB, 9), t, how_,
                       FormatVector(truth.v_WB, 9));
  });
  spin_.Take((is.w_WB - truth.w_WB).norm(), allowed / (r * std::min(1.0, k)), [&] {
    return fmt::format("{} has {} spinning at {} after {:.6g} s; {} it spins at {}",
                       motion_.oracle.name, body.name, FormatVector(is.w_WB, 9), t, how_,
                       FormatVector(truth.w_WB, 9));
  });
  position_.Take((is.p_WB - truth.p_WB).norm(),
                 kSafety * (errors.lag + on_.Settling(h) + inside * errors.speed * t) +
                     share * errors.speed * t + rounding * body.placed.X_WB.p_WB.norm(),
                 [&] {
                   return fmt::format("{} has {} at {} after {:.6g} s; {} it is at {}",
                                      motion_.oracle.name, body.name,
                                      FormatVector(is.p_WB, 9), t, how_,
                                      FormatVector(truth.p_WB, 9));
                 });
}

}  // namespace touchstone
