#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "engine/dynamics/fetch.h"

namespace cookbook {

/** A box along the world's axes. */
struct Aabb {
  Eigen::Vector3d low;   ///< [m]
  Eigen::Vector3d high;  ///< [m]

  bool Overlaps(const Aabb& other) const {
    // Without branches: which of the six comparisons fails cannot be foretold.
    int apart = 0;
    for (int k = 0; k < 3; ++k) {
      apart |= low[k] > other.high[k];
      apart |= other.low[k] > high[k];
    }
    return apart == 0;
  }

  bool Contains(const Aabb& other) const {
    return (low.array() <= other.low.array()).all() &&
           (other.high.array() <= high.array()).all();
  }

  bool operator==(const Aabb& other) const {
    return low == other.low && high == other.high;
  }

  /** Half the surface. [m²] */
  double Surface() const {
    const Eigen::Vector3d size = high - low;
    return size[0] * size[1] + size[1] * size[2] + size[2] * size[0];
  }
};

inline Aabb Union(const Aabb& a, const Aabb& b) {
  return {a.low.cwiseMin(b.low), a.high.cwiseMax(b.high)};
}

/** A binary tree of boxes that is kept balanced while leaves come and go: finds what a
 box overlaps in O(log n) for each that it finds. Leaves are inserted where they add least
 surface, and the tree is rotated where that makes it smaller (Catto, GDC 2019). */
class AabbTree {
 public:
  /** Adds a leaf and returns its node, which stays its own until removed. */
  int Insert(const Aabb& bounds, int body);

  void Remove(int leaf);

  const Aabb& bounds(int leaf) const {
    return nodes_[static_cast<std::size_t>(leaf)].bounds;
  }

  /** Calls `found(body, its bounds)` for every leaf that overlaps `bounds`, in an order
   that depends on the history of the tree alone. `stack`: room, one for each thread. */
  template <class Found>
  void Query(const Aabb& bounds, std::vector<int>& stack, const Found& found) const {
    if (root_ < 0) return;
    stack.clear();
    stack.push_back(root_);
    while (!stack.empty()) {
      const Node& node = nodes_[static_cast<std::size_t>(stack.back())];
      stack.pop_back();
      if (!node.bounds.Overlaps(bounds)) continue;
      if (node.child1 < 0) {
        found(node.body, node.bounds);
      } else {
        Fetch(&nodes_[static_cast<std::size_t>(node.child1)], sizeof(Node));
        Fetch(&nodes_[static_cast<std::size_t>(node.child2)], sizeof(Node));
        stack.push_back(node.child1);
        stack.push_back(node.child2);
      }
    }
  }

  /** Calls `visit(body)` for every leaf; leaves near each other mostly come soon after
   each other. */
  template <class Visit>
  void ForEachLeaf(std::vector<int>& stack, const Visit& visit) const {
    stack.clear();
    if (root_ >= 0) stack.push_back(root_);
    while (!stack.empty()) {
      const Node& node = nodes_[static_cast<std::size_t>(stack.back())];
      stack.pop_back();
      if (node.child1 < 0) {
        visit(node.body);
      } else {
        stack.push_back(node.child1);
        stack.push_back(node.child2);
      }
    }
  }

 private:
  struct alignas(64) Node {
    Aabb bounds;
    int parent;  ///< −1: the root. Of a free node the next free one.
    int child1;  ///< −1: a leaf.
    int child2;
    int body;
  };

  Node& at(int node) { return nodes_[static_cast<std::size_t>(node)]; }
  int Allocate();
  int FindSibling(const Aabb& bounds);
  void Refit(int node);
  /** Returns whether it did anything. */
  bool Rotate(int node);

  std::vector<Node> nodes_;
  int root_ = -1;
  int free_ = -1;
};

}  // namespace cookbook
