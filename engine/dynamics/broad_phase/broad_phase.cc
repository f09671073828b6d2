#include "engine/dynamics/broad_phase/broad_phase.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "engine/dynamics/body/free_flight.h"

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

/** Bodies below which it does not pay to share them out, and of those that look anew for
 who is near. */
constexpr std::size_t kFewBodies = 128;
constexpr std::size_t kFewMoved = 16;

Aabb Widened(const Aabb& bounds, double by) {
  return {bounds.low.array() - by, bounds.high.array() + by};
}

/** Returns a box that ends where numbers do, so that Aabb::Nothing() does not overlap it.
 */
Aabb Bounded(const Aabb& box) {
  constexpr double kFar = std::numeric_limits<double>::max();
  return {box.low.cwiseMax(-kFar), box.high.cwiseMin(kFar)};
}

/** Returns the box for a body that needs `bounds` and moves by `way_W` in a step. [m] */
Aabb WideFor(const RigidBody& body, const Aabb& bounds, const Eigen::Vector3d& way_W) {
  const double far = kSteps * way_W.norm();
  const double farthest = kFarthest * body.radius;
  const Eigen::Vector3d shift = (far > farthest ? farthest / far : 1) * kSteps * way_W;
  const Aabb wide = Widened(bounds, kWider * body.radius);
  return Bounded({wide.low + shift.cwiseMin(0), wide.high + shift.cwiseMax(0)});
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
  rests_.push_back(0);
  proxy.is_static = body.is_static();
  if (!body.collides || body.is_point) return;
  bounds_.back() = BoundsOf(body);
  // What stands still needs no more.
  proxy.wide = Bounded(
      Widened(bounds_.back().bounds(), proxy.is_static ? 0 : kWider * body.radius));
  proxy.takes_part = true;
  const int added = static_cast<int>(proxies_.size()) - 1;
  (proxy.is_static ? resting_ : moving_).Insert(proxy.wide, added);
  added_.push_back(added);
}

void BroadPhase::FindLeaving(std::span<const RigidBody> bodies, double margin,
                             double ahead, ThreadPool& pool) {
  leaving_.Clear(pool.chunk_count());
  const auto look = [&](std::size_t i, std::vector<Leaving>& leaving) {
    const Proxy& proxy = proxies_[i];
    const RigidBody& body = bodies[i];
    rests_[i] = body.is_static() ? 1 : 0;
    if (!proxy.takes_part || rests_[i] != 0) return;
    // The margin is as wide as gravity needs; other forces load it farther.
    const Eigen::Vector3d pushed_W =
        body.state.v_WB + ahead * body.inverse_mass * body.Force_W();
    bounds_[i] = BoundsOf(body);
    const Aabb bounds =
        Widened(bounds_[i].bounds(), margin + MaxTravel(body, pushed_W, ahead));
    if (proxy.wide.Contains(bounds)) return;
    const Aabb wide = WideFor(body, bounds, ahead * pushed_W);
    leaving.push_back({static_cast<int>(i), wide});
  };
  pool.ParallelForIndexed(proxies_.size(), kFewBodies,
                          [&](std::size_t chunk, std::size_t begin, std::size_t end) {
                            for (std::size_t i = begin; i < end; ++i)
                              look(i, leaving_[chunk]);
                          });
}

void BroadPhase::NoteMoved(int body, const Aabb& before) {
  if (has_moved(body)) return;
  moved_.push_back(body);
  has_moved_[static_cast<std::size_t>(body)] = 1;
  proxy(body).before = before;
}

void BroadPhase::Update(std::span<const RigidBody> bodies, double margin, double ahead,
                        ThreadPool& pool, std::vector<std::pair<int, int>>& appeared) {
  for (const int body : moved_) {
    has_moved_[static_cast<std::size_t>(body)] = 0;
  }
  moved_.clear();
  for (const int body : added_) NoteMoved(body, Aabb::Nothing());
  added_.clear();
  FindLeaving(bodies, margin, ahead, pool);
  leaving_.ForEach([&](const Leaving& leaving) {
    NoteMoved(leaving.body, proxy(leaving.body).wide);
    SetWide(leaving.body, leaving.wide);
  });

  rooms_.resize(pool.chunk_count());
  appearing_.Clear(pool.chunk_count());
  pool.ParallelForIndexed(moved_.size(), kFewMoved,
                          [&](std::size_t chunk, std::size_t begin, std::size_t end) {
                            for (std::size_t k = begin; k < end; ++k) {
                              Pair(moved_[k], rooms_[chunk], appearing_[chunk]);
                            }
                          });
  appearing_.ForEach([&](const std::pair<int, int>& pair) { appeared.push_back(pair); });
}

void BroadPhase::SetWide(int body, const Aabb& wide) {
  proxy(body).wide = wide;
  moving_.Remove(body);
  moving_.Insert(wide, body);
}

template <class Found>
void BroadPhase::ForEachNear(int body, Room& room, const Found& found) const {
  const Proxy& own = proxy(body);
  for (const int other : moving_.Query(own.wide, room.tree)) {
    if (other != body) found(other);
  }
  if (own.is_static) return;
  for (const int other : resting_.Query(own.wide, room.tree)) found(other);
}

void BroadPhase::Pair(int body, Room& room,
                      std::vector<std::pair<int, int>>& appeared) const {
  const Aabb& before = proxy(body).before;
  const auto first = static_cast<std::ptrdiff_t>(appeared.size());
  ForEachNear(body, room, [&](int other) {
    // Of two that have moved the first finds the pair.
    if (has_moved(other) && other < body) return;
    if (before.Overlaps(has_moved(other) ? proxy(other).before : proxy(other).wide)) {
      return;
    }
    appeared.push_back(std::minmax(body, other));
  });
  // How contacts are ordered decides how soon they are solved: as bodies were added, not
  // as the tree happens to have them.
  std::sort(appeared.begin() + first, appeared.end());
}

void BroadPhase::Widen(int index, const RigidBody& body, double reach,
                       std::vector<std::pair<int, int>>& appeared,
                       std::vector<int>& met) {
  const Aabb now = Bounded(Widened(BoundsOf(body).bounds(), reach));
  const Aabb before = proxy(index).wide;
  if (!before.Contains(now)) SetWide(index, Union(before, now));
  const auto first_appeared = static_cast<std::ptrdiff_t>(appeared.size());
  const auto first_met = static_cast<std::ptrdiff_t>(met.size());
  ForEachNear(index, rooms_[0], [&](int other) {
    const Aabb& wide = proxy(other).wide;
    if (!before.Overlaps(wide)) appeared.push_back(std::minmax(index, other));
    if (now.Overlaps(wide)) met.push_back(other);
  });
  std::sort(appeared.begin() + first_appeared, appeared.end());
  std::sort(met.begin() + first_met, met.end());
}

void BroadPhase::NumberByPlace(std::vector<int>& number) const {
  number.assign(proxies_.size(), 0);
  int last = 0;
  moving_.ForEach([&](int body) { number[static_cast<std::size_t>(body)] = ++last; });
}

}  // namespace cookbook
