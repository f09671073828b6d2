#include "engine/dynamics/broad_phase/aabb_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace cookbook {
namespace {

constexpr std::size_t kMaxChildren = AabbTree::kMaxChildren;
/** A leaf node with fewer bodies is dissolved, and no half of a split has fewer. */
constexpr std::size_t kMinChildren = 4;

std::size_t At(int index) {
  return static_cast<std::size_t>(index);
}

/** Returns the child whose surface area grows least if `box` is added to it; among
 equals, the child with the least area. */
std::size_t ChooseChild(const Aabb& box, const AabbTree::Node& node) {
  AabbTree::Node::Lanes area;
  AabbTree::Node::Lanes growth;
  for (std::size_t k = 0; k < kMaxChildren; ++k) {
    std::array<double, 3> size;
    std::array<double, 3> grown;
    for (int axis = 0; axis < 3; ++axis) {
      const double low = node.low[At(axis)][k];
      const double high = node.high[At(axis)][k];
      size[At(axis)] = high - low;
      grown[At(axis)] = std::max(high, box.high[axis]) - std::min(low, box.low[axis]);
    }
    area[k] = size[0] * size[1] + size[1] * size[2] + size[2] * size[0];
    growth[k] = grown[0] * grown[1] + grown[1] * grown[2] + grown[2] * grown[0] - area[k];
  }
  std::size_t best = 0;
  for (std::size_t k = 1; k < At(node.count); ++k) {
    const bool as_good = growth[k] == growth[best] && area[k] < area[best];
    if (growth[k] < growth[best] || as_good) best = k;
  }
  return best;
}

/** Returns twice the centre of a box along an axis; finite even if the box is not. */
double DoubledCentre(const Aabb& box, int axis) {
  constexpr double kFar = 1e300;
  const auto bound = [](double x) { return std::fmin(std::fmax(x, -kFar), kFar); };
  return bound(box.low[axis]) + bound(box.high[axis]);
}

}  // namespace

int AabbTree::AllocateNode(int level) {
  int node = free_list_;
  if (node < 0) {
    nodes_.emplace_back();
    node = static_cast<int>(nodes_.size()) - 1;
  } else {
    free_list_ = at(node).parent;
  }
  Node& empty = at(node);
  for (std::size_t k = 0; k < kMaxChildren; ++k) empty.SetChildBox(k, Aabb::Empty());
  empty.count = 0;
  empty.level = level;
  empty.parent = -1;
  return node;
}

void AabbTree::FreeNode(int node) {
  at(node).parent = free_list_;
  free_list_ = node;
}

Aabb AabbTree::BoundsOf(int node) const {
  Aabb bounds = Aabb::Empty();
  for (int k = 0; k < 3; ++k) {
    for (std::size_t slot = 0; slot < kMaxChildren; ++slot) {
      bounds.low[k] = std::min(bounds.low[k], at(node).low[At(k)][slot]);
      bounds.high[k] = std::max(bounds.high[k], at(node).high[At(k)][slot]);
    }
  }
  return bounds;
}

void AabbTree::SetEntry(int node, std::size_t slot, const Entry& entry) {
  Node& into = at(node);
  into.SetChildBox(slot, entry.box);
  into.children[slot] = entry.child;
  if (into.level == 0) {
    locations_[At(entry.child)] =
        node * static_cast<int>(kMaxChildren) + static_cast<int>(slot);
  } else {
    at(entry.child).parent = node;
    at(entry.child).slot = static_cast<int>(slot);
  }
}

void AabbTree::AddEntry(int node, const Entry& entry) {
  if (At(at(node).count) == kMaxChildren) {
    Split(node, entry);
  } else {
    SetEntry(node, At(at(node).count++), entry);
    Refit(node);
  }
}

void AabbTree::Split(int node, const Entry& entry) {
  constexpr std::size_t kAll = kMaxChildren + 1;
  std::array<Entry, kAll> entries;
  for (std::size_t k = 0; k < kMaxChildren; ++k) {
    entries[k] = {at(node).ChildBox(k), at(node).children[k]};
  }
  entries[kMaxChildren] = entry;

  // The split axis: the one along which the centres are farthest apart.
  int axis = 0;
  double greatest_spread = -1;
  for (int k = 0; k < 3; ++k) {
    const auto [first, last] = std::minmax_element(
        entries.begin(), entries.end(), [&](const auto& a, const auto& b) {
          return DoubledCentre(a.box, k) < DoubledCentre(b.box, k);
        });
    const double spread = DoubledCentre(last->box, k) - DoubledCentre(first->box, k);
    if (spread > greatest_spread) {
      greatest_spread = spread;
      axis = k;
    }
  }
  // The child index makes the order unique. A stable sort would allocate memory.
  std::sort(entries.begin(), entries.end(), [&](const Entry& a, const Entry& b) {
    return std::pair(DoubledCentre(a.box, axis), a.child) <
           std::pair(DoubledCentre(b.box, axis), b.child);
  });
  // The split position: the surface area heuristic, which minimizes the sum over both
  // parts of area times number of entries.
  std::array<double, kAll> area_after;  // Half area of the entries from an index on.
  Aabb bounds = Aabb::Empty();
  for (std::size_t k = kAll; k-- > 0;) {
    bounds = Union(bounds, entries[k].box);
    area_after[k] = bounds.HalfArea();
  }
  std::size_t middle = kAll / 2;
  double least = std::numeric_limits<double>::infinity();
  bounds = Aabb::Empty();
  for (std::size_t k = 1; k <= kAll - kMinChildren; ++k) {
    bounds = Union(bounds, entries[k - 1].box);
    if (k < kMinChildren) continue;
    const double cost = static_cast<double>(k) * bounds.HalfArea() +
                        static_cast<double>(kAll - k) * area_after[k];
    if (cost < least) {
      least = cost;
      middle = k;
    }
  }

  const int sibling = AllocateNode(at(node).level);
  for (std::size_t k = 0; k < middle; ++k) SetEntry(node, k, entries[k]);
  for (std::size_t k = middle; k < kAll; ++k) SetEntry(sibling, k - middle, entries[k]);
  for (std::size_t k = middle; k < kMaxChildren; ++k)
    at(node).SetChildBox(k, Aabb::Empty());
  at(node).count = static_cast<int>(middle);
  at(sibling).count = static_cast<int>(kAll - middle);
  if (at(node).parent < 0) {
    root_ = AllocateNode(at(node).level + 1);
    AddEntry(root_, {BoundsOf(node), node});
  } else {
    Refit(node);
  }
  AddEntry(at(node).parent, {BoundsOf(sibling), sibling});
}

void AabbTree::Insert(const Aabb& bounds, int body) {
  if (locations_.size() <= At(body)) locations_.resize(At(body) + 1);
  if (root_ < 0) root_ = AllocateNode(0);
  int node = root_;
  while (at(node).level > 0) node = at(node).children[ChooseChild(bounds, at(node))];
  AddEntry(node, {bounds, body});
}

void AabbTree::RemoveEntry(int node, std::size_t slot) {
  Node& from = at(node);
  const std::size_t last = At(--from.count);
  if (slot < last) SetEntry(node, slot, {from.ChildBox(last), from.children[last]});
  from.SetChildBox(last, Aabb::Empty());
  if (from.count > 0) {
    Refit(node);
  } else if (node == root_) {
    FreeNode(node);
    root_ = -1;
  } else {
    const int parent = from.parent;
    const std::size_t slot_of_node = At(from.slot);
    FreeNode(node);
    RemoveEntry(parent, slot_of_node);
  }
}

void AabbTree::Dissolve(int node) {
  std::array<Entry, kMinChildren> left;
  const std::size_t count = At(at(node).count);
  for (std::size_t k = 0; k < count; ++k) {
    left[k] = {at(node).ChildBox(k), at(node).children[k]};
  }
  const int parent = at(node).parent;
  const std::size_t slot = At(at(node).slot);
  FreeNode(node);
  RemoveEntry(parent, slot);
  for (std::size_t k = 0; k < count; ++k) Insert(left[k].box, left[k].child);
}

void AabbTree::Remove(int body) {
  const int location = locations_[At(body)];
  const int node = location / static_cast<int>(kMaxChildren);
  RemoveEntry(node, At(location) % kMaxChildren);
  if (node != root_ && at(node).count > 0 && At(at(node).count) < kMinChildren)
    Dissolve(node);
  while (root_ >= 0 && at(root_).level > 0 && at(root_).count == 1) {
    const int only = at(root_).children[0];
    FreeNode(root_);
    root_ = only;
    at(root_).parent = -1;
  }
}

void AabbTree::Refit(int node) {
  for (; at(node).parent >= 0; node = at(node).parent) {
    const Aabb bounds = BoundsOf(node);
    Node& parent = at(at(node).parent);
    if (bounds == parent.ChildBox(At(at(node).slot))) return;
    parent.SetChildBox(At(at(node).slot), bounds);
  }
}

}  // namespace cookbook
