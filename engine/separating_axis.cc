#include "engine/separating_axis.h"

#include <algorithm>
#include <cstddef>
#include <limits>

// Vectors of four doubles: what is wider brings nothing, what is narrower than AVX2 no
// more than the baseline.
#define HWY_DISABLED_TARGETS                                                          \
  (HWY_SSSE3 | HWY_SSE4 | HWY_AVX3 | HWY_AVX3_DL | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | \
   HWY_SVE2_128 | HWY_RVV)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/separating_axis.cc"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include <hwy/highway.h>

#include "engine/four_lanes.h"

HWY_BEFORE_NAMESPACE();
namespace cookbook {
namespace HWY_NAMESPACE {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Which axis wins cannot be foretold, and a branch guessed wrong costs as much as thirty
// multiplications: winners are counted out in integers and looked up in arrays.

/** Returns the first of the greatest of three numbers. */
HWY_INLINE std::size_t FirstGreatest(const Row& x) {
  const std::size_t greater = x[1] > x[0];
  return greater + (2 - greater) * static_cast<std::size_t>(x[2] > x[greater]);
}

/** Returns the greatest lane. */
HWY_INLINE double Greatest(Four x) {
  const Four greater = Max(x, __builtin_shufflevector(x, x, 2, 3, 0, 1));
  return std::max(greater[0], greater[1]);
}

/** The best edge axis for each edge of B, a lane each. */
struct EdgeLanes {
  Four signed_square;
  Four squared_length;
  Four gap;
  Four offset;
  FourBits i;
};

/** Keeps in each lane the greater of the gaps along unit axes. Compares gap |gap| against
 squared lengths, which orders like gap / length and leaves one root and one quotient for
 the winner. */
HWY_INLINE void KeepGreater(const EdgeLanes& other, EdgeLanes& edges) {
  const FourBits better = other.signed_square * edges.squared_length >
                          edges.signed_square * other.squared_length;
  edges.signed_square = better ? other.signed_square : edges.signed_square;
  edges.squared_length = better ? other.squared_length : edges.squared_length;
  edges.gap = better ? other.gap : edges.gap;
  edges.offset = better ? other.offset : edges.offset;
  edges.i = better ? other.i : edges.i;
}

/** The best edge axis for each edge of B; a separation is −∞ where all are parallel. */
struct alignas(32) StoredEdges {
  Row signed_square;
  Row squared_length;
  Row separation;
  Row sine;
  Row offset;
  std::array<std::int64_t, 4> i;
};

/** Returns the edge of B that has the best edge axis of all. */
HWY_INLINE std::size_t FindEdges(const Four h_A, const Four h_B, const Four t,
                                 const Four R[3], const Four abs_R[3],
                                 StoredEdges& found) {
  // Lane j of these is what belongs to the axis of B after j, and the one after that.
  const auto next = [](Four x)
                        HWY_ATTR { return __builtin_shufflevector(x, x, 1, 2, 0, 3); };
  const auto after_next = [](Four x) HWY_ATTR {
    return __builtin_shufflevector(x, x, 2, 0, 1, 3);
  };
  const Four h_B1 = next(h_B);
  const Four h_B2 = after_next(h_B);
  const Four next_R[3] = {next(R[0]), next(R[1]), next(R[2])};
  const Four after_next_R[3] = {after_next(R[0]), after_next(R[1]), after_next(R[2])};

  EdgeLanes best;
#pragma GCC unroll 3
  for (int i = 0; i < 3; ++i) {
    const int i1 = (i + 1) % 3;
    const int i2 = (i + 2) % 3;
    // |b_k · (a_i × b_j)|, not |R|: see kOverlapRounding.
    const Four abs_minor =
        Abs(next_R[i1] * after_next_R[i2] - next_R[i2] * after_next_R[i1]);
    const Four squared_length = R[i1] * R[i1] + R[i2] * R[i2];
    const Four reach = (Splat(h_A[i1]) * abs_R[i2] + Splat(h_A[i2]) * abs_R[i1]) +
                       (h_B1 * after_next(abs_minor) + h_B2 * next(abs_minor));
    const Four offset = Splat(t[i2]) * R[i1] - Splat(t[i1]) * R[i2];
    const Four gap = Abs(offset) - reach;
    // A parallel pair is worse than any; the fourth lane, of length 0, counts as one.
    const FourBits counts = squared_length > Splat(kParallelSquared);
    const EdgeLanes edges{counts ? gap * Abs(gap) : Splat(-kInfinity),
                          counts ? squared_length : Splat(1), gap, offset,
                          FourBits{i, i, i, i}};
    if (i == 0) {
      best = edges;
    } else {
      KeepGreater(edges, best);
    }
  }

  Store(best.signed_square, found.signed_square.data());
  Store(best.squared_length, found.squared_length.data());
  // Of all three, while the comparisons run: the verdict waits for both.
  const Four sines = Sqrt(best.squared_length);
  Store(Select(best.signed_square == Splat(-kInfinity), best.signed_square,
               best.gap / sines),
        found.separation.data());
  Store(sines, found.sine.data());
  Store(best.offset, found.offset.data());
  std::memcpy(found.i.data(), &best.i, sizeof best.i);
  const auto greater = [&](std::size_t p, std::size_t q) HWY_ATTR {
    return found.signed_square[p] * found.squared_length[q] >
           found.signed_square[q] * found.squared_length[p];
  };
  const std::size_t first = greater(1, 0);
  return first + (2 - first) * static_cast<std::size_t>(greater(2, first));
}

AxisGap Find(const Box& A, const Pose& X_WA, const Box& B, const Pose& X_WB,
             Search search, BoxPair& pair) {
  const double* a = X_WA.R_WB.data();  // a[3 i + k] is component k of axis i.
  const double* b = X_WB.R_WB.data();
  const double* p_WA = X_WA.p_WB.data();
  const double* p_WB = X_WB.p_WB.data();
  const auto axes = [](const double* R, Four out[3]) HWY_ATTR {
    const Four before_last = Load(R + 5);
    const Four rows[3] = {Load(R), Load(R + 3),
                          __builtin_shufflevector(before_last, before_last, 1, 2, 3, 0)};
    Transpose(rows, out);
  };
  Four axes_A[3];  // Lane i of [k]: component k of axis i.
  Four axes_B[3];
  axes(a, axes_A);
  axes(b, axes_B);
  const Four d[3] = {Splat(p_WB[0] - p_WA[0]), Splat(p_WB[1] - p_WA[1]),
                     Splat(p_WB[2] - p_WA[2])};
  // In the fourth lane both boxes are without end: it never separates.
  const Four h_A = Load3(A.half_extents.data(), kInfinity);
  const Four h_B = Load3(B.half_extents.data(), kInfinity);

  Four R[3];
  Four R_BA[3];
  Four abs_R[3];
#pragma GCC unroll 3
  for (int i = 0; i < 3; ++i) {
    R[i] = Splat(a[3 * i]) * axes_B[0] + Splat(a[3 * i + 1]) * axes_B[1] +
           Splat(a[3 * i + 2]) * axes_B[2];
    abs_R[i] = Abs(R[i]);
  }
  Transpose(R, R_BA);
  const Four p_AB_A = axes_A[0] * d[0] + axes_A[1] * d[1] + axes_A[2] * d[2];
  const Four p_AB_B = axes_B[0] * d[0] + axes_B[1] * d[1] + axes_B[2] * d[2];
  const Four gap_A =
      Abs(p_AB_A) - (h_A + (Splat(h_B[0]) * Abs(R_BA[0]) + Splat(h_B[1]) * Abs(R_BA[1]) +
                            Splat(h_B[2]) * Abs(R_BA[2])));
  const Four gap_B =
      Abs(p_AB_B) - (h_B + (Splat(h_A[0]) * abs_R[0] + Splat(h_A[1]) * abs_R[1] +
                            Splat(h_A[2]) * abs_R[2]));
  alignas(32) Row gaps_A;
  alignas(32) Row gaps_B;
  Store(gap_A, gaps_A.data());
  Store(gap_B, gaps_B.data());
  Store(p_AB_A, pair.p_AB_A.data());
  Store(p_AB_B, pair.p_AB_B.data());
  const std::size_t i = FirstGreatest(gaps_A);
  const std::size_t j = FirstGreatest(gaps_B);
  const double face_A = gaps_A[i];
  const double face_B = gaps_B[j];
  // Not the greater of those two: known sooner, and a branch waits for it.
  const double best_face = Greatest(Max(gap_A, gap_B));
  const auto Face = [&](bool is_B) HWY_ATTR {
    const double separations[] = {face_A, face_B};
    const double offsets[] = {pair.p_AB_A[i], pair.p_AB_B[j]};
    return AxisGap{static_cast<AxisKind>(is_B),
                   static_cast<int>(i),
                   static_cast<int>(j),
                   separations[is_B],
                   1,
                   offsets[is_B]};
  };
  if (search == Search::kFirstGap && best_face > 0) return Face(face_B > face_A);

  Store(h_A, pair.h_A.data());
  Store(h_B, pair.h_B.data());
#pragma GCC unroll 3
  for (std::size_t k = 0; k < 3; ++k) {
    Store(R[k], pair.R_AB[k].data());
    Store(R_BA[k], pair.R_BA[k].data());
  }
  StoredEdges edges;
  const std::size_t edge = FindEdges(h_A, h_B, p_AB_A, R, abs_R, edges);
  const double separation = edges.separation[edge];
  // No preference outweighs a gap: the verdict must not depend on it.
  const bool apart = std::max(best_face, separation) > 0;
  const double slack = apart ? 0 : kOverlapRounding * pair.Size();
  // Against the better face, not the preferred one: where the boxes share an axis, edge
  // axes are face normals to rounding, and their edges meet nowhere.
  if (separation > best_face + slack) {
    return {AxisKind::kEdges,       static_cast<int>(edges.i[edge]),
            static_cast<int>(edge), separation,
            edges.sine[edge],       edges.offset[edge]};
  }
  return Face(face_B > face_A + slack);
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace cookbook
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace cookbook {
HWY_EXPORT(Find);

AxisGap FindLeastOverlap(const Box& A, const Pose& X_WA, const Box& B, const Pose& X_WB,
                         Search search, BoxPair& pair) {
  return HWY_DYNAMIC_DISPATCH(Find)(A, X_WA, B, X_WB, search, pair);
}
}  // namespace cookbook
#endif
