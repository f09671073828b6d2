#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/dynamics/body/rigid_body.h"
#include "engine/dynamics/broad_phase/aabb.h"
#include "engine/dynamics/broad_phase/aabb_tree.h"
#include "engine/dynamics/broad_phase/aabb_trees_by_size.h"
#include "engine/dynamics/broad_phase/rounded_box.h"
#include "engine/threads/per_chunk.h"
#include "engine/threads/thread_pool.h"

namespace cookbook {

/** Finds the pairs of bodies that are near each other.

 Every body has a box along the world's axes that is wider than it needs; only a body that
 leaves its box is looked at again. A pair is near as long as the wide boxes overlap. */
class BroadPhase {
 public:
  /** Adds the body of the next index. Points, and bodies that do not collide, take part
   in nothing. */
  void Add(const RigidBody& body);

  /** Looks at all bodies anew and appends the pairs that have become near, the lesser
   index first. `margin`: how far contacts reach beyond the shapes. [m] Pairs that may
   meet within `ahead` [s], as the bodies move now, are near as well. */
  void Update(std::span<const RigidBody> bodies, double margin, double ahead,
              ThreadPool& pool, std::vector<std::pair<int, int>>& appeared);

  /** Appends to `met` what the moving body `index` may meet that is at `body` now and
   gets no farther than `reach` [m], and to `appeared` the pairs that become near by it,
   both by index. */
  void Widen(int index, const RigidBody& body, double reach,
             std::vector<std::pair<int, int>>& appeared, std::vector<int>& met);

  /** Whether a pair that was near before the last Update() still is. */
  bool AreStillNear(int a, int b) const {
    return (!has_moved(a) && !has_moved(b)) || proxy(a).wide.Overlaps(proxy(b).wide);
  }

  /** Calls `visit(body)` for each body that has got another wide box in the last
   * Update().
   */
  template <class Visit>
  void ForEachMoved(const Visit& visit) const {
    for (const int body : moved_) visit(body);
  }

  /** Whether a body was static, or asleep, in the last Update(). */
  bool IsAtRest(int body) const { return rests_[static_cast<std::size_t>(body)] != 0; }

  /** Returns a bound of how far two bodies were apart in the last Update(). [m] */
  double GapOf(int a, int b) const {
    return cookbook::GapOf(bounds_[static_cast<std::size_t>(a)],
                           bounds_[static_cast<std::size_t>(b)]);
  }

  /** Numbers the bodies so that those near each other mostly have numbers near each
   other; 0 for what is static or collides with nothing. */
  void NumberByPlace(std::vector<int>& number) const;

 private:
  struct alignas(64) Proxy {
    Aabb wide;
    /** That before the last Update(), where `has_moved_`; of a new body it holds nothing.
     */
    Aabb before;
    bool takes_part = false;  ///< False: does not collide.
    bool is_static = false;
  };
  /** A body that has left its wide box, and the next one. */
  struct Leaving {
    int body;
    Aabb wide;
  };
  /** Room of one thread, in lines of a cache of its own. */
  struct alignas(64) Room {
    AabbTree::Room tree;
  };

  Proxy& proxy(int body) { return proxies_[static_cast<std::size_t>(body)]; }
  const Proxy& proxy(int body) const { return proxies_[static_cast<std::size_t>(body)]; }
  bool has_moved(int body) const {
    return has_moved_[static_cast<std::size_t>(body)] != 0;
  }

  /** Brings bounds_ up to date, and notes who leaves its wide box. */
  void FindLeaving(std::span<const RigidBody> bodies, double margin, double ahead,
                   ThreadPool& pool);
  /** Notes that the wide box of a body is another now than `before`. */
  void NoteMoved(int body, const Aabb& before);
  void SetWide(int body, const Aabb& wide);
  /** Calls `found(other)` for all that the wide box of a body overlaps. */
  template <class Found>
  void ForEachNear(int body, Room& room, const Found& found) const;
  /** Appends the pairs of a body that has moved which have become near. */
  void Pair(int body, Room& room, std::vector<std::pair<int, int>>& appeared) const;

  AabbTreesBySize moving_;
  AabbTreesBySize resting_;  ///< Static bodies: they meet moving ones only.
  std::vector<Proxy> proxies_;
  std::vector<RoundedBox> bounds_;  ///< Of each body: what holds it.
  std::vector<int> added_;          ///< Since the last Update().
  std::vector<int> moved_;
  /** Of each body: 1 where it has got another wide box in the last Update(). */
  std::vector<char> has_moved_;
  std::vector<char> rests_;  ///< Of each body: 1 where it is static, or asleep.
  PerChunk<Leaving> leaving_;
  PerChunk<std::pair<int, int>> appearing_;
  std::vector<Room> rooms_{1};
};

/** Returns the box that holds `body`; of a half-space all of the world, as far as its
 axes tell no more. */
RoundedBox BoundsOf(const RigidBody& body);

}  // namespace cookbook
