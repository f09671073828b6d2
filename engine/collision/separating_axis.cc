#include "engine/collision/separating_axis.h"

// Vectors of four doubles: wider targets are no faster than AVX2, and narrower ones are
// no faster than the baseline.
#define HWY_DISABLED_TARGETS                                                          \
  (HWY_SSSE3 | HWY_SSE4 | HWY_AVX3 | HWY_AVX3_DL | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | \
   HWY_SVE2_128 | HWY_RVV)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/collision/separating_axis.cc"
#include <hwy/foreach_target.h>
// Must come after foreach_target.h.
#include "engine/simd/four_lanes.h"
#include "engine/collision/one_pair_axis.h"

HWY_BEFORE_NAMESPACE();
namespace cookbook {
namespace HWY_NAMESPACE {
namespace {

AxisGap FindGreatestGap(const Box& A, const Pose& X_WA, const Box& B, const Pose& X_WB,
                        BoxPair& pair) {
  return Find<Search::kGreatestGap>(A, X_WA, B, X_WB, pair);
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace cookbook
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace cookbook {
HWY_EXPORT(FindGreatestGap);

AxisGap FindLeastOverlap(const Box& A, const Pose& X_WA, const Box& B, const Pose& X_WB,
                         BoxPair& pair) {
  return HWY_DYNAMIC_DISPATCH(FindGreatestGap)(A, X_WA, B, X_WB, pair);
}
}  // namespace cookbook
#endif
