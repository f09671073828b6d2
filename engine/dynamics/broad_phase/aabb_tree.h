#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "engine/dynamics/broad_phase/aabb.h"

namespace cookbook {

/** A dynamic AABB tree with up to sixteen children per node, all leaves at the same
 depth. It is wider than the usual binary tree because the boxes of a node are tested
 together, with SIMD. If the boxes have about the same size and few of them overlap, a
 query visits some log n nodes.

 It is an R-tree (Guttman, SIGMOD 1984). A body is inserted into the child whose box grows
 least, if equal into the smallest. A full node is split, and a leaf node with few bodies
 is dissolved. Growth and splits are measured by surface area, to which the probability of
 a visit is proportional. */
class AabbTree {
 public:
  /** Adds `body`.
   @pre It is not in the tree. */
  void Insert(const Aabb& bounds, int body);

  /** Removes `body`.
   @pre It is in the tree. */
  void Remove(int body);

  /** Scratch memory and result of the queries of one thread. */
  struct Scratch {
    std::vector<int> stack;  ///< Nodes to visit.
    std::vector<int> found;  ///< Bodies.
    long nodes_visited = 0;  ///< Number of nodes, summed over all queries.
  };

  /** Appends the bodies whose boxes overlap `bounds` to `scratch.found`, in an order that
   depends only on the history of the tree. */
  void Query(const Aabb& bounds, Scratch& scratch) const;

  /** Calls `visit(body)` for every body, mostly in spatial order: neighbours follow each
   other closely. */
  template <class Visit>
  void ForEach(const Visit& visit) const {
    if (root_ >= 0) ForEachBelow(root_, visit);
  }

  static constexpr std::size_t kMaxChildren = 16;

  /** A node: the boxes of its children as a structure of arrays. Those from `count` on
   are empty. */
  struct alignas(64) Node {
    using Lanes = std::array<double, kMaxChildren>;

    std::array<Lanes, 3> low;
    std::array<Lanes, 3> high;
    std::array<int, kMaxChildren> children;  ///< Nodes; bodies at level 0.
    int count;
    int level;   ///< Height above the leaf nodes.
    int parent;  ///< −1: the root. In a free node, the next free node.
    int slot;    ///< Index among the children of the parent.

    Aabb ChildBox(std::size_t child) const {
      Aabb box{};
      for (int k = 0; k < 3; ++k) {
        box.low[k] = low[static_cast<std::size_t>(k)][child];
        box.high[k] = high[static_cast<std::size_t>(k)][child];
      }
      return box;
    }
    void SetChildBox(std::size_t child, const Aabb& box) {
      for (int k = 0; k < 3; ++k) {
        low[static_cast<std::size_t>(k)][child] = box.low[k];
        high[static_cast<std::size_t>(k)][child] = box.high[k];
      }
    }
  };

 private:
  /** A child and its box. */
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
  /** Returns the index of an empty node without a parent. */
  int AllocateNode(int level);
  void FreeNode(int node);
  Aabb BoundsOf(int node) const;
  /** Writes an entry into a slot of a node, and updates the back link of the child. */
  void SetEntry(int node, std::size_t slot, const Entry& entry);
  void AddEntry(int node, const Entry& entry);
  /** Splits a full node to add an entry: some of the entries move to a new sibling. */
  void Split(int node, const Entry& entry);
  /** Removes an entry from a node, and the node from the tree if it is empty then. */
  void RemoveEntry(int node, std::size_t slot);
  /** Removes a leaf node from the tree and reinserts its bodies. */
  void Dissolve(int node);
  /** Updates the box of a node in its ancestors. */
  void Refit(int node);

  std::vector<Node> nodes_;     ///< Used and free nodes.
  std::vector<int> locations_;  ///< Indexed by body: kMaxChildren * node + slot.
  int root_ = -1;               ///< −1: the tree is empty.
  int free_list_ = -1;          ///< First free node; −1: none.
};

}  // namespace cookbook
