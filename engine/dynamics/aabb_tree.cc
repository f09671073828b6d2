#include "engine/dynamics/aabb_tree.h"

namespace cookbook {

int AabbTree::Allocate() {
  if (free_ < 0) {
    nodes_.emplace_back();
    return static_cast<int>(nodes_.size()) - 1;
  }
  const int node = free_;
  free_ = at(node).parent;
  return node;
}

int AabbTree::FindSibling(const Aabb& bounds) {
  // Descends to the child that grows least, as long as that costs less than a new parent
  // here: what every ancestor grows by is inherited either way.
  int index = root_;
  while (at(index).child1 >= 0) {
    const Node& node = at(index);
    const double surface = node.bounds.Surface();
    const double here = Union(node.bounds, bounds).Surface();
    const double inherited = here - surface;
    const auto descend = [&](int child) {
      const Node& below = at(child);
      const double grown = Union(below.bounds, bounds).Surface();
      return below.child1 < 0 ? grown + inherited
                              : grown - below.bounds.Surface() + inherited;
    };
    const double cost1 = descend(node.child1);
    const double cost2 = descend(node.child2);
    if (here < cost1 && here < cost2) break;
    index = cost1 <= cost2 ? node.child1 : node.child2;
  }
  return index;
}

int AabbTree::Insert(const Aabb& bounds, int body) {
  const int leaf = Allocate();
  at(leaf) = {bounds, -1, -1, -1, body};
  if (root_ < 0) {
    root_ = leaf;
    return leaf;
  }
  const int sibling = FindSibling(bounds);
  const int parent = Allocate();
  const int above = at(sibling).parent;
  at(parent) = {Union(bounds, at(sibling).bounds), above, sibling, leaf, -1};
  at(sibling).parent = parent;
  at(leaf).parent = parent;
  if (above < 0) {
    root_ = parent;
  } else {
    (at(above).child1 == sibling ? at(above).child1 : at(above).child2) = parent;
  }
  Refit(above);
  return leaf;
}

void AabbTree::Remove(int leaf) {
  const int parent = at(leaf).parent;
  if (parent < 0) {
    root_ = -1;
  } else {
    const int sibling = at(parent).child1 == leaf ? at(parent).child2 : at(parent).child1;
    const int above = at(parent).parent;
    at(sibling).parent = above;
    if (above < 0) {
      root_ = sibling;
    } else {
      (at(above).child1 == parent ? at(above).child1 : at(above).child2) = sibling;
      Refit(above);
    }
    at(parent).parent = free_;
    free_ = parent;
  }
  at(leaf).parent = free_;
  free_ = leaf;
}

void AabbTree::Refit(int node) {
  // What becomes of a node hangs on its children and theirs: where two in a row have
  // stayed as they were, so has all above.
  for (int same = 0; node >= 0 && same < 2;) {
    Node& here = at(node);
    const Aabb bounds = Union(at(here.child1).bounds, at(here.child2).bounds);
    const bool stays = bounds == here.bounds;
    here.bounds = bounds;
    same = !Rotate(node) && stays ? same + 1 : 0;
    node = here.parent;
  }
}

bool AabbTree::Rotate(int index) {
  // Exchanges a child with a child of the other child where that makes the latter
  // smaller.
  Node& node = at(index);
  int Node::*const children[] = {&Node::child1, &Node::child2};
  double best = 0;
  int Node::*best_up = nullptr;    // Of the grandchild, in its parent.
  int Node::*best_down = nullptr;  // Of the child that goes below.
  for (int side = 0; side < 2; ++side) {
    const int stays = node.*children[side];
    const int goes = node.*children[1 - side];
    if (at(stays).child1 < 0) continue;
    for (int k = 0; k < 2; ++k) {
      const int keeps = at(stays).*children[1 - k];
      const double gain =
          at(stays).bounds.Surface() - Union(at(keeps).bounds, at(goes).bounds).Surface();
      if (gain <= best) continue;
      best = gain;
      best_up = children[k];
      best_down = children[1 - side];
    }
  }
  if (best_up == nullptr) return false;
  const int goes = node.*best_down;
  const int stays = node.*(best_down == &Node::child1 ? &Node::child2 : &Node::child1);
  const int rises = at(stays).*best_up;
  node.*best_down = rises;
  at(rises).parent = index;
  at(stays).*best_up = goes;
  at(goes).parent = stays;
  at(stays).bounds = Union(at(at(stays).child1).bounds, at(at(stays).child2).bounds);
  return true;
}

}  // namespace cookbook
