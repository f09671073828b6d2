#include "engine/dynamics/world/sleep.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace cookbook {

void Sleep::Add(const RigidBody& body) {
  const int added = static_cast<int>(asleep_.size());
  inertias_.push_back({body.inverse_mass, body.inverse_moments});
  asleep_.push_back(false);
  slow_for_.push_back(0);
  slowest_.push_back(0);
  next_.push_back(added);
}

void Sleep::Link(int A, int B) {
  if (A >= 0 && B >= 0) links_.emplace_back(A, B);
}

void Sleep::Wake(int body, std::span<RigidBody> bodies) {
  for (int one = body; IsAsleep(one);) {
    const auto i = static_cast<std::size_t>(one);
    bodies[i].inverse_mass = inertias_[i].inverse_mass;
    bodies[i].inverse_moments = inertias_[i].inverse_moments;
    asleep_[i] = false;
    slow_for_[i] = 0;
    one = next_[i];
    next_[i] = static_cast<int>(i);
  }
}

void Sleep::WakeNear(const ContactCache& cache, std::span<RigidBody> bodies) {
  const auto moves = [&](int body) {
    return !bodies[static_cast<std::size_t>(body)].is_static();
  };
  cache.ForEachNear([&](int A, int B) {
    if (IsAsleep(A) && moves(B)) Wake(A, bodies);
    if (IsAsleep(B) && moves(A)) Wake(B, bodies);
  });
}

bool Sleep::PutToSleep(const ContactCache& cache, const std::vector<bool>& driven,
                       const Settings& settings, double h, std::span<RigidBody> bodies) {
  const double enough = *settings.sleep_after;
  islands_.Reset(bodies.size());
  bool tired = false;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const RigidBody& body = bodies[i];
    if (body.is_static()) continue;
    const double speed = body.state.v_WB.norm() + body.radius * body.state.w_WB.norm();
    const bool is_slow = speed < settings.sleep_speed && !driven[i];
    slow_for_[i] = is_slow ? slow_for_[i] + h : 0;
    tired |= slow_for_[i] >= enough;
  }
  if (!tired) return false;

  const auto join = [&](int A, int B) {
    const bool both_move = !bodies[static_cast<std::size_t>(A)].is_static() &&
                           !bodies[static_cast<std::size_t>(B)].is_static();
    if (both_move) islands_.Unite(A, B);
  };
  cache.ForEachNear(join);
  for (const auto& [A, B] : links_) join(A, B);

  std::fill(slowest_.begin(), slowest_.end(), std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    double& slowest =
        slowest_[static_cast<std::size_t>(islands_.Find(static_cast<int>(i)))];
    if (!bodies[i].is_static()) slowest = std::min(slowest, slow_for_[i]);
  }
  bool any = false;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    RigidBody& body = bodies[i];
    const auto island = static_cast<std::size_t>(islands_.Find(static_cast<int>(i)));
    if (body.is_static() || slowest_[island] < enough) continue;
    body.state.v_WB.setZero();
    body.state.w_WB.setZero();
    body.inverse_mass = 0;
    body.inverse_moments.setZero();
    asleep_[i] = true;
    // Who stands for the island is the first of it, and a ring of one.
    if (i != island) next_[i] = std::exchange(next_[island], static_cast<int>(i));
    any = true;
  }
  return any;
}

}  // namespace cookbook
