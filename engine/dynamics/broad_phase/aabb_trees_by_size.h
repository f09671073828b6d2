#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "engine/dynamics/broad_phase/aabb.h"
#include "engine/dynamics/broad_phase/aabb_tree.h"

namespace cookbook {

/** Trees of boxes, each of about one size: a wall or a floor in the tree of what lies on
 it would draw all of that to itself, whatever is near what. */
class AabbTreesBySize {
 public:
  /** Adds `body`, which is not there. */
  void Insert(const Aabb& bounds, int body);

  /** Removes `body`, which is. */
  void Remove(int body);

  /** Returns the bodies whose boxes overlap `bounds`, as AabbTree::Find() does. Valid
   until `room` is used again. */
  std::span<const int> Query(const Aabb& bounds, AabbTree::Room& room) const;

  /** Calls `visit(body)` for every body, as AabbTree::ForEach() does. */
  template <class Visit>
  void ForEach(const Visit& visit) const {
    for (const Sized& sized : trees_) sized.tree.ForEach(visit);
  }

 private:
  struct Sized {
    int size;  ///< See SizeOf().
    AabbTree tree;
  };

  std::vector<Sized> trees_;
  std::vector<std::size_t> tree_of_;  ///< Of each body.
};

}  // namespace cookbook
