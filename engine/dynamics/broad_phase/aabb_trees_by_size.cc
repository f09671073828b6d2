#include "engine/dynamics/broad_phase/aabb_trees_by_size.h"

#include <algorithm>
#include <cmath>

namespace cookbook {
namespace {

/** Boxes of one tree are up to so many times as long as each other, as a power of two. */
constexpr int kPowers = 3;
/** What is longer by 2 to this power, or by as much shorter, [m] is of one size. */
constexpr int kFarthest = 60;

/** Returns a number that boxes of about the same length share, from 0. */
int SizeOf(const Aabb& box) {
  const double length = (box.high - box.low).maxCoeff();
  if (!(length > 0)) return 0;
  const int power = std::isfinite(length) ? std::ilogb(length) : kFarthest;
  return (std::clamp(power, -kFarthest, kFarthest) + kFarthest) / kPowers;
}

}  // namespace

void AabbTreesBySize::Insert(const Aabb& bounds, int body) {
  const int size = SizeOf(bounds);
  auto sized = std::find_if(trees_.begin(), trees_.end(),
                            [size](const Sized& some) { return some.size == size; });
  if (sized == trees_.end()) sized = trees_.insert(sized, Sized{size, {}});
  sized->tree.Insert(bounds, body);
  const auto index = static_cast<std::size_t>(body);
  if (tree_of_.size() <= index) tree_of_.resize(index + 1);
  tree_of_[index] = static_cast<std::size_t>(sized - trees_.begin());
}

void AabbTreesBySize::Remove(int body) {
  trees_[tree_of_[static_cast<std::size_t>(body)]].tree.Remove(body);
}

std::span<const int> AabbTreesBySize::Query(const Aabb& bounds,
                                            AabbTree::Room& room) const {
  room.found.clear();
  for (const Sized& sized : trees_) sized.tree.Find(bounds, room);
  return room.found;
}

}  // namespace cookbook
