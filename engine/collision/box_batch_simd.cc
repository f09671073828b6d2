#include <cstddef>

#include "engine/collision/box_batch_layout.h"

#define COOKBOOK_DISABLED_TARGETS COOKBOOK_SIZELESS_TARGETS
#define HWY_TARGET_INCLUDE "engine/collision/box_batch_simd.cc"
#include "engine/simd/foreach_target.h"
// After foreach_target.h.
#include "engine/collision/many_pairs_axis.h"

HWY_BEFORE_NAMESPACE();
namespace cookbook::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

static_assert(kLanes == kMostPairs);

void FindLanes(const double* rows, std::size_t lane, const GapArrays& gaps,
               std::size_t pair) {
  const PairTag tag;
  const auto row = [&](std::size_t index)
                       HWY_ATTR { return hn::Load(tag, rows + index * kLanes + lane); };
  PairVector a[3][3];
  PairVector b[3][3];
  PairVector d[3];
  PairVector h_A[3];
  PairVector h_B[3];
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t c = 0; c < 3; ++c) {
      a[k][c] = row(kRotationRow + 3 * k + c);
      b[k][c] = row(kRowsOfB + kRotationRow + 3 * k + c);
    }
    d[k] = row(kRowsOfB + kPlaceRow + k) - row(kPlaceRow + k);
    h_A[k] = row(kHalfExtentsRow + k);
    h_B[k] = row(kRowsOfB + kHalfExtentsRow + k);
  }
  const AxesOfPairs found = FindLeastOverlaps(See(a, b, d, h_A, h_B));
  hn::StoreU(found.axis, tag, gaps.axis + pair);
  hn::StoreU(found.separation, tag, gaps.separation + pair);
  hn::StoreU(found.offset, tag, gaps.offset + pair);
  hn::StoreU(found.sine, tag, gaps.sine + pair);
}

void FindBlocks(const double* rows, std::size_t blocks, const GapArrays& gaps) {
  for (std::size_t block = 0; block < blocks; ++block) {
    for (std::size_t lane = 0; lane < kLanes; lane += hn::Lanes(PairTag())) {
      FindLanes(rows + block * kRows * kLanes, lane, gaps, block * kLanes + lane);
    }
  }
}

}  // namespace
}  // namespace cookbook::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace cookbook {
void FindBlockGaps(const double* rows, std::size_t blocks, const GapArrays& gaps) {
  COOKBOOK_DISPATCH(FindBlocks)(rows, blocks, gaps);
}
}  // namespace cookbook
#endif
