#include "engine/collision/separating_axis.h"

// Vectors of four doubles: wider registers than those of AVX2 bring nothing.
#define COOKBOOK_DISABLED_TARGETS \
  (COOKBOOK_SIZELESS_TARGETS | COOKBOOK_NARROW_TARGETS | HWY_AVX3 | HWY_AVX3_DL)
#define HWY_TARGET_INCLUDE "engine/collision/separating_axis.cc"
#include "engine/simd/foreach_target.h"
// After foreach_target.h.
#include "engine/collision/one_pair_axis.h"
#include "engine/simd/four_lanes.h"

HWY_BEFORE_NAMESPACE();
namespace cookbook::HWY_NAMESPACE {
namespace {

AxisGap FindGreatestGap(const Box& A, const Pose& X_WA, const Box& B, const Pose& X_WB,
                        BoxPair& pair) {
  return Find<Search::kGreatestGap>(A, X_WA, B, X_WB, pair);
}

}  // namespace
}  // namespace cookbook::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace cookbook {
AxisGap FindLeastOverlap(const Box& A, const Pose& X_WA, const Box& B, const Pose& X_WB,
                         BoxPair& pair) {
  return COOKBOOK_DISPATCH(FindGreatestGap)(A, X_WA, B, X_WB, pair);
}
}  // namespace cookbook
#endif
