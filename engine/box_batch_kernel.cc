// FindLeastOverlap() of engine/one_pair_axis.h, operation by
// operation, for a vector of pairs: same products, same sums, same order, no fused
// multiply-add, hence same bits.

#include <cstddef>
#include <limits>

#include "engine/box_batch_layout.h"
#include "engine/rounding.h"

// Vectors without a size at compile time cannot be kept in arrays.
#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/box_batch_kernel.cc"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace cookbook {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using Tag = hn::CappedTag<double, kLanes>;
using Vector = hn::Vec<Tag>;

HWY_INLINE Vector Dot(const Vector a[3], const Vector b[3]) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/** The best axis so far of each lane. */
struct Best {
  Vector axis;
  Vector separation;
  Vector offset;
};

HWY_INLINE void Keep(hn::Mask<Tag> better, Vector axis, Vector separation, Vector offset,
                     Best& best) {
  best.axis = hn::IfThenElse(better, axis, best.axis);
  best.separation = hn::IfThenElse(better, separation, best.separation);
  best.offset = hn::IfThenElse(better, offset, best.offset);
}

/** The best edge axis so far of each lane. */
struct BestEdges {
  Best best;
  Vector signed_square;
  Vector squared_length;
};

HWY_INLINE void KeepGreater(const BestEdges& other, BestEdges& edges) {
  const auto better = hn::Gt(other.signed_square * edges.squared_length,
                             edges.signed_square * other.squared_length);
  Keep(better, other.best.axis, other.best.separation, other.best.offset, edges.best);
  edges.signed_square = hn::IfThenElse(better, other.signed_square, edges.signed_square);
  edges.squared_length =
      hn::IfThenElse(better, other.squared_length, edges.squared_length);
}

HWY_INLINE void FindLanes(const double* rows, std::size_t lane, const GapArrays& gaps,
                          std::size_t pair) {
  const Tag tag;
  const auto Row = [&](std::size_t row)
                       HWY_ATTR { return hn::Load(tag, rows + row * kLanes + lane); };
  Vector a[3][3];
  Vector b[3][3];
  Vector d[3];
  Vector h_A[3];
  Vector h_B[3];
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t c = 0; c < 3; ++c) {
      a[k][c] = Row(kRotationRow + 3 * k + c);
      b[k][c] = Row(kRowsOfB + kRotationRow + 3 * k + c);
    }
    d[k] = Row(kRowsOfB + kPlaceRow + k) - Row(kPlaceRow + k);
    h_A[k] = Row(kHalfExtentsRow + k);
    h_B[k] = Row(kRowsOfB + kHalfExtentsRow + k);
  }

  const Vector one = hn::Set(tag, 1.0);
  Vector R[3][3];
  Vector abs_R[3][3];
  Vector t[3];
  const Vector zero = hn::Zero(tag);
  Best face_A{zero, zero, zero};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      R[i][j] = Dot(a[i], b[j]);
      abs_R[i][j] = hn::Abs(R[i][j]);
    }
    t[i] = Dot(a[i], d);
    const Vector gap = hn::Abs(t[i]) - (h_A[i] + Dot(h_B, abs_R[i]));
    const Vector axis = hn::Set(tag, static_cast<double>(i));
    if (i == 0) {
      face_A = {axis, gap, t[i]};
    } else {
      Keep(hn::Gt(gap, face_A.separation), axis, gap, t[i], face_A);
    }
  }

  Best face_B{zero, zero, zero};
  for (std::size_t j = 0; j < 3; ++j) {
    const Vector offset = Dot(b[j], d);
    const Vector column[3] = {abs_R[0][j], abs_R[1][j], abs_R[2][j]};
    const Vector gap = hn::Abs(offset) - (h_B[j] + Dot(h_A, column));
    const Vector axis = hn::Set(tag, static_cast<double>(3 + j));
    if (j == 0) {
      face_B = {axis, gap, offset};
    } else {
      Keep(hn::Gt(gap, face_B.separation), axis, gap, offset, face_B);
    }
  }

  // The best of each edge of B over those of A, then the best of the three. A parallel
  // pair is worse than any: the square of its gap counts as −∞.
  const Vector worst = hn::Set(tag, -std::numeric_limits<double>::infinity());
  const Vector parallel = hn::Set(tag, kParallelSquared);
  // Filled by hand: where a vector's constructor is for the target alone (arm64), the one
  // that the compiler would make for this struct may not call it.
  const BestEdges none{{zero, zero, zero}, worst, one};
  BestEdges of_B[3] = {none, none, none};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t i1 = (i + 1) % 3;
    const std::size_t i2 = (i + 2) % 3;
    Vector abs_minor[3];
    for (std::size_t j = 0; j < 3; ++j) {
      const std::size_t j1 = (j + 1) % 3;
      const std::size_t j2 = (j + 2) % 3;
      abs_minor[j] = hn::Abs(R[i1][j1] * R[i2][j2] - R[i2][j1] * R[i1][j2]);
    }
    for (std::size_t j = 0; j < 3; ++j) {
      const std::size_t j1 = (j + 1) % 3;
      const std::size_t j2 = (j + 2) % 3;
      const Vector squared_length = R[i1][j] * R[i1][j] + R[i2][j] * R[i2][j];
      const Vector reach = (h_A[i1] * abs_R[i2][j] + h_A[i2] * abs_R[i1][j]) +
                           (h_B[j1] * abs_minor[j2] + h_B[j2] * abs_minor[j1]);
      const Vector offset = t[i2] * R[i1][j] - t[i1] * R[i2][j];
      const Vector gap = hn::Abs(offset) - reach;
      const auto counts = hn::Gt(squared_length, parallel);
      const BestEdges edges{
          {hn::Set(tag, static_cast<double>(6 + 3 * i + j)), gap, offset},
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
  const Best& edges = of_B[0].best;

  const Vector size = (hn::Abs(t[0]) + hn::Abs(t[1]) + hn::Abs(t[2])) +
                      ((h_A[0] + h_A[1] + h_A[2]) + (h_B[0] + h_B[1] + h_B[2]));
  const Vector sine = hn::Sqrt(of_B[0].squared_length);
  const Vector edge_separation = edges.separation / sine;
  const Vector best_face = hn::Max(face_A.separation, face_B.separation);
  const Vector best_gap = hn::Max(best_face, edge_separation);
  const auto apart = hn::Gt(best_gap, zero);
  const Vector slack = hn::IfThenElse(apart, zero, hn::Set(tag, kTie) * size);
  Best best = face_A;
  Keep(hn::Gt(best_gap, face_A.separation + slack), face_B.axis, face_B.separation,
       face_B.offset, best);
  const auto edge_wins = hn::And(hn::Gt(of_B[0].signed_square, worst),
                                 hn::Gt(edge_separation, best_face + slack));
  Keep(edge_wins, edges.axis, edge_separation, edges.offset, best);

  hn::StoreU(best.axis, tag, gaps.axis + pair);
  hn::StoreU(best.separation, tag, gaps.separation + pair);
  hn::StoreU(best.offset, tag, gaps.offset + pair);
  hn::StoreU(hn::IfThenElse(edge_wins, sine, one), tag, gaps.sine + pair);
}

void FindBlocks(const double* rows, std::size_t blocks, const GapArrays& gaps) {
  for (std::size_t block = 0; block < blocks; ++block) {
    for (std::size_t lane = 0; lane < kLanes; lane += hn::Lanes(Tag())) {
      FindLanes(rows + block * kRows * kLanes, lane, gaps, block * kLanes + lane);
    }
  }
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace cookbook
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace cookbook {
HWY_EXPORT(FindBlocks);

void FindBlockGaps(const double* rows, std::size_t blocks, const GapArrays& gaps) {
  HWY_DYNAMIC_DISPATCH(FindBlocks)(rows, blocks, gaps);
}
}  // namespace cookbook
#endif
