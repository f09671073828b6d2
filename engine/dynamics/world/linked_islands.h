#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "engine/dynamics/contacts/contact_pair.h"
#include "engine/dynamics/joints/distance_joint.h"
#include "engine/dynamics/joints/spring.h"
#include "engine/dynamics/solver/union_find.h"

namespace cookbook {

/** The linked islands of a world: sets of moving bodies that contacts, joints and springs
 connect, with at least one joint or spring. */
class LinkedIslands {
 public:
  /** `linked`, indexed by body: whether a joint or spring is attached to it. */
  void Find(std::span<const PairSummary> pairs, std::span<const DistanceJoint> joints,
            std::span<const Spring> springs, std::span<const char> is_static,
            const std::vector<bool>& linked);

  /** Whether the body is in a linked island. */
  bool Contains(std::size_t body) const {
    return is_linked_[static_cast<std::size_t>(roots_[body])] != 0;
  }
  /** Returns the island of a moving body: the least index of its bodies. */
  std::size_t IslandOf(std::size_t body) const {
    return static_cast<std::size_t>(roots_[body]);
  }
  /** Returns the island of a pair with a moving body. */
  std::size_t IslandOf(const PairSummary& pair) const {
    return IslandOf(static_cast<std::size_t>(MovingBodyOf(pair)));
  }

  /** The summaries of the pairs in linked islands, and of the others. Both have the
   indices of all pairs; a pair of the other kind has no contacts in them. */
  std::span<const PairSummary> linked_pairs() const { return linked_pairs_; }
  std::span<const PairSummary> other_pairs() const { return other_pairs_; }

 private:
  int MovingBodyOf(const PairSummary& pair) const {
    return is_static_[static_cast<std::size_t>(pair.A)] != 0 ? pair.B : pair.A;
  }

  UnionFind islands_;
  std::span<const int> roots_;
  std::span<const char> is_static_;
  std::vector<char> is_linked_;  ///< Indexed by root.
  std::vector<PairSummary> linked_pairs_;
  std::vector<PairSummary> other_pairs_;
};

}  // namespace cookbook
