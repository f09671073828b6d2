// The separating-axis test of a vector of pairs: FindLeastOverlap() of
// engine/collision/one_pair_axis.h, operation by operation. Same products, same sums,
// same order, no fused multiply-add, hence same bits. Include it after hwy/highway.h, in
// a file that foreach_target.h includes repeatedly; hence the include guard that toggles.

#if defined(COOKBOOK_ENGINE_MANY_PAIRS_AXIS_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef COOKBOOK_ENGINE_MANY_PAIRS_AXIS_H_
#undef COOKBOOK_ENGINE_MANY_PAIRS_AXIS_H_
#else
#define COOKBOOK_ENGINE_MANY_PAIRS_AXIS_H_
#endif

#include <cstddef>
#include <limits>

#include <hwy/highway.h>

#include "engine/collision/rounding.h"

HWY_BEFORE_NAMESPACE();
namespace cookbook {
namespace HWY_NAMESPACE {

/** Greatest number of pairs at once: the lanes of the widest vector of doubles in use. */
inline constexpr std::size_t kMostPairs = 8;

using PairTag = hwy::HWY_NAMESPACE::CappedTag<double, kMostPairs>;
/** One number per pair. */
using PairVector = hwy::HWY_NAMESPACE::Vec<PairTag>;
/** One truth value per pair. */
using PairMask = hwy::HWY_NAMESPACE::Mask<PairTag>;

HWY_INLINE PairVector All(double x) {
  return hwy::HWY_NAMESPACE::Set(PairTag(), x);
}

HWY_INLINE PairVector Dot(const PairVector a[3], const PairVector b[3]) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/** The relative geometry of pairs of boxes. */
struct SeenPairs {
  // Written out because on some targets (arm64) a vector's constructor is compiled for
  // that target only, and the implicit constructor of this struct may not call it.
  HWY_INLINE SeenPairs() {}

  PairVector h_A[3];
  PairVector h_B[3];
  PairVector p_AB_A[3];  ///< Centre of B relative to that of A, in the frame of A. [m]
  PairVector p_AB_B[3];
  PairVector R[3][3];  ///< a_i · b_j.
  PairVector abs_R[3][3];
  PairVector reach_A[3];  ///< Sum of both boxes' reaches along each axis of A. [m]
  PairVector reach_B[3];
};

/** Returns the relative geometry of boxes, given their axes, B's centre relative to A's,
 and their half extents. */
HWY_INLINE SeenPairs See(const PairVector a[3][3], const PairVector b[3][3],
                         const PairVector d[3], const PairVector h_A[3],
                         const PairVector h_B[3]) {
  SeenPairs seen;
  for (std::size_t i = 0; i < 3; ++i) {
    seen.h_A[i] = h_A[i];
    seen.h_B[i] = h_B[i];
    seen.p_AB_A[i] = Dot(a[i], d);
    seen.p_AB_B[i] = Dot(b[i], d);
    for (std::size_t j = 0; j < 3; ++j) {
      seen.R[i][j] = Dot(a[i], b[j]);
      seen.abs_R[i][j] = hwy::HWY_NAMESPACE::Abs(seen.R[i][j]);
    }
    seen.reach_A[i] = h_A[i] + Dot(h_B, seen.abs_R[i]);
  }
  for (std::size_t j = 0; j < 3; ++j) {
    const PairVector column[3] = {seen.abs_R[0][j], seen.abs_R[1][j], seen.abs_R[2][j]};
    seen.reach_B[j] = h_B[j] + Dot(h_A, column);
  }
  return seen;
}

/** Returns the unit of the rounding bounds, see BoxPair::size. [m] */
HWY_INLINE PairVector SizeOf(const SeenPairs& seen) {
  namespace hn = hwy::HWY_NAMESPACE;
  const auto sum = [](const PairVector v[3]) HWY_ATTR { return v[0] + v[1] + v[2]; };
  const PairVector way[3] = {hn::Abs(seen.p_AB_A[0]), hn::Abs(seen.p_AB_A[1]),
                             hn::Abs(seen.p_AB_A[2])};
  return sum(way) + (sum(seen.h_A) + sum(seen.h_B));
}

/** The axis found for each pair: the fields of AxisGap. */
struct AxesOfPairs {
  PairVector axis;        ///< 0…2 faces of A, 3…5 of B, 6 + 3 i + j edges.
  PairVector separation;  ///< [m]
  PairVector offset;      ///< [m]
  PairVector sine;        ///< 1 for a face.
};

/** The best axis so far of each pair. */
struct BestAxes {
  PairVector axis;
  PairVector separation;
  PairVector offset;
};

HWY_INLINE void Keep(PairMask better, PairVector axis, PairVector separation,
                     PairVector offset, BestAxes& best) {
  namespace hn = hwy::HWY_NAMESPACE;
  best.axis = hn::IfThenElse(better, axis, best.axis);
  best.separation = hn::IfThenElse(better, separation, best.separation);
  best.offset = hn::IfThenElse(better, offset, best.offset);
}

/** Returns the best face of a box, given B's centre relative to A's and both boxes' reach
 along its axes. `first` is the number of its first face. */
HWY_INLINE BestAxes FindFaces(double first, const PairVector offset[3],
                              const PairVector reach[3]) {
  namespace hn = hwy::HWY_NAMESPACE;
  BestAxes best{All(first), hn::Abs(offset[0]) - reach[0], offset[0]};
  for (std::size_t k = 1; k < 3; ++k) {
    const PairVector gap = hn::Abs(offset[k]) - reach[k];
    Keep(hn::Gt(gap, best.separation), All(first + static_cast<double>(k)), gap,
         offset[k], best);
  }
  return best;
}

/** The best edge axis so far of each pair. */
struct BestEdges {
  BestAxes best;
  PairVector signed_square;
  PairVector squared_length;
};

HWY_INLINE void KeepGreater(const BestEdges& other, BestEdges& edges) {
  namespace hn = hwy::HWY_NAMESPACE;
  const PairMask better = hn::Gt(other.signed_square * edges.squared_length,
                                 edges.signed_square * other.squared_length);
  Keep(better, other.best.axis, other.best.separation, other.best.offset, edges.best);
  edges.signed_square = hn::IfThenElse(better, other.signed_square, edges.signed_square);
  edges.squared_length =
      hn::IfThenElse(better, other.squared_length, edges.squared_length);
}

/** Returns the axis of least overlap, or of greatest gap, of each pair. */
HWY_INLINE AxesOfPairs FindLeastOverlaps(const SeenPairs& seen) {
  namespace hn = hwy::HWY_NAMESPACE;
  const auto& [h_A, h_B, t, p_AB_B, R, abs_R, reach_A, reach_B] = seen;
  const BestAxes face_A = FindFaces(0, t, reach_A);
  const BestAxes face_B = FindFaces(3, p_AB_B, reach_B);

  // First the best axis of each edge of B over the edges of A, then the best of the
  // three. A parallel pair is worse than any: the square of its gap counts as −∞.
  const PairVector zero = All(0);
  const PairVector one = All(1);
  const PairVector worst = All(-std::numeric_limits<double>::infinity());
  const PairVector parallel = All(kParallelSquared);
  const BestEdges none{{zero, zero, zero}, worst, one};
  BestEdges of_B[3] = {none, none, none};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t i1 = (i + 1) % 3;
    const std::size_t i2 = (i + 2) % 3;
    PairVector abs_minor[3];
    for (std::size_t j = 0; j < 3; ++j) {
      const std::size_t j1 = (j + 1) % 3;
      const std::size_t j2 = (j + 2) % 3;
      abs_minor[j] = hn::Abs(R[i1][j1] * R[i2][j2] - R[i2][j1] * R[i1][j2]);
    }
    for (std::size_t j = 0; j < 3; ++j) {
      const std::size_t j1 = (j + 1) % 3;
      const std::size_t j2 = (j + 2) % 3;
      const PairVector squared_length = R[i1][j] * R[i1][j] + R[i2][j] * R[i2][j];
      const PairVector reach = (h_A[i1] * abs_R[i2][j] + h_A[i2] * abs_R[i1][j]) +
                               (h_B[j1] * abs_minor[j2] + h_B[j2] * abs_minor[j1]);
      const PairVector offset = t[i2] * R[i1][j] - t[i1] * R[i2][j];
      const PairVector gap = hn::Abs(offset) - reach;
      const PairMask counts = hn::Gt(squared_length, parallel);
      const BestEdges edges{{All(static_cast<double>(6 + 3 * i + j)), gap, offset},
                            hn::IfThenElse(counts, gap * hn::Abs(gap), worst),
                            hn::IfThenElse(counts, squared_length, one)};
      if (i == 0) {
        of_B[j] = edges;
      } else {
        KeepGreater(edges, of_B[j]);
      }
    }
  }
  KeepGreater(of_B[1], of_B[0]);
  KeepGreater(of_B[2], of_B[0]);
  const BestAxes& edges = of_B[0].best;

  const PairVector sine = hn::Sqrt(of_B[0].squared_length);
  const PairVector edge_separation = edges.separation / sine;
  const PairVector best_face = hn::Max(face_A.separation, face_B.separation);
  const PairVector best_gap = hn::Max(best_face, edge_separation);
  const PairMask apart = hn::Gt(best_gap, zero);
  const PairVector tolerance = hn::IfThenElse(apart, zero, All(kTie) * SizeOf(seen));
  BestAxes best = face_A;
  Keep(hn::Gt(best_gap, face_A.separation + tolerance), face_B.axis, face_B.separation,
       face_B.offset, best);
  const PairMask edge_wins = hn::And(hn::Gt(of_B[0].signed_square, worst),
                                     hn::Gt(edge_separation, best_face + tolerance));
  Keep(edge_wins, edges.axis, edge_separation, edges.offset, best);
  return {best.axis, best.separation, best.offset, hn::IfThenElse(edge_wins, sine, one)};
}

}  // namespace HWY_NAMESPACE
}  // namespace cookbook
HWY_AFTER_NAMESPACE();

#endif
