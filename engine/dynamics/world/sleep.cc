#include "engine/dynamics/world/sleep.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace cookbook {

void Sleep::Add(const RigidBody& body) {
  const int added = static_cast<int>(asleep_.size());
  inertias_.push_back({body.inverse_mass, body.inverse_moments});
  asleep_.push_back(false);
  slow_time_.push_back(0);
  min_slow_time_.push_back(0);
  next_in_island_.push_back(added);
}

void Sleep::Link(int A, int B) {
  if (A >= 0 && B >= 0) links_.emplace_back(A, B);
}

void Sleep::Wake(int body, std::span<RigidBody> bodies) {
  for (int current = body; IsAsleep(current);) {
    const auto i = static_cast<std::size_t>(current);
    bodies[i].inverse_mass = inertias_[i].inverse_mass;
    bodies[i].inverse_moments = inertias_[i].inverse_moments;
    asleep_[i] = false;
    slow_time_[i] = 0;
    current = next_in_island_[i];
    next_in_island_[i] = static_cast<int>(i);
  }
}

void Sleep::WakeNear(const ContactCache& cache, std::span<RigidBody> bodies) {
  const auto is_dynamic = [&](int body) {
    return !bodies[static_cast<std::size_t>(body)].is_static();
  };
  cache.ForEachNear([&](int A, int B) {
    if (IsAsleep(A) && is_dynamic(B)) Wake(A, bodies);
    if (IsAsleep(B) && is_dynamic(A)) Wake(B, bodies);
  });
}

bool Sleep::PutToSleep(const ContactCache& cache, const std::vector<bool>& driven,
                       const Settings& settings, double h, std::span<RigidBody> bodies) {
  const double sleep_after = *settings.sleep_after;
  islands_.Reset(bodies.size());
  bool any_slow_enough = false;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const RigidBody& body = bodies[i];
    if (body.is_static()) continue;
    const double speed = body.state.v_WB.norm() + body.radius * body.state.w_WB.norm();
    const bool is_slow = speed < settings.sleep_speed && !driven[i];
    slow_time_[i] = is_slow ? slow_time_[i] + h : 0;
    any_slow_enough |= slow_time_[i] >= sleep_after;
  }
  if (!any_slow_enough) return false;

  const auto join = [&](int A, int B) {
    const bool both_move = !bodies[static_cast<std::size_t>(A)].is_static() &&
                           !bodies[static_cast<std::size_t>(B)].is_static();
    if (both_move) islands_.Unite(A, B);
  };
  cache.ForEachNear(join);
  for (const auto& [A, B] : links_) join(A, B);

  std::fill(min_slow_time_.begin(), min_slow_time_.end(),
            std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    double& min_slow_time =
        min_slow_time_[static_cast<std::size_t>(islands_.Find(static_cast<int>(i)))];
    if (!bodies[i].is_static()) min_slow_time = std::min(min_slow_time, slow_time_[i]);
  }
  bool any_fell_asleep = false;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    RigidBody& body = bodies[i];
    const auto root = static_cast<std::size_t>(islands_.Find(static_cast<int>(i)));
    if (body.is_static() || min_slow_time_[root] < sleep_after) continue;
    body.state.v_WB.setZero();
    body.state.w_WB.setZero();
    body.inverse_mass = 0;
    body.inverse_moments.setZero();
    asleep_[i] = true;
    // The root has the smallest index of its island and comes first, as a circular list
    // of one element.
    if (i != root)
      next_in_island_[i] = std::exchange(next_in_island_[root], static_cast<int>(i));
    any_fell_asleep = true;
  }
  return any_fell_asleep;
}

}  // namespace cookbook
