#pragma once

#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace touchstone {

/** A union-find over the bodies of a world, with the sum of a number over each cluster.
 */
class Clusters {
 public:
  /** Each of `count` bodies is a cluster of its own, with the sum 0. */
  explicit Clusters(std::size_t count) : parents_(count), sums_(count, 0) {
    std::iota(parents_.begin(), parents_.end(), 0);
  }

  /** Returns an index that all bodies of the cluster share. */
  std::size_t Of(int body) {
    auto root = static_cast<std::size_t>(body);
    while (parents_[root] != root) root = parents_[root] = parents_[parents_[root]];
    return root;
  }

  void Join(int A, int B) {
    const std::size_t a = Of(A);
    const std::size_t b = Of(B);
    if (a == b) return;
    parents_[b] = a;
    sums_[a] += std::exchange(sums_[b], 0);
  }

  /** Adds to the sum of the cluster of `body`. */
  void Add(int body, double number) { sums_[Of(body)] += number; }

  /** Returns the sum of the cluster of `body`. */
  double SumAt(int body) { return sums_[Of(body)]; }

 private:
  std::vector<std::size_t> parents_;
  std::vector<double> sums_;  ///< Indexed by root.
};

}  // namespace touchstone
