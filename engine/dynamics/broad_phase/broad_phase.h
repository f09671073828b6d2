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

/** A broad phase with fat AABBs in dynamic AABB trees. It finds the pairs of bodies that
 are near each other.

 Only a body that leaves its fat box is queried again. A pair is near as long as its fat
 boxes overlap. */
class BroadPhase {
 public:
  /** Adds the body with the next index. Points, and bodies that do not collide, are in no
   pair. */
  void Add(const RigidBody& body);

  /** Updates all bodies and appends the pairs that have become near, each with the lesser
   index first. `margin`: greatest speculative margin of a body. [m] Pairs that may
   collide within `ahead` [s] at the current velocities are near as well. */
  void Update(std::span<const RigidBody> bodies, double margin, double ahead,
              ThreadPool& pool, std::vector<std::pair<int, int>>& new_pairs);

  /** Enlarges the fat box of the moving body `index`, which is at `body` now and travels
   no farther than `reach` [m]. Appends the pairs that become near to `new_pairs`, and all
   bodies that it may touch to `candidates`, both sorted by index. */
  void EnlargeProxy(int index, const RigidBody& body, double reach,
                    std::vector<std::pair<int, int>>& new_pairs,
                    std::vector<int>& candidates);

  /** Whether a pair that was near before the last Update() is still near. */
  bool AreStillNear(int a, int b) const {
    return (!has_moved(a) && !has_moved(b)) || proxy(a).fat.Overlaps(proxy(b).fat);
  }

  /** Calls `visit(body)` for each body whose fat box the last Update() changed. */
  template <class Visit>
  void ForEachMoved(const Visit& visit) const {
    for (const int body : moved_) visit(body);
  }

  /** Whether a body was static or asleep in the last Update(). */
  bool IsAtRest(int body) const { return at_rest_[static_cast<std::size_t>(body)] != 0; }

  /** Returns a lower bound on the distance of two bodies in the last Update(). [m] */
  double DistanceBound(int a, int b) const {
    return Distance(bounds_[static_cast<std::size_t>(a)],
                    bounds_[static_cast<std::size_t>(b)]);
  }

  /** Numbers the bodies in spatial order: neighbours mostly have close numbers. The
   number of a body that is static or does not collide is 0. */
  void NumberInSpatialOrder(std::vector<int>& number) const;

 private:
  struct alignas(64) Proxy {
    Aabb fat;
    /** The fat box before the last Update(), if `has_moved_`; empty for a new body. */
    Aabb before;
    bool collides = false;  ///< False: not in a tree.
    bool is_static = false;
  };
  /** A body that has left its fat box, and its next one. */
  struct Escape {
    int body;
    Aabb fat;
  };
  /** Scratch memory of one chunk. Fills whole cache lines, against false sharing. */
  struct alignas(64) Scratch {
    AabbTree::Scratch query;
  };

  Proxy& proxy(int body) { return proxies_[static_cast<std::size_t>(body)]; }
  const Proxy& proxy(int body) const { return proxies_[static_cast<std::size_t>(body)]; }
  bool has_moved(int body) const {
    return has_moved_[static_cast<std::size_t>(body)] != 0;
  }

  /** Updates `bounds_`, and records the bodies that leave their fat boxes. */
  void FindEscapes(std::span<const RigidBody> bodies, double margin, double ahead,
                   ThreadPool& pool);
  /** Records that the fat box of a body, which was `before`, changes. */
  void MarkMoved(int body, const Aabb& before);
  void MoveProxy(int body, const Aabb& fat);
  /** Calls `found(other)` for each body whose fat box overlaps that of `body`. */
  template <class Found>
  void ForEachOverlap(int body, Scratch& scratch, const Found& found) const;
  /** Appends the new pairs of a body whose fat box has changed. */
  void FindNewPairs(int body, Scratch& scratch,
                    std::vector<std::pair<int, int>>& new_pairs) const;

  AabbTreesBySize dynamic_trees_;
  AabbTreesBySize static_trees_;  ///< Static bodies are not paired with each other.
  std::vector<Proxy> proxies_;
  std::vector<RoundedBox> bounds_;  ///< Indexed by body: tight bounds.
  std::vector<int> added_;          ///< Bodies added since the last Update().
  std::vector<int> moved_;          ///< Bodies whose fat box the last Update() changed.
  std::vector<char> has_moved_;     ///< Indexed by body: 1 if in `moved_`.
  std::vector<char> at_rest_;       ///< Indexed by body: 1 if static or asleep.
  PerChunk<Escape> escapes_;
  PerChunk<std::pair<int, int>> new_pairs_;
  std::vector<Scratch> scratch_{1};
};

/** Returns the tight bounds of `body`. Those of a half-space are infinite, except on the
 side of its surface if that is perpendicular to an axis. */
RoundedBox BoundsOf(const RigidBody& body);

}  // namespace cookbook
