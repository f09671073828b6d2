#include "engine/dynamics/broad_phase.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "engine/dynamics/body_flight.h"

namespace cookbook {
namespace {

/** How much wider than the body its box is, as a share of its radius: wide enough that a
 body that rests or creeps stays inside, narrow enough that few strangers are in it. */
constexpr double kWider = 0.1;

Aabb Widened(const Aabb& bounds, double by) {
  return {bounds.low.array() - by, bounds.high.array() + by};
}

}  // namespace

std::uint64_t PairSet::Key(int a, int b) {
  // One is added so that no pair is 0, which marks a free place.
  return (static_cast<std::uint64_t>(static_cast<std::uint32_t>(a)) << 32 |
          static_cast<std::uint32_t>(b)) +
         1;
}

std::size_t PairSet::Home(std::uint64_t key) const {
  // Fibonacci hashing: the high bits of the product depend on all bits of the key.
  const std::uint64_t mixed = (key ^ key >> 32) * 0x9e3779b97f4a7c15u;
  return static_cast<std::size_t>(mixed >> 20) & (places_.size() - 1);
}

void PairSet::Grow() {
  std::vector<std::uint64_t> old(std::max<std::size_t>(64, 2 * places_.size()), 0);
  old.swap(places_);
  for (const std::uint64_t key : old) {
    if (key == 0) continue;
    std::size_t place = Home(key);
    while (places_[place] != 0) place = (place + 1) & (places_.size() - 1);
    places_[place] = key;
  }
}

bool PairSet::Insert(int a, int b) {
  if (2 * (size_ + 1) > places_.size()) Grow();
  const std::uint64_t key = Key(a, b);
  std::size_t place = Home(key);
  for (; places_[place] != 0; place = (place + 1) & (places_.size() - 1)) {
    if (places_[place] == key) return false;
  }
  places_[place] = key;
  ++size_;
  return true;
}

void PairSet::Erase(int a, int b) {
  const std::uint64_t key = Key(a, b);
  const std::size_t mask = places_.size() - 1;
  std::size_t hole = Home(key);
  while (places_[hole] != key) {
    if (places_[hole] == 0) return;
    hole = (hole + 1) & mask;
  }
  // Moves back what was pushed past the hole, so that no search ends in it.
  for (std::size_t next = (hole + 1) & mask; places_[next] != 0;
       next = (next + 1) & mask) {
    const std::size_t home = Home(places_[next]);
    if (((next - home) & mask) >= ((next - hole) & mask)) {
      places_[hole] = places_[next];
      hole = next;
    }
  }
  places_[hole] = 0;
  --size_;
}

Aabb BoundsOf(const RigidBody& body) {
  const Eigen::Vector3d& p = body.state.p_WB;
  if (const auto* box = std::get_if<Box>(&body.shape)) {
    const Eigen::Vector3d reach = body.R_WB.cwiseAbs() * box->half_extents;
    return {p - reach, p + reach};
  }
  if (const auto* sphere = std::get_if<Sphere>(&body.shape)) {
    return {p.array() - sphere->radius, p.array() + sphere->radius};
  }
  Eigen::Vector3d low = Eigen::Vector3d::Constant(-std::numeric_limits<double>::max());
  Eigen::Vector3d high = -low;
  const Eigen::Vector3d n = body.R_WB.col(2);
  for (int k = 0; k < 3; ++k) {
    if (n[k] == 1) high[k] = p[k];
    if (n[k] == -1) low[k] = p[k];
  }
  return {low, high};
}

void BroadPhase::Add(const RigidBody& body) {
  Proxy& proxy = proxies_.emplace_back();
  has_moved_.push_back(0);
  proxy.is_static = body.is_static();
  if (!body.collides || body.is_point()) return;
  proxy.wide = Widened(BoundsOf(body), kWider * body.radius);
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
    if (bodies[i].is_static()) {  // Or asleep.
      if (is_new) moved_.push_back(static_cast<int>(i));
      continue;
    }
    // The margin is as wide as gravity needs; other forces pull it farther.
    const RigidBody& body = bodies[i];
    const Eigen::Vector3d pushed_W =
        body.state.v_WB +
        ahead * body.inverse_mass * (body.force_W + body.applied_force_W);
    const Aabb bounds = Widened(BoundsOf(body), margin + Reach(body, pushed_W, ahead));
    const bool leaves = !proxy.wide.Contains(bounds);
    if (!is_new && !leaves) continue;
    moved_.push_back(static_cast<int>(i));
    if (!leaves) continue;
    SetWide(static_cast<int>(i), Widened(bounds, kWider * body.radius));
    has_moved_[i] = 1;
  }
  for (const int body : moved_) Pair(body, appeared);
}

void BroadPhase::SetWide(int body, const Aabb& wide) {
  Proxy& proxy = proxies_[static_cast<std::size_t>(body)];
  proxy.wide = wide;
  moving_.Remove(proxy.leaf);
  proxy.leaf = moving_.Insert(wide, body);
}

void BroadPhase::Pair(int body, std::vector<std::pair<int, int>>& appeared) {
  const Proxy& proxy = proxies_[static_cast<std::size_t>(body)];
  const auto found = [&](int other) {
    if (other == body) return;
    const auto [a, b] = std::minmax(body, other);
    if (pairs_.Insert(a, b)) appeared.emplace_back(a, b);
  };
  moving_.Query(proxy.wide, found);
  if (!proxy.is_static) resting_.Query(proxy.wide, found);
}

void BroadPhase::Widen(int index, const RigidBody& body, double reach,
                       std::vector<std::pair<int, int>>& appeared,
                       std::vector<int>& met) {
  const Aabb bounds = Widened(BoundsOf(body), reach);
  const Aabb& wide = proxies_[static_cast<std::size_t>(index)].wide;
  if (!wide.Contains(bounds)) {
    SetWide(index, Union(wide, bounds));
    Pair(index, appeared);
  }
  const auto found = [&](int other) {
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
  const auto A = static_cast<std::size_t>(a);
  const auto B = static_cast<std::size_t>(b);
  return (!has_moved_[A] && !has_moved_[B]) ||
         proxies_[A].wide.Overlaps(proxies_[B].wide);
}

}  // namespace cookbook
