#include "engine/dynamics/aabb_tree.h"

namespace cookbook {

int AabbTree::Allocate() {
  if (free_ < 0) {
    nodes_.emplace_back();
    return static_cast<int>(nodes_.size()) - 1;
  }
  const int node = free_;
  free_ = at(node).place();
  return node;
}

void AabbTree::Hang(Child child, const LooseBox& bounds, Place place) {
  if (place == kTop) {
    root_ = child;
    root_bounds_ = bounds;
  } else {
    at(NodeOf(place)).SetChild(SideOf(place), bounds, child);
  }
  if (IsLeaf(child)) {
    places_[static_cast<std::size_t>(~child)] = place;
  } else {
    at(child).SetPlace(place);
  }
}

AabbTree::Place AabbTree::FindSibling(const LooseBox& bounds) const {
  // Descends to the child that grows least, as long as that costs less than a new parent
  // here: what every ancestor grows by is inherited either way.
  Place place = kTop;
  for (Child here = root_; !IsLeaf(here); here = ChildAt(place)) {
    const LooseBox& own = BoundsAt(place);
    const float grown = Union(own, bounds).Surface();
    const float inherited = grown - own.Surface();
    const Node& node = at(here);
    const auto descend = [&](std::size_t side) {
      const float surface = IsLeaf(node.child(side)) ? 0 : node.bounds[side].Surface();
      return Union(node.bounds[side], bounds).Surface() - surface + inherited;
    };
    const float cost1 = descend(0);
    const float cost2 = descend(1);
    if (grown < cost1 && grown < cost2) break;
    place = 2 * here + (cost1 <= cost2 ? 0 : 1);
  }
  return place;
}

void AabbTree::Insert(const LooseBox& bounds, int body) {
  if (places_.size() <= static_cast<std::size_t>(body)) {
    places_.resize(static_cast<std::size_t>(body) + 1);
  }
  if (root_ == kNone) {
    Hang(~body, bounds, kTop);
    return;
  }
  const Place place = FindSibling(bounds);
  const Child sibling = ChildAt(place);
  const LooseBox beside = BoundsAt(place);
  const int parent = Allocate();
  Hang(parent, Union(bounds, beside), place);
  Hang(sibling, beside, 2 * parent);
  Hang(~body, bounds, 2 * parent + 1);
  if (place != kTop) Refit(at(NodeOf(place)).place());
}

void AabbTree::Remove(int body) {
  const Place leaf = places_[static_cast<std::size_t>(body)];
  if (leaf == kTop) {
    root_ = kNone;
    return;
  }
  const int parent = NodeOf(leaf);
  const std::size_t sibling = 1 - SideOf(leaf);
  const Place place = at(parent).place();
  Hang(at(parent).child(sibling), LooseBox(at(parent).bounds[sibling]), place);
  at(parent).SetPlace(free_);
  free_ = parent;
  if (place != kTop) Refit(at(NodeOf(place)).place());
}

void AabbTree::Refit(Place place) {
  // What becomes of a node hangs on its children and theirs: where two in a row have
  // stayed as they were, so has all above.
  for (int same = 0; same < 2;) {
    const int node = ChildAt(place);
    const LooseBox bounds = Union(at(node).bounds[0], at(node).bounds[1]);
    const bool stays = bounds == BoundsAt(place);
    if (!stays) Hang(node, bounds, place);
    same = !Rotate(node) && stays ? same + 1 : 0;
    if (place == kTop) return;
    place = at(NodeOf(place)).place();
  }
}

bool AabbTree::Rotate(int index) {
  // Exchanges a child with a child of the other child where that makes the latter
  // smaller.
  Node& node = at(index);
  float best = 0;
  std::size_t best_stays = 0;  // Which child keeps its place.
  std::size_t best_rises = 0;  // Which child of it rises.
  for (std::size_t stays = 0; stays < 2; ++stays) {
    if (IsLeaf(node.child(stays))) continue;
    const Node& below = at(node.child(stays));
    const float surface = node.bounds[stays].Surface();
    for (std::size_t rises = 0; rises < 2; ++rises) {
      const LooseBox grown = Union(below.bounds[1 - rises], node.bounds[1 - stays]);
      const float gain = surface - grown.Surface();
      if (gain <= best) continue;
      best = gain;
      best_stays = stays;
      best_rises = rises;
    }
  }
  if (best <= 0) return false;
  const std::size_t goes = 1 - best_stays;
  const int stays = node.child(best_stays);
  const Child falling = node.child(goes);
  const LooseBox falling_bounds = node.bounds[goes];
  const auto place = [](int of, std::size_t side) {
    return 2 * of + static_cast<int>(side);
  };
  Hang(at(stays).child(best_rises), at(stays).bounds[best_rises], place(index, goes));
  Hang(falling, falling_bounds, place(stays, best_rises));
  node.SetChild(best_stays, Union(at(stays).bounds[0], at(stays).bounds[1]), stays);
  return true;
}

}  // namespace cookbook
