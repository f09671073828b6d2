#include "engine/collision/collide.h"

// Vectors of four doubles: targets narrower than AVX2 are no faster than the baseline.
#define HWY_DISABLED_TARGETS \
  (HWY_SSSE3 | HWY_SSE4 | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/collision/box_box.cc"
#include <hwy/foreach_target.h>
// Must come after foreach_target.h.
#include "engine/simd/dispatch.h"
#include "engine/simd/four_lanes.h"
#include "engine/collision/one_pair_axis.h"
#include "engine/collision/one_pair_contacts.h"

HWY_BEFORE_NAMESPACE();
namespace cookbook {
namespace HWY_NAMESPACE {
namespace {

void CollideBoxes(const Box& A, const Pose& X_WA, const Box& B, const Pose& X_WB,
                  Manifold& manifold) {
  BoxPair pair;
  const AxisGap axis = Find<Search::kFirstGap>(A, X_WA, B, X_WB, pair);
  manifold.separation = axis.separation;
  manifold.touching = axis.separation <= 0;
  manifold.count = 0;
  if (axis.separation > 0 && axis.kind != AxisKind::kEdges) {
    manifold.n_AB_W = FaceNormal(axis, X_WA.R_WB, X_WB.R_WB);
    return;
  }
  const auto j = static_cast<std::size_t>(axis.j);
  const Facing facing =
      FacingOf(axis, pair.R[0][static_cast<std::size_t>(Next(axis.i))][j],
               pair.R[0][static_cast<std::size_t>(AfterNext(axis.i))][j]);
  manifold.n_AB_W = NormalInWorld(facing, X_WA.R_WB, X_WB.R_WB);
  if (manifold.touching) {
    FillContacts(pair, facing, X_WA, X_WB, manifold);
  }
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace cookbook
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace cookbook {
HWY_EXPORT(CollideBoxes);

void Collide(const Box& A, const Pose& X_WA, const Box& B, const Pose& X_WB,
             Manifold& manifold) {
  CallOnTarget<HWY_DISPATCH_TABLE(CollideBoxes)>(A, X_WA, B, X_WB, manifold);
}
}  // namespace cookbook
#endif
