#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

namespace cookbook {

/** A union-find of the numbers 0, 1, 2, …, with path halving. The root of a set is its
 least element, not that of the larger tree, so that it does not depend on the order in
 which sets were united. */
class UnionFind {
 public:
  /** Puts each of the first `count` numbers into a set of its own. */
  void Reset(std::size_t count) {
    parent_.resize(count);
    std::iota(parent_.begin(), parent_.end(), 0);
  }

  /** Returns the root of the set that contains `one`. */
  int Find(int one) {
    while (At(one) != one) {
      // Path halving (Tarjan & van Leeuwen, J. ACM 31, 1984).
      At(one) = At(At(one));
      one = At(one);
    }
    return one;
  }

  /** Unites the sets that contain `a` and `b`. */
  void Unite(int a, int b) {
    const auto [first, second] = std::minmax({Find(a), Find(b)});
    At(second) = first;
  }

  /** Returns the root of each number's set. Valid until the next call of a member
   function. */
  std::span<const int> Roots() {
    // A parent is less than its child, and hence already points to the root.
    for (int& parent : parent_) parent = At(parent);
    return parent_;
  }

 private:
  int& At(int one) { return parent_[static_cast<std::size_t>(one)]; }

  std::vector<int>
      parent_;  ///< Indexed by number: one of the same set; a root is its own.
};

}  // namespace cookbook
