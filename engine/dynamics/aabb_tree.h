#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <limits>
#include <vector>

#include "engine/dynamics/aabb.h"
#include "engine/dynamics/fetch.h"

namespace cookbook {

/** A binary tree of boxes that is kept balanced while leaves come and go: finds what a
 box overlaps in O(log n) for each that it finds. Leaves are inserted where they add least
 surface, and the tree is rotated where that makes it smaller (Catto, GDC 2019).

 A node knows the boxes of both its children, and a leaf is no more than that: who looks
 down the tree reads one line of a cache a level. */
class AabbTree {
 public:
  /** Adds a leaf for `body`, which has none. */
  void Insert(const LooseBox& bounds, int body);

  /** Removes the leaf of `body`. */
  void Remove(int body);

  /** Calls `found(body)` for every leaf that overlaps `bounds`, in an order that depends
   on the history of the tree alone. `stack`: room, one for each thread. */
  template <class Found>
  void Query(const LooseBox& bounds, std::vector<int>& stack, const Found& found) const {
    stack.clear();
    if (root_ != kNone && root_bounds_.Overlaps(bounds)) stack.push_back(root_);
    while (!stack.empty()) {
      const int next = stack.back();
      stack.pop_back();
      if (IsLeaf(next)) {
        found(~next);
        continue;
      }
      const Node& node = at(next);
      for (std::size_t side = 0; side < 2; ++side) {
        if (!node.bounds[side].Overlaps(bounds)) continue;
        const Child child = node.child(side);
        if (!IsLeaf(child)) Fetch(&at(child), sizeof(Node));
        stack.push_back(child);
      }
    }
  }

  /** Calls `visit(body)` for every leaf; leaves near each other mostly come soon after
   each other. */
  template <class Visit>
  void ForEachLeaf(std::vector<int>& stack, const Visit& visit) const {
    stack.clear();
    if (root_ != kNone) stack.push_back(root_);
    while (!stack.empty()) {
      const int next = stack.back();
      stack.pop_back();
      if (IsLeaf(next)) {
        visit(~next);
      } else {
        stack.push_back(at(next).child(0));
        stack.push_back(at(next).child(1));
      }
    }
  }

 private:
  /** What a node has below it: another node, or of a leaf the complement of its body. */
  using Child = int;
  /** Where a child hangs: twice the node and, of its second child, one more; kTop: the
   root. */
  using Place = int;
  static constexpr Child kNone = std::numeric_limits<int>::max();
  static constexpr Place kTop = -1;

  /** Two boxes, and what hangs there in the numbers that are no part of them. */
  struct alignas(64) Node {
    std::array<LooseBox, 2> bounds;  ///< Of the children.

    Child child(std::size_t side) const {
      return std::bit_cast<Child>(float{bounds[side].low[3]});
    }
    /** Of a free node the next free one, −1: none. */
    Place place() const { return std::bit_cast<Place>(float{bounds[0].high[3]}); }
    void SetChild(std::size_t side, const LooseBox& box, Child child) {
      const float kept = bounds[side].high[3];
      bounds[side] = box;
      bounds[side].low[3] = std::bit_cast<float>(child);
      bounds[side].high[3] = kept;
    }
    void SetPlace(Place place) { bounds[0].high[3] = std::bit_cast<float>(place); }
  };
  static_assert(sizeof(Node) == 64);

  static bool IsLeaf(Child child) { return child < 0; }
  static int NodeOf(Place place) { return place / 2; }
  static std::size_t SideOf(Place place) { return static_cast<std::size_t>(place % 2); }

  Node& at(int node) { return nodes_[static_cast<std::size_t>(node)]; }
  const Node& at(int node) const { return nodes_[static_cast<std::size_t>(node)]; }
  const LooseBox& BoundsAt(Place place) const {
    return place == kTop ? root_bounds_ : at(NodeOf(place)).bounds[SideOf(place)];
  }
  Child ChildAt(Place place) const {
    return place == kTop ? root_ : at(NodeOf(place)).child(SideOf(place));
  }
  void Hang(Child child, const LooseBox& bounds, Place place);
  int Allocate();
  Place FindSibling(const LooseBox& bounds) const;
  /** Brings up to date what hangs on the children of the node at `place`. */
  void Refit(Place place);
  /** Returns whether it did anything. */
  bool Rotate(int node);

  std::vector<Node> nodes_;
  std::vector<Place> places_;  ///< Of the leaf of each body.
  Child root_ = kNone;
  LooseBox root_bounds_{};
  int free_ = -1;
};

}  // namespace cookbook
