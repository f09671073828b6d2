#include "engine/dynamics/broad_phase/broad_phase.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "engine/dynamics/body/free_flight.h"

namespace cookbook {
namespace {

/** Margin of a fat box on all sides, as a fraction of the radius of the body: wide enough
 that a body at rest stays inside, narrow enough to give few false pairs. */
constexpr double kFatMargin = 0.05;

/** Number of steps for which a fat box is enlarged along the velocity. A query costs as
 much as keeping a hundred near pairs for a step. */
constexpr double kPredictedSteps = 16;
/** Limit of that enlargement, as a fraction of the radius: a fast body would otherwise
 have many false pairs. */
constexpr double kMaxPrediction = 1;

/** Relative enlargement of tight bounds for the rounding of poses, as a fraction of
 position and radius: greater than the tolerance of the narrow phase. */
constexpr double kRounding = 1e-12;

/** Minimum numbers of bodies and of queries for a parallel loop. */
constexpr std::size_t kMinParallelBodies = 128;
constexpr std::size_t kMinParallelQueries = 16;

Aabb Expanded(const Aabb& bounds, double by) {
  return {bounds.low.array() - by, bounds.high.array() + by};
}

/** Returns a finite box, which Aabb::Empty() does not overlap. */
Aabb Clamped(const Aabb& box) {
  constexpr double kFar = std::numeric_limits<double>::max();
  return {box.low.cwiseMax(-kFar), box.high.cwiseMin(kFar)};
}

/** Returns the fat box for a body that needs `bounds` and moves by `displacement_W` [m]
 per step. */
Aabb FatBoxFor(const RigidBody& body, const Aabb& bounds,
               const Eigen::Vector3d& displacement_W) {
  const double predicted = kPredictedSteps * displacement_W.norm();
  const double limit = kMaxPrediction * body.radius;
  const Eigen::Vector3d shift =
      (predicted > limit ? limit / predicted : 1) * kPredictedSteps * displacement_W;
  const Aabb fat = Expanded(bounds, kFatMargin * body.radius);
  return Clamped({fat.low + shift.cwiseMin(0), fat.high + shift.cwiseMax(0)});
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
  at_rest_.push_back(0);
  proxy.is_static = body.is_static();
  if (!body.collides || body.is_point) return;
  bounds_.back() = BoundsOf(body);
  // A static body needs no margin.
  proxy.fat = Clamped(
      Expanded(bounds_.back().bounds(), proxy.is_static ? 0 : kFatMargin * body.radius));
  proxy.collides = true;
  const int added = static_cast<int>(proxies_.size()) - 1;
  (proxy.is_static ? static_trees_ : dynamic_trees_).Insert(proxy.fat, added);
  added_.push_back(added);
}

void BroadPhase::FindEscapes(std::span<const RigidBody> bodies, double margin,
                             double ahead, ThreadPool& pool) {
  escapes_.Clear(pool.chunk_count());
  const auto look = [&](std::size_t i, std::vector<Escape>& escapes) {
    const Proxy& proxy = proxies_[i];
    const RigidBody& body = bodies[i];
    at_rest_[i] = body.is_static() ? 1 : 0;
    if (!proxy.collides || at_rest_[i] != 0) return;
    // The margin covers gravity; other forces move the body farther.
    const Eigen::Vector3d pushed_W =
        body.state.v_WB + ahead * body.inverse_mass * body.Force_W();
    bounds_[i] = BoundsOf(body);
    const Aabb bounds =
        Expanded(bounds_[i].bounds(), margin + MaxTravel(body, pushed_W, ahead));
    if (proxy.fat.Contains(bounds)) return;
    const Aabb fat = FatBoxFor(body, bounds, ahead * pushed_W);
    escapes.push_back({static_cast<int>(i), fat});
  };
  pool.ParallelForIndexed(proxies_.size(), kMinParallelBodies,
                          [&](std::size_t chunk, std::size_t begin, std::size_t end) {
                            for (std::size_t i = begin; i < end; ++i)
                              look(i, escapes_[chunk]);
                          });
}

void BroadPhase::MarkMoved(int body, const Aabb& before) {
  if (has_moved(body)) return;
  moved_.push_back(body);
  has_moved_[static_cast<std::size_t>(body)] = 1;
  proxy(body).before = before;
}

void BroadPhase::Update(std::span<const RigidBody> bodies, double margin, double ahead,
                        ThreadPool& pool, std::vector<std::pair<int, int>>& new_pairs) {
  for (const int body : moved_) {
    has_moved_[static_cast<std::size_t>(body)] = 0;
  }
  moved_.clear();
  for (const int body : added_) MarkMoved(body, Aabb::Empty());
  added_.clear();
  FindEscapes(bodies, margin, ahead, pool);
  escapes_.ForEach([&](const Escape& escape) {
    MarkMoved(escape.body, proxy(escape.body).fat);
    MoveProxy(escape.body, escape.fat);
  });

  scratch_.resize(pool.chunk_count());
  new_pairs_.Clear(pool.chunk_count());
  pool.ParallelForIndexed(moved_.size(), kMinParallelQueries,
                          [&](std::size_t chunk, std::size_t begin, std::size_t end) {
                            for (std::size_t k = begin; k < end; ++k) {
                              FindNewPairs(moved_[k], scratch_[chunk], new_pairs_[chunk]);
                            }
                          });
  new_pairs_.ForEach([&](const std::pair<int, int>& pair) { new_pairs.push_back(pair); });
}

void BroadPhase::MoveProxy(int body, const Aabb& fat) {
  proxy(body).fat = fat;
  dynamic_trees_.Remove(body);
  dynamic_trees_.Insert(fat, body);
}

template <class Found>
void BroadPhase::ForEachOverlap(int body, Scratch& scratch, const Found& found) const {
  const Proxy& own = proxy(body);
  for (const int other : dynamic_trees_.Query(own.fat, scratch.query)) {
    if (other != body) found(other);
  }
  if (own.is_static) return;
  for (const int other : static_trees_.Query(own.fat, scratch.query)) found(other);
}

void BroadPhase::FindNewPairs(int body, Scratch& scratch,
                              std::vector<std::pair<int, int>>& new_pairs) const {
  const Aabb& before = proxy(body).before;
  const auto first = static_cast<std::ptrdiff_t>(new_pairs.size());
  ForEachOverlap(body, scratch, [&](int other) {
    // A pair of two moved bodies is found by the one with the lesser index.
    if (has_moved(other) && other < body) return;
    if (before.Overlaps(has_moved(other) ? proxy(other).before : proxy(other).fat)) {
      return;
    }
    new_pairs.push_back(std::minmax(body, other));
  });
  // The order of contacts affects the convergence of the solver. Hence the order in which
  // bodies were added, not that of the tree.
  std::sort(new_pairs.begin() + first, new_pairs.end());
}

void BroadPhase::EnlargeProxy(int index, const RigidBody& body, double reach,
                              std::vector<std::pair<int, int>>& new_pairs,
                              std::vector<int>& candidates) {
  const Aabb now = Clamped(Expanded(BoundsOf(body).bounds(), reach));
  const Aabb before = proxy(index).fat;
  if (!before.Contains(now)) MoveProxy(index, Union(before, now));
  const auto first_new_pair = static_cast<std::ptrdiff_t>(new_pairs.size());
  const auto first_candidate = static_cast<std::ptrdiff_t>(candidates.size());
  ForEachOverlap(index, scratch_[0], [&](int other) {
    const Aabb& fat = proxy(other).fat;
    if (!before.Overlaps(fat)) new_pairs.push_back(std::minmax(index, other));
    if (now.Overlaps(fat)) candidates.push_back(other);
  });
  std::sort(new_pairs.begin() + first_new_pair, new_pairs.end());
  std::sort(candidates.begin() + first_candidate, candidates.end());
}

void BroadPhase::NumberInSpatialOrder(std::vector<int>& number) const {
  number.assign(proxies_.size(), 0);
  int last = 0;
  dynamic_trees_.ForEach(
      [&](int body) { number[static_cast<std::size_t>(body)] = ++last; });
}

}  // namespace cookbook
