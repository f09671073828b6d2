#include "engine/dynamics/broad_phase.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "engine/dynamics/body_flight.h"

namespace cookbook {
namespace {

/** How much wider than needed the box of a body is on all sides, as a share of its
 radius: wide enough that a body that rests stays inside, narrow enough that few strangers
 are in it. */
constexpr double kWider = 0.05;

/** A box is made for so many steps of a body that goes on as it moves now: to look for
 who is near costs as much as to keep a hundred near pairs for a step. */
constexpr double kSteps = 16;
/** As long as it gets no farther than this share of its radius: what is fast would have
 many strangers on its way. */
constexpr double kFarthest = 1;

/** What bounds are wider by than a body because its pose is rounded, as a share of where
 it is and how large: more than the narrow phase allows for. */
constexpr double kRounding = 1e-12;

Aabb Widened(const Aabb& bounds, double by) {
  return {bounds.low.array() - by, bounds.high.array() + by};
}

/** Returns the box for a body that needs `bounds` and moves by `way_W` in a step. [m] */
Aabb WideFor(const RigidBody& body, const Aabb& bounds, const Eigen::Vector3d& way_W) {
  const double far = kSteps * way_W.norm();
  const double farthest = kFarthest * body.radius;
  const Eigen::Vector3d shift = (far > farthest ? farthest / far : 1) * kSteps * way_W;
  const Aabb wide = Widened(bounds, kWider * body.radius);
  return {wide.low + shift.cwiseMin(0), wide.high + shift.cwiseMax(0)};
}

/** Returns a box that overlaps no other. */
Aabb Nothing() {
  const Eigen::Vector3d far =
      Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());
  return {far, -far};
}

}  // namespace

RoundedBox BoundsOf(const RigidBody& body) {
  const Eigen::Vector3d& p = body.state.p_WB;
  const double rounding = kRounding * (p.lpNorm<1>() + body.radius);
  if (const auto* box = std::get_if<Box>(&body.shape)) {
    const Eigen::Vector3d reach = body.R_WB.cwiseAbs() * box->half_extents;
    return {{p - reach, p + reach}, rounding};
  }
  if (const auto* sphere = std::get_if<Sphere>(&body.shape)) {
    return {{p, p}, sphere->radius + rounding};
  }
  Eigen::Vector3d low = Eigen::Vector3d::Constant(-std::numeric_limits<double>::max());
  Eigen::Vector3d high = -low;
  const Eigen::Vector3d n = body.R_WB.col(2);
  for (int k = 0; k < 3; ++k) {
    if (n[k] == 1) high[k] = p[k];
    if (n[k] == -1) low[k] = p[k];
  }
  return {{low, high}, rounding};
}

void BroadPhase::Add(const RigidBody& body) {
  Proxy& proxy = proxies_.emplace_back();
  bounds_.emplace_back();
  has_moved_.push_back(0);
  proxy.is_static = body.is_static();
  if (!body.collides || body.is_point()) return;
  bounds_.back() = BoundsOf(body);
  // What stands still needs no more.
  proxy.wide =
      Widened(bounds_.back().bounds(), proxy.is_static ? 0 : kWider * body.radius);
  proxy.leaf = (proxy.is_static ? resting_ : moving_)
                   .Insert(proxy.wide, static_cast<int>(proxies_.size()) - 1);
}

void BroadPhase::Update(std::span<const RigidBody> bodies, double margin, double ahead,
                        std::vector<std::pair<int, int>>& appeared) {
  for (const int body : moved_) {
    has_moved_[static_cast<std::size_t>(body)] = 0;
  }
  moved_.clear();
  for (std::size_t i = 0; i < proxies_.size(); ++i) {
    Proxy& proxy = proxies_[i];
    if (proxy.leaf < 0) continue;
    const bool is_new = std::exchange(proxy.is_new, false);
    if (is_new) {
      moved_.push_back(static_cast<int>(i));
      has_moved_[i] = 1;
      proxy.before = Nothing();
    }
    if (bodies[i].is_static()) continue;  // Or asleep.
    // The margin is as wide as gravity needs; other forces pull it farther.
    const RigidBody& body = bodies[i];
    const Eigen::Vector3d pushed_W =
        body.state.v_WB +
        ahead * body.inverse_mass * (body.force_W + body.applied_force_W);
    bounds_[i] = BoundsOf(body);
    const Aabb bounds =
        Widened(bounds_[i].bounds(), margin + Reach(body, pushed_W, ahead));
    if (proxy.wide.Contains(bounds)) continue;
    if (!is_new) {
      moved_.push_back(static_cast<int>(i));
      has_moved_[i] = 1;
      proxy.before = proxy.wide;
    }
    SetWide(static_cast<int>(i), WideFor(body, bounds, ahead * pushed_W));
  }
  for (const int body : moved_) Pair(body, appeared);
}

void BroadPhase::SetWide(int body, const Aabb& wide) {
  proxy(body).wide = wide;
  moving_.Remove(proxy(body).leaf);
  proxy(body).leaf = moving_.Insert(wide, body);
}

template <class Found>
void BroadPhase::ForEachNear(int body, const Found& found) {
  const Proxy& own = proxy(body);
  moving_.Query(own.wide, [&](int other, const Aabb& wide) {
    if (other != body) found(other, wide);
  });
  if (!own.is_static) resting_.Query(own.wide, found);
}

void BroadPhase::Pair(int body, std::vector<std::pair<int, int>>& appeared) {
  const Aabb& before = proxy(body).before;
  ForEachNear(body, [&](int other, const Aabb& wide) {
    // Of two that have moved the first finds the pair.
    if (has_moved(other) && other < body) return;
    if (before.Overlaps(has_moved(other) ? proxy(other).before : wide)) return;
    appeared.push_back(std::minmax(body, other));
  });
}

void BroadPhase::Widen(int index, const RigidBody& body, double reach,
                       std::vector<std::pair<int, int>>& appeared,
                       std::vector<int>& met) {
  const Aabb bounds = Widened(BoundsOf(body).bounds(), reach);
  const Aabb before = proxy(index).wide;
  if (!before.Contains(bounds)) {
    SetWide(index, Union(before, bounds));
    ForEachNear(index, [&](int other, const Aabb& wide) {
      if (!before.Overlaps(wide)) appeared.push_back(std::minmax(index, other));
    });
  }
  const auto found = [&](int other, const Aabb&) {
    if (other != index) met.push_back(other);
  };
  moving_.Query(bounds, found);
  resting_.Query(bounds, found);
}

void BroadPhase::NumberByPlace(std::vector<int>& number) {
  number.assign(proxies_.size(), 0);
  int last = 0;
  moving_.ForEachLeaf([&](int body) { number[static_cast<std::size_t>(body)] = ++last; });
}

bool BroadPhase::AreStillNear(int a, int b) const {
  return (!has_moved(a) && !has_moved(b)) || proxy(a).wide.Overlaps(proxy(b).wide);
}

}  // namespace cookbook
