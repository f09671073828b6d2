#include "engine/dynamics/near_boxes.h"

// Vectors of four doubles: what is wider brings nothing, what is narrower than AVX2 no
// more than the baseline.
#define HWY_DISABLED_TARGETS                                                          \
  (HWY_SSSE3 | HWY_SSE4 | HWY_AVX3 | HWY_AVX3_DL | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | \
   HWY_SVE2_128 | HWY_RVV)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/dynamics/near_boxes.cc"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include "engine/four_lanes.h"
#include "engine/one_pair_axis.h"
#include "engine/one_pair_contacts.h"

HWY_BEFORE_NAMESPACE();
namespace cookbook {
namespace HWY_NAMESPACE {
namespace {

/** Cosine of the angle between the normal of two edges and that of a face up to which
 the faces are taken to meet. Nearly parallel faces meet in a patch whose corners have
 depths of their own; the one contact of two edges would let the boxes rock on it. */
constexpr double kNearlyFace = 0.98;

/** The face of a box that is most across the normal, and how it is turned. */
struct NearFace {
  std::size_t axis;
  double cosine;  ///< Of the axis with the normal.
  double gap;     ///< Along the axis, on the side of the normal. [m]
  Eigen::Vector3d n_W;
};

/** `t` is the centre of B from that of A in the frame of the box, `h` its half extents;
 row k of `R` has axis k in the frame of the other box. */
HWY_INLINE NearFace Near(std::size_t axis, double cosine, const Row& t, const Row& h,
                         const std::array<Row, 3>& R, const Row& h_other,
                         const Eigen::Matrix3d& R_WB) {
  const double side = cosine < 0 ? -1 : 1;
  const Row& r = R[axis];
  const double reach = h_other[0] * std::abs(r[0]) + h_other[1] * std::abs(r[1]) +
                       h_other[2] * std::abs(r[2]);
  // Summed as the search sums it.
  return {axis, cosine, side * t[axis] - (h[axis] + reach),
          side * R_WB.col(static_cast<Eigen::Index>(axis))};
}

bool NearFaces(double margin, const Box& A, const Pose& X_WA, const Box& B,
               const Pose& X_WB, const Eigen::Vector3d& n_guess_W, Manifold& manifold) {
  BoxPair pair;
  const AxisGap axis = Find<Search::kGreatestGap>(A, X_WA, B, X_WB, pair);
  const auto j = static_cast<std::size_t>(axis.j);
  const Facing facing =
      FacingOf(axis, pair.R[0][static_cast<std::size_t>(Next(axis.i))][j],
               pair.R[0][static_cast<std::size_t>(AfterNext(axis.i))][j]);
  manifold.n_AB_W = NormalInWorld(facing, X_WA.R_WB, X_WB.R_WB);
  manifold.separation = axis.separation;
  manifold.touching = axis.separation <= 0;
  manifold.count = 0;
  if (axis.separation > margin) return true;

  // The normal in the frame of the box that it is not given in.
  const std::array<Row, 3>& axes = pair.R[facing.is_B];
  const auto own = static_cast<std::size_t>(facing.axis);
  const auto lean = static_cast<std::size_t>(facing.lean);
  const Four n = Splat(facing.n_axis) * Load(axes[own].data()) +
                 Splat(facing.n_lean) * Load(axes[lean].data());
  const std::size_t other = FirstGreatest(Abs(n));
  alignas(32) Row n_other;
  Store(n, n_other.data());
  const NearFace face_A =
      Near(facing.is_B ? other : own, facing.is_B ? n_other[other] : facing.n_axis,
           pair.p_AB[0], pair.h[0], pair.R[0], pair.h[1], X_WA.R_WB);
  const NearFace face_B =
      Near(facing.is_B ? own : other, facing.is_B ? facing.n_axis : n_other[other],
           pair.p_AB[1], pair.h[1], pair.R[1], pair.h[0], X_WB.R_WB);
  if (std::max(std::abs(face_A.cosine), std::abs(face_B.cosine)) < kNearlyFace &&
      axis.separation > std::max(face_A.gap, face_B.gap) + margin) {
    return false;
  }
  // The face with the greater gap is the reference, but not by rounding: the one that was
  // it in the last step stays it within the margin, and A's where there is none.
  const bool was_B = n_guess_W.dot(face_B.n_W) > n_guess_W.dot(face_A.n_W);
  const bool is_B = was_B ? face_B.gap + 0.5 * margin > face_A.gap
                          : face_B.gap > face_A.gap + 0.5 * margin;
  const NearFace& reference = is_B ? face_B : face_A;
  const auto face = static_cast<int>(reference.axis);
  manifold.n_AB_W = reference.n_W;
  manifold.separation = reference.gap;
  FillContacts<Keep::kNear>(
      pair, {is_B, face, Next(face), std::copysign(1.0, reference.cosine), 0}, X_WA, X_WB,
      margin, manifold);
  return true;
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace cookbook
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace cookbook {
HWY_EXPORT(NearFaces);

bool CollideNearFaces(double margin, const Box& A, const Pose& X_WA, const Box& B,
                      const Pose& X_WB, const Eigen::Vector3d& n_guess_W,
                      Manifold& manifold) {
  return HWY_DYNAMIC_DISPATCH(NearFaces)(margin, A, X_WA, B, X_WB, n_guess_W, manifold);
}
}  // namespace cookbook
#endif
