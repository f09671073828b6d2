#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "engine/dynamics/broad_phase/aabb.h"

namespace cookbook {

/** A tree of boxes, sixteen to a node, all bodies at one depth while they come and go:
 where boxes are of about one size, and few of them overlap, it looks at some log n nodes
 to find what a box overlaps. Sixteen boxes are looked at together, in as many lanes as
 the processor has.

 As an R-tree (Guttman, SIGMOD 1984): a body goes down to the box that grows least, of
 equals the smallest; what is full is split, and a node of bodies that is nearly empty is
 dissolved. Here both go by surface, which is how likely a box is looked into. */
class AabbTree {
 public:
  /** Adds `body`, which is not there. */
  void Insert(const Aabb& bounds, int body);

  /** Removes `body`, which is. */
  void Remove(int body);

  /** Room of one thread that asks. */
  struct Room {
    std::vector<int> stack;
    std::vector<int> found;
    long looked_at = 0;  ///< Nodes, in all questions.
  };

  /** Appends to what is `found` the bodies whose boxes overlap `bounds`, in an order that
   depends on the history of the tree alone. */
  void Find(const Aabb& bounds, Room& room) const;

  /** Calls `visit(body)` for every body; those near each other mostly come soon after
   each other. */
  template <class Visit>
  void ForEach(const Visit& visit) const {
    if (root_ >= 0) ForEachBelow(root_, visit);
  }

  static constexpr std::size_t kWide = 16;

  /** Sixteen boxes, side by side; those from `count` on are no children. */
  struct alignas(64) Node {
    using Lanes = std::array<double, kWide>;

    std::array<Lanes, 3> low;
    std::array<Lanes, 3> high;
    std::array<int, kWide> children;  ///< Nodes; at level 0 bodies.
    int count;
    int level;
    int parent;  ///< −1: the root. Of a free node the next free one.
    int slot;    ///< Which child of the parent it is.

    Aabb BoxOf(std::size_t slot_of) const {
      Aabb box{};
      for (int k = 0; k < 3; ++k) {
        box.low[k] = low[static_cast<std::size_t>(k)][slot_of];
        box.high[k] = high[static_cast<std::size_t>(k)][slot_of];
      }
      return box;
    }
    void SetBox(std::size_t slot_of, const Aabb& box) {
      for (int k = 0; k < 3; ++k) {
        low[static_cast<std::size_t>(k)][slot_of] = box.low[k];
        high[static_cast<std::size_t>(k)][slot_of] = box.high[k];
      }
    }
  };

 private:
  /** A box and what is in it. */
  struct Entry {
    Aabb box;
    int child;
  };

  template <class Visit>
  void ForEachBelow(int node, const Visit& visit) const {
    const Node& here = at(node);
    for (std::size_t slot = 0; slot < static_cast<std::size_t>(here.count); ++slot) {
      const int child = here.children[slot];
      if (here.level == 0) {
        visit(child);
      } else {
        ForEachBelow(child, visit);
      }
    }
  }

  Node& at(int node) { return nodes_[static_cast<std::size_t>(node)]; }
  const Node& at(int node) const { return nodes_[static_cast<std::size_t>(node)]; }
  /** Returns an empty node. */
  int Allocate(int level);
  void Free(int node);
  Aabb BoundsOf(int node) const;
  /** Puts an entry where a node has nothing yet, or replaces one. */
  void Put(int node, std::size_t slot, const Entry& entry);
  void Add(int node, const Entry& entry);
  /** Adds to a full node: half of all goes to a new one beside it. */
  void Split(int node, const Entry& entry);
  /** Takes an entry out of a node, and the node out of the tree if that was the last. */
  void TakeOut(int node, std::size_t slot);
  /** Takes a node out of the tree and puts elsewhere what is left in it. */
  void Dissolve(int node);
  /** Brings the boxes of a node's ancestors up to date. */
  void Refit(int node);

  std::vector<Node> nodes_;
  std::vector<int> places_;  ///< Of each body: kWide times its node and its slot.
  int root_ = -1;
  int free_ = -1;
};

}  // namespace cookbook
