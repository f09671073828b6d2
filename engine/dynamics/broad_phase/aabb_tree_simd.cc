#include <bit>
#include <cstdint>

#include "engine/dynamics/broad_phase/aabb_tree.h"

#define HWY_TARGET_INCLUDE "engine/dynamics/broad_phase/aabb_tree_simd.cc"
#include "engine/simd/foreach_target.h"

HWY_BEFORE_NAMESPACE();
namespace cookbook::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

/** Returns a mask whose bit k is set if child k of a node overlaps `bounds`. The sixteen
 doubles of an array are two registers of AVX-512, four of AVX2. */
HWY_INLINE std::uint64_t OverlapMask(const AabbTree::Node& node, const Aabb& bounds) {
  const hn::CappedTag<double, AabbTree::kMaxChildren> tag;
  std::uint64_t bits = 0;
  for (std::size_t first = 0; first < AabbTree::kMaxChildren; first += hn::Lanes(tag)) {
    auto overlaps = hn::FirstN(tag, AabbTree::kMaxChildren);
    for (int k = 0; k < 3; ++k) {
      const auto axis = static_cast<std::size_t>(k);
      const auto low = hn::Load(tag, node.low[axis].data() + first);
      const auto high = hn::Load(tag, node.high[axis].data() + first);
      overlaps = hn::And(overlaps, hn::And(hn::Le(low, hn::Set(tag, bounds.high[k])),
                                           hn::Ge(high, hn::Set(tag, bounds.low[k]))));
    }
    std::uint64_t some = 0;
    hn::StoreMaskBits(tag, overlaps, reinterpret_cast<std::uint8_t*>(&some));
    bits |= some << first;
  }
  return bits & ((std::uint64_t{1} << node.count) - 1);
}

void QueryNodes(const AabbTree::Node* nodes, int root, const Aabb& bounds,
                AabbTree::Scratch& scratch) {
  scratch.stack.assign(1, root);
  for (; !scratch.stack.empty(); ++scratch.nodes_visited) {
    const AabbTree::Node& node = nodes[scratch.stack.back()];
    scratch.stack.pop_back();
    std::vector<int>& into = node.level == 0 ? scratch.found : scratch.stack;
    for (std::uint64_t bits = OverlapMask(node, bounds); bits != 0; bits &= bits - 1) {
      into.push_back(node.children[static_cast<std::size_t>(std::countr_zero(bits))]);
    }
  }
}

}  // namespace
}  // namespace cookbook::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace cookbook {
void AabbTree::Query(const Aabb& bounds, Scratch& scratch) const {
  if (root_ >= 0) COOKBOOK_DISPATCH(QueryNodes)(nodes_.data(), root_, bounds, scratch);
}
}  // namespace cookbook
#endif
