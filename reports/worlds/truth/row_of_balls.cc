#include "reports/worlds/truth/row_of_balls.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace touchstone {
namespace {

/** Closing speed that counts as rounding, over the largest speed. [-] */
constexpr double kStill = 1e-12;

/** Bound for a series that never ends: e < 1 makes infinitely many ever weaker
 impacts. */
constexpr int kMostImpacts = 10000;

double Gap(const std::vector<RowBall>& balls, std::size_t i) {
  return balls[i + 1].x - balls[i].x - balls[i].radius - balls[i + 1].radius;
}

double Parting(const std::vector<RowBall>& balls, std::size_t i) {
  return balls[i + 1].v - balls[i].v;
}

double LargestSpeed(const std::vector<RowBall>& balls) {
  double speed = 0;
  for (const RowBall& ball : balls) speed = std::max(speed, std::abs(ball.v));
  return speed;
}

void Exchange(RowBall& a, RowBall& b, double impulse) {
  a.v -= impulse / a.mass;
  b.v += impulse / b.mass;
}

}  // namespace

RowOfBalls::RowOfBalls(std::vector<RowBall> balls, std::vector<double> restitution,
                       double touching, RowRule rule)
    : restitution_(std::move(restitution)), touching_(touching), rule_(rule) {
  moments_.push_back({0, balls, {0, 0}});
  double time = 0;
  for (int impacts = 0; impacts < kMostImpacts; ++impacts) {
    const std::vector<RowBall> before = balls;
    if (Resolve(balls)) {
      Past past = moments_.back().past;
      ++past.moments;
      for (std::size_t i = 0; i < balls.size(); ++i)
        past.change += std::abs(balls[i].v - before[i].v);
      moments_.push_back({time, balls, past});
    }
    double wait = std::numeric_limits<double>::infinity();
    const double still = kStill * LargestSpeed(balls);
    for (std::size_t i = 0; i + 1 < balls.size(); ++i) {
      if (Parting(balls, i) < -still)
        wait = std::min(wait, std::max(0.0, Gap(balls, i) / -Parting(balls, i)));
    }
    if (std::isinf(wait)) break;
    time += wait;
    for (RowBall& ball : balls) ball.x += wait * ball.v;
  }
}

bool RowOfBalls::Touches(const std::vector<RowBall>& balls, std::size_t i) const {
  return Gap(balls, i) <= touching_;
}

bool RowOfBalls::Resolve(std::vector<RowBall>& balls) const {
  return rule_ == RowRule::kSimultaneous ? ResolveAtOnce(balls) : ResolveByPairs(balls);
}

bool RowOfBalls::ResolveByPairs(std::vector<RowBall>& balls) const {
  const double still = kStill * LargestSpeed(balls);
  for (int impacts = 0; impacts < kMostImpacts; ++impacts) {
    std::size_t found = balls.size();
    for (std::size_t i = 0; i + 1 < balls.size(); ++i) {
      if (!Touches(balls, i) || Parting(balls, i) >= -still) continue;
      found = i;
      if (rule_ == RowRule::kFromFirst) break;
    }
    if (found == balls.size()) return impacts > 0;
    RowBall& a = balls[found];
    RowBall& b = balls[found + 1];
    Exchange(a, b, (1 + restitution_[found]) * (a.v - b.v) / (1 / a.mass + 1 / b.mass));
  }
  return true;
}

bool RowOfBalls::ResolveAtOnce(std::vector<RowBall>& balls) const {
  const double still = kStill * LargestSpeed(balls);
  std::vector<double> target(balls.size(), 0);
  bool any = false;
  for (std::size_t i = 0; i + 1 < balls.size(); ++i) {
    target[i] = -restitution_[i] * std::min(0.0, Parting(balls, i));
    any = any || (Touches(balls, i) && Parting(balls, i) < -still);
  }
  if (!any) return false;
  // Projected Gauss-Seidel to rounding: the chain's matrix is tridiagonal and positive.
  std::vector<double> impulse(balls.size(), 0);
  for (int iteration = 0; iteration < kMostImpacts; ++iteration) {
    double moved = 0;
    for (std::size_t i = 0; i + 1 < balls.size(); ++i) {
      if (!Touches(balls, i)) continue;
      RowBall& a = balls[i];
      RowBall& b = balls[i + 1];
      const double response = 1 / a.mass + 1 / b.mass;
      const double now = std::max(0.0, impulse[i] + (target[i] - (b.v - a.v)) / response);
      Exchange(a, b, now - impulse[i]);
      moved = std::max(moved, std::abs(now - impulse[i]) * response);
      impulse[i] = now;
    }
    if (moved <= kStill * still) break;
  }
  return true;
}

const RowOfBalls::Moment& RowOfBalls::Before(double t) const {
  std::size_t at = moments_.size() - 1;
  while (at > 0 && moments_[at].time > t) --at;
  return moments_[at];
}

std::vector<RowBall> RowOfBalls::At(double t) const {
  const Moment& moment = Before(t);
  std::vector<RowBall> balls = moment.balls;
  for (RowBall& ball : balls) ball.x += (t - moment.time) * ball.v;
  return balls;
}

RowOfBalls::Past RowOfBalls::PastAt(double t) const {
  return Before(t).past;
}

}  // namespace touchstone
