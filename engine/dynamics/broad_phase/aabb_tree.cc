#include "engine/dynamics/broad_phase/aabb_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace cookbook {
namespace {

constexpr std::size_t kWide = AabbTree::kWide;
/** A node of fewer bodies is dissolved, and no part of a split has fewer. */
constexpr std::size_t kFewest = 4;

std::size_t At(int index) {
  return static_cast<std::size_t>(index);
}

/** Returns the child whose surface grows least if it takes in `box`, of equals the one of
 the least surface. */
std::size_t ChildFor(const Aabb& box, const AabbTree::Node& node) {
  AabbTree::Node::Lanes surface;
  AabbTree::Node::Lanes growth;
  for (std::size_t k = 0; k < kWide; ++k) {
    std::array<double, 3> size;
    std::array<double, 3> grown;
    for (int axis = 0; axis < 3; ++axis) {
      const double low = node.low[At(axis)][k];
      const double high = node.high[At(axis)][k];
      size[At(axis)] = high - low;
      grown[At(axis)] = std::max(high, box.high[axis]) - std::min(low, box.low[axis]);
    }
    surface[k] = size[0] * size[1] + size[1] * size[2] + size[2] * size[0];
    growth[k] =
        grown[0] * grown[1] + grown[1] * grown[2] + grown[2] * grown[0] - surface[k];
  }
  std::size_t best = 0;
  for (std::size_t k = 1; k < At(node.count); ++k) {
    const bool as_good = growth[k] == growth[best] && surface[k] < surface[best];
    if (growth[k] < growth[best] || as_good) best = k;
  }
  return best;
}

/** Returns where a box is along an axis, twice; a number even where it has no end. */
double PlaceOf(const Aabb& box, int axis) {
  constexpr double kFar = 1e300;
  const auto bound = [](double x) { return std::fmin(std::fmax(x, -kFar), kFar); };
  return bound(box.low[axis]) + bound(box.high[axis]);
}

}  // namespace

int AabbTree::Allocate(int level) {
  int node = free_;
  if (node < 0) {
    nodes_.emplace_back();
    node = static_cast<int>(nodes_.size()) - 1;
  } else {
    free_ = at(node).parent;
  }
  Node& empty = at(node);
  for (std::size_t k = 0; k < kWide; ++k) empty.SetBox(k, Aabb::Nothing());
  empty.count = 0;
  empty.level = level;
  empty.parent = -1;
  return node;
}

void AabbTree::Free(int node) {
  at(node).parent = free_;
  free_ = node;
}

Aabb AabbTree::BoundsOf(int node) const {
  Aabb bounds = Aabb::Nothing();
  for (int k = 0; k < 3; ++k) {
    for (std::size_t slot = 0; slot < kWide; ++slot) {
      bounds.low[k] = std::min(bounds.low[k], at(node).low[At(k)][slot]);
      bounds.high[k] = std::max(bounds.high[k], at(node).high[At(k)][slot]);
    }
  }
  return bounds;
}

void AabbTree::Put(int node, std::size_t slot, const Entry& entry) {
  Node& into = at(node);
  into.SetBox(slot, entry.box);
  into.children[slot] = entry.child;
  if (into.level == 0) {
    places_[At(entry.child)] = node * static_cast<int>(kWide) + static_cast<int>(slot);
  } else {
    at(entry.child).parent = node;
    at(entry.child).slot = static_cast<int>(slot);
  }
}

void AabbTree::Add(int node, const Entry& entry) {
  if (At(at(node).count) == kWide) {
    Split(node, entry);
  } else {
    Put(node, At(at(node).count++), entry);
    Refit(node);
  }
}

void AabbTree::Split(int node, const Entry& entry) {
  constexpr std::size_t kAll = kWide + 1;
  std::array<Entry, kAll> entries;
  for (std::size_t k = 0; k < kWide; ++k) {
    entries[k] = {at(node).BoxOf(k), at(node).children[k]};
  }
  entries[kWide] = entry;

  // Along the axis along which they lie farthest apart, where the surfaces of both parts,
  // each times what it holds, are least.
  int axis = 0;
  double farthest = -1;
  for (int k = 0; k < 3; ++k) {
    const auto [first, last] = std::minmax_element(
        entries.begin(), entries.end(), [&](const auto& a, const auto& b) {
          return PlaceOf(a.box, k) < PlaceOf(b.box, k);
        });
    const double apart = PlaceOf(last->box, k) - PlaceOf(first->box, k);
    if (apart > farthest) {
      farthest = apart;
      axis = k;
    }
  }
  // No two children are one, so there is one order; a stable sort would allocate.
  std::sort(entries.begin(), entries.end(), [&](const Entry& a, const Entry& b) {
    return std::pair(PlaceOf(a.box, axis), a.child) <
           std::pair(PlaceOf(b.box, axis), b.child);
  });
  std::array<double, kAll> surface_after;  // Of those from one on.
  Aabb bounds = Aabb::Nothing();
  for (std::size_t k = kAll; k-- > 0;) {
    bounds = Union(bounds, entries[k].box);
    surface_after[k] = bounds.Surface();
  }
  std::size_t middle = kAll / 2;
  double least = std::numeric_limits<double>::infinity();
  bounds = Aabb::Nothing();
  for (std::size_t k = 1; k <= kAll - kFewest; ++k) {
    bounds = Union(bounds, entries[k - 1].box);
    if (k < kFewest) continue;
    const double cost = static_cast<double>(k) * bounds.Surface() +
                        static_cast<double>(kAll - k) * surface_after[k];
    if (cost < least) {
      least = cost;
      middle = k;
    }
  }

  const int beside = Allocate(at(node).level);
  for (std::size_t k = 0; k < middle; ++k) Put(node, k, entries[k]);
  for (std::size_t k = middle; k < kAll; ++k) Put(beside, k - middle, entries[k]);
  for (std::size_t k = middle; k < kWide; ++k) at(node).SetBox(k, Aabb::Nothing());
  at(node).count = static_cast<int>(middle);
  at(beside).count = static_cast<int>(kAll - middle);
  if (at(node).parent < 0) {
    root_ = Allocate(at(node).level + 1);
    Add(root_, {BoundsOf(node), node});
  } else {
    Refit(node);
  }
  Add(at(node).parent, {BoundsOf(beside), beside});
}

void AabbTree::Insert(const Aabb& bounds, int body) {
  if (places_.size() <= At(body)) places_.resize(At(body) + 1);
  if (root_ < 0) root_ = Allocate(0);
  int node = root_;
  while (at(node).level > 0) node = at(node).children[ChildFor(bounds, at(node))];
  Add(node, {bounds, body});
}

void AabbTree::TakeOut(int node, std::size_t slot) {
  Node& from = at(node);
  const std::size_t last = At(--from.count);
  if (slot < last) Put(node, slot, {from.BoxOf(last), from.children[last]});
  from.SetBox(last, Aabb::Nothing());
  if (from.count > 0) {
    Refit(node);
  } else if (node == root_) {
    Free(node);
    root_ = -1;
  } else {
    const int parent = from.parent;
    const std::size_t slot_of_node = At(from.slot);
    Free(node);
    TakeOut(parent, slot_of_node);
  }
}

void AabbTree::Dissolve(int node) {
  std::array<Entry, kFewest> left;
  const std::size_t count = At(at(node).count);
  for (std::size_t k = 0; k < count; ++k) {
    left[k] = {at(node).BoxOf(k), at(node).children[k]};
  }
  const int parent = at(node).parent;
  const std::size_t slot = At(at(node).slot);
  Free(node);
  TakeOut(parent, slot);
  for (std::size_t k = 0; k < count; ++k) Insert(left[k].box, left[k].child);
}

void AabbTree::Remove(int body) {
  const int place = places_[At(body)];
  const int node = place / static_cast<int>(kWide);
  TakeOut(node, At(place) % kWide);
  if (node != root_ && at(node).count > 0 && At(at(node).count) < kFewest) Dissolve(node);
  while (root_ >= 0 && at(root_).level > 0 && at(root_).count == 1) {
    const int only = at(root_).children[0];
    Free(root_);
    root_ = only;
    at(root_).parent = -1;
  }
}

void AabbTree::Refit(int node) {
  for (; at(node).parent >= 0; node = at(node).parent) {
    const Aabb bounds = BoundsOf(node);
    Node& parent = at(at(node).parent);
    if (bounds == parent.BoxOf(At(at(node).slot))) return;
    parent.SetBox(At(at(node).slot), bounds);
  }
}

}  // namespace cookbook
