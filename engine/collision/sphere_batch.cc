// FindGap() of engine/collision/sphere_sphere.cc, operation by operation, for a vector of
// pairs.

#include "engine/collision/sphere_batch.h"

#include "engine/collision/rounding.h"

#define COOKBOOK_DISABLED_TARGETS COOKBOOK_SIZELESS_TARGETS
#define HWY_TARGET_INCLUDE "engine/collision/sphere_batch.cc"
#include "engine/simd/foreach_target.h"

HWY_BEFORE_NAMESPACE();
namespace cookbook::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

void FindSeparations(std::span<const SphereBlock> blocks, double* separations) {
  using Tag = hn::CappedTag<double, 8>;
  const Tag tag;
  const hn::Vec<Tag> least = hn::Set(tag, kLeastSquaredLength);
  for (const SphereBlock& block : blocks) {
    for (std::size_t lane = 0; lane < 8; lane += hn::Lanes(tag)) {
      const auto from = [&](const SphereBlock::Lanes& lanes)
                            HWY_ATTR { return hn::Load(tag, lanes.data() + lane); };
      const hn::Vec<Tag> x = from(block.p_WB[0]) - from(block.p_WA[0]);
      const hn::Vec<Tag> y = from(block.p_WB[1]) - from(block.p_WA[1]);
      const hn::Vec<Tag> z = from(block.p_WB[2]) - from(block.p_WA[2]);
      const hn::Vec<Tag> squared = x * x + y * y + z * z;
      const hn::Vec<Tag> distance =
          hn::IfThenZeroElse(hn::Lt(squared, least), hn::Sqrt(squared));
      hn::StoreU(distance - (from(block.radius_A) + from(block.radius_B)), tag,
                 separations + lane);
    }
    separations += 8;
  }
}

}  // namespace
}  // namespace cookbook::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace cookbook {
SphereBatch::SphereBatch(std::size_t size)
    : size_(size), blocks_((size + 7) / 8), separations_(blocks_.size() * 8) {}

void SphereBatch::Set(std::size_t index, const Sphere& A, const Pose& X_WA,
                      const Sphere& B, const Pose& X_WB) {
  SphereBlock& block = blocks_[index / 8];
  const std::size_t lane = index % 8;
  for (std::size_t k = 0; k < 3; ++k) {
    block.p_WA[k][lane] = X_WA.p_WB.data()[k];
    block.p_WB[k][lane] = X_WB.p_WB.data()[k];
  }
  block.radius_A[lane] = A.radius;
  block.radius_B[lane] = B.radius;
}

void SphereBatch::FindGaps() {
  COOKBOOK_DISPATCH(FindSeparations)(blocks_, separations_.data());
}
}  // namespace cookbook
#endif
