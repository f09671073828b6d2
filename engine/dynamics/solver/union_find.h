#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

namespace cookbook {

/** Joins 0, 1, 2, … to sets. The least of a set stands for it. */
class UnionFind {
 public:
  /** Puts each of `count` into a set of its own. */
  void Reset(std::size_t count) {
    parent_.resize(count);
    std::iota(parent_.begin(), parent_.end(), 0);
  }

  /** Returns who stands for the set of `one`. */
  int Of(int one) {
    while (At(one) != one) {
      // Halves the way for the next who asks (Tarjan & van Leeuwen, J. ACM 31, 1984).
      At(one) = At(At(one));
      one = At(one);
    }
    return one;
  }

  void Join(int a, int b) {
    const auto [first, second] = std::minmax({Of(a), Of(b)});
    At(second) = first;
  }

  /** Returns, of each, who stands for its set. Valid until the next call. */
  std::span<const int> All() {
    // Whoever one points to is before it, and points to who stands for the set.
    for (int& parent : parent_) parent = At(parent);
    return parent_;
  }

 private:
  int& At(int one) { return parent_[static_cast<std::size_t>(one)]; }

  std::vector<int> parent_;  ///< Another of its set, or itself.
};

}  // namespace cookbook
