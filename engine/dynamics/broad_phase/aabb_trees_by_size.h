#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "engine/dynamics/broad_phase/aabb.h"
#include "engine/dynamics/broad_phase/aabb_tree.h"

namespace cookbook {

/** One AABB tree for each size class of boxes (a factor of 8). In a single tree a floor
 or a wall would overlap nearly every node, and every query would visit them all. */
class AabbTreesBySize {
 public:
  /** Adds `body`.
   @pre It is in none of the trees. */
  void Insert(const Aabb& bounds, int body);

  /** Removes `body`.
   @pre It is in one of the trees. */
  void Remove(int body);

  /** Returns the bodies whose boxes overlap `bounds`, like AabbTree::Query(). The result
   is valid until `scratch` is used again. */
  std::span<const int> Query(const Aabb& bounds, AabbTree::Scratch& scratch) const;

  /** Calls `visit(body)` for every body, like AabbTree::ForEach(). */
  template <class Visit>
  void ForEach(const Visit& visit) const {
    for (const SizeClass& size_class : trees_) size_class.tree.ForEach(visit);
  }

 private:
  struct SizeClass {
    int number;  ///< See SizeClassOf().
    AabbTree tree;
  };

  std::vector<SizeClass> trees_;
  std::vector<std::size_t> tree_of_;  ///< Indexed by body: index into `trees_`.
};

}  // namespace cookbook
