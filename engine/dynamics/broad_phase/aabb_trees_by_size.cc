#include "engine/dynamics/broad_phase/aabb_trees_by_size.h"

#include <algorithm>
#include <cmath>

namespace cookbook {
namespace {

/** The lengths of the boxes in a tree differ by up to this power of two. */
constexpr int kPowersPerClass = 3;
/** All lengths beyond 2^60 m are in one size class, and so are all below 2^-60 m. */
constexpr int kMaxPower = 60;

/** Returns the size class of a box, from 0. */
int SizeClassOf(const Aabb& box) {
  const double length = (box.high - box.low).maxCoeff();
  if (!(length > 0)) return 0;
  const int power = std::isfinite(length) ? std::ilogb(length) : kMaxPower;
  return (std::clamp(power, -kMaxPower, kMaxPower) + kMaxPower) / kPowersPerClass;
}

}  // namespace

void AabbTreesBySize::Insert(const Aabb& bounds, int body) {
  const int number = SizeClassOf(bounds);
  auto size_class =
      std::find_if(trees_.begin(), trees_.end(),
                   [number](const SizeClass& some) { return some.number == number; });
  if (size_class == trees_.end())
    size_class = trees_.insert(size_class, SizeClass{number, {}});
  size_class->tree.Insert(bounds, body);
  const auto index = static_cast<std::size_t>(body);
  if (tree_of_.size() <= index) tree_of_.resize(index + 1);
  tree_of_[index] = static_cast<std::size_t>(size_class - trees_.begin());
}

void AabbTreesBySize::Remove(int body) {
  trees_[tree_of_[static_cast<std::size_t>(body)]].tree.Remove(body);
}

std::span<const int> AabbTreesBySize::Query(const Aabb& bounds,
                                            AabbTree::Scratch& scratch) const {
  scratch.found.clear();
  for (const SizeClass& size_class : trees_) size_class.tree.Query(bounds, scratch);
  return scratch.found;
}

}  // namespace cookbook
