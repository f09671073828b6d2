#include "reports/worlds/truth/vertical_bounces.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace touchstone {

VerticalBounces::VerticalBounces(const Height& start, double gravity, double restitution)
    : start_(start),
      gravity_(gravity),
      restitution_(restitution),
      impact_speed_(std::sqrt(start.velocity * start.velocity + 2 * gravity * start.gap)),
      first_impact_((start.velocity + impact_speed_) / gravity) {}

Height VerticalBounces::At(double t) const {
  if (t <= first_impact_) {
    return {start_.gap + t * (start_.velocity - gravity_ * t / 2),
            start_.velocity - gravity_ * t};
  }
  if (t >= total_time()) return {0, 0};
  double since = t - first_impact_;
  const double flight = 2 * impact_speed_ * restitution_ / gravity_;
  double speed = impact_speed_ * restitution_;
  if (restitution_ == 1) {
    since = std::fmod(since, flight);
  } else {
    // The n-th flight begins flight (1 − eⁿ)/(1 − e) after the first.
    const double left = 1 - since * (1 - restitution_) / flight;
    const double n = std::floor(std::log(left) / std::log(restitution_));
    const double decay = std::pow(restitution_, n);
    since -= flight * (1 - decay) / (1 - restitution_);
    speed *= decay;
  }
  return {since * (speed - gravity_ * since / 2), speed - gravity_ * since};
}

double VerticalBounces::total_time() const {
  if (restitution_ == 1) return std::numeric_limits<double>::infinity();
  return first_impact_ +
         2 * impact_speed_ * restitution_ / (gravity_ * (1 - restitution_));
}

void SteppedBounces::Step() {
  const double v = state.velocity;
  const double fallen = v - gravity * dt;
  const bool touches =
      seen == ContactSeen::kTouching ? state.gap <= 0 : state.gap + dt * fallen < 0;
  double next = fallen;
  if (touches && rule == BounceRule::kStartOfStep)
    next = std::max(fallen, -restitution * std::min(v, 0.0));
  if (touches && rule == BounceRule::kAfterGravity && fallen < 0)
    next = -restitution * fallen;
  state.velocity = next;
  state.gap += dt * next;
}

}  // namespace touchstone
