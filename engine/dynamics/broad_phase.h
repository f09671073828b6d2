#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/dynamics/aabb_tree.h"
#include "engine/dynamics/rigid_body.h"

namespace cookbook {

/** A set of pairs of body indices that allocates only while it grows. */
class PairSet {
 public:
  /** Returns whether the pair was not in the set. */
  bool Insert(int a, int b);
  void Erase(int a, int b);

 private:
  static std::uint64_t Key(int a, int b);
  std::size_t Home(std::uint64_t key) const;
  void Grow();

  /** Open addressing with linear probing; 0 is a free place. */
  std::vector<std::uint64_t> places_;
  std::size_t size_ = 0;
};

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
              std::vector<std::pair<int, int>>& appeared);

  /** Appends to `met` what the moving body `index` may meet that is at `body` now and
   gets no farther than `reach` [m], and to `appeared` the pairs that become near by it.
 */
  void Widen(int index, const RigidBody& body, double reach,
             std::vector<std::pair<int, int>>& appeared, std::vector<int>& met);

  /** Whether a pair that was near before the last Update() still is. */
  bool AreStillNear(int a, int b) const;

  /** Numbers the bodies so that those near each other mostly have numbers near each
   other; 0 for what is static or collides with nothing. */
  void NumberByPlace(std::vector<int>& number);

  /** Forgets a pair that is no longer near. */
  void Forget(int a, int b) { pairs_.Erase(a, b); }

 private:
  struct Proxy {
    Aabb wide;
    int leaf = -1;  ///< −1: does not collide.
    bool is_static = false;
    bool is_new = true;
  };

  void SetWide(int body, const Aabb& wide);
  /** Appends the pairs of a body that have become near. */
  void Pair(int body, std::vector<std::pair<int, int>>& appeared);

  AabbTree moving_;
  AabbTree resting_;  ///< Static bodies: they meet moving ones only.
  std::vector<Proxy> proxies_;
  std::vector<int> moved_;
  /** Of each body: 1 where it has got another wide box in the last Update(). */
  std::vector<char> has_moved_;
  PairSet pairs_;
};

/** Returns the box that holds `body`; of a half-space all of the world, as far as its
 axes tell no more. */
Aabb BoundsOf(const RigidBody& body);

}  // namespace cookbook
