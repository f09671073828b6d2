#include "engine/collision/collide.h"

#define COOKBOOK_DISABLED_TARGETS (COOKBOOK_SIZELESS_TARGETS | COOKBOOK_NARROW_TARGETS)
#define HWY_TARGET_INCLUDE "engine/collision/box_box.cc"
#include "engine/simd/foreach_target.h"
// After foreach_target.h.
#include "engine/collision/one_pair_axis.h"
#include "engine/collision/one_pair_contacts.h"
#include "engine/simd/four_lanes.h"

HWY_BEFORE_NAMESPACE();
namespace cookbook::HWY_NAMESPACE {
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
}  // namespace cookbook::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace cookbook {
void Collide(const Box& A, const Pose& X_WA, const Box& B, const Pose& X_WB,
             Manifold& manifold) {
  COOKBOOK_DISPATCH(CollideBoxes)(A, X_WA, B, X_WB, manifold);
}
}  // namespace cookbook
#endif
