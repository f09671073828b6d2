// The separating-axis test of one pair of boxes: FindLeastOverlap() as compiled once per
// SIMD target. Include it after engine/simd/four_lanes.h, in a file that foreach_target.h
// includes repeatedly; hence the include guard that toggles.

#if defined(COOKBOOK_ENGINE_ONE_PAIR_AXIS_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef COOKBOOK_ENGINE_ONE_PAIR_AXIS_H_
#undef COOKBOOK_ENGINE_ONE_PAIR_AXIS_H_
#else
#define COOKBOOK_ENGINE_ONE_PAIR_AXIS_H_
#endif

#include <algorithm>
#include <bit>
#include <cstddef>
#include <limits>

#include "engine/collision/separating_axis.h"
#include "engine/simd/four_lanes.h"

HWY_BEFORE_NAMESPACE();
namespace cookbook {
namespace HWY_NAMESPACE {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// The winning axis is unpredictable, and a mispredicted branch costs as much as thirty
// multiplications: winners are computed as integers and looked up in arrays.

/** Returns the greatest of the first three lanes, in each of those lanes. */
HWY_INLINE Four Greatest3(Four x) {
  const Four greater = Max(x, __builtin_shufflevector(x, x, 1, 0, 1, 3));
  return Max(greater, __builtin_shufflevector(x, x, 2, 2, 0, 3));
}

/** Returns the index of the first lane that is the greatest of the first three. */
HWY_INLINE std::size_t FirstGreatest(Four x) {
  const unsigned bits = Bits(x == Greatest3(x));
  return static_cast<std::size_t>(std::countr_zero(bits | 4));
}

/** Returns the greatest value of all four lanes. */
HWY_INLINE double Greatest(Four x) {
  const Four greater = Max(x, __builtin_shufflevector(x, x, 2, 3, 0, 1));
  return std::max(greater[0], greater[1]);
}

/** The best edge axis so far for each edge of B, one lane each. */
struct EdgeLanes {
  Four signed_square;
  Four squared_length;
  Four gap;
  Four offset;
  FourBits i;
};

/** Keeps in each lane the edge axis with the greater gap along its unit vector. Compares
 the quotients gap |gap| / squared length, multiplied out. They order like gap / length,
 which leaves one root and one quotient for the winner. */
HWY_INLINE void KeepGreater(const EdgeLanes& other, EdgeLanes& edges) {
  const FourBits better = other.signed_square * edges.squared_length >
                          edges.signed_square * other.squared_length;
  edges.signed_square = better ? other.signed_square : edges.signed_square;
  edges.squared_length = better ? other.squared_length : edges.squared_length;
  edges.gap = better ? other.gap : edges.gap;
  edges.offset = better ? other.offset : edges.offset;
  edges.i = better ? other.i : edges.i;
}

/** The candidates of the search, one row per AxisKind. The rows of faces have one lane
 per face; the row of edges has one lane per edge of B, for its best edge axis. A
 separation is −∞ if all edge axes of a lane are parallel pairs. */
struct alignas(32) Candidates {
  std::array<Row, 3> separation;
  std::array<Row, 3> offset;
  Row per_sine;                   ///< 1 / |a_i × b_j| of the edge axes.
  std::array<std::int64_t, 4> i;  ///< Axis of A of the edge axes.
};

/** Finds the best edge axis of each edge of B. Returns the edge of B with the best of
 all. */
HWY_INLINE std::size_t FindEdges(const Four h_A, const Four h_B, const Four t,
                                 const Four R[3], const Four abs_R[3],
                                 Candidates& found) {
  // Lane j of the result belongs to the axis of B after j, or to the one after that.
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
    // A parallel pair is worse than any. The fourth lane, of length 0, counts as
    // parallel.
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

  constexpr auto kRow = static_cast<std::size_t>(AxisKind::kEdges);
  // Computed for all three edges while the comparisons run: the verdict waits for both.
  const Four sines = Sqrt(best.squared_length);
  Store(Select(best.signed_square == Splat(-kInfinity), best.signed_square,
               best.gap / sines),
        found.separation[kRow].data());
  Store(Splat(1) / sines, found.per_sine.data());
  Store(best.offset, found.offset[kRow].data());
  std::memcpy(found.i.data(), &best.i, sizeof best.i);
  // Compares edge 1 with 0, 2 with 0, and 2 with 1.
  const auto one = [](Four x)
                       HWY_ATTR { return __builtin_shufflevector(x, x, 1, 2, 2, 3); };
  const auto other = [](Four x)
                         HWY_ATTR { return __builtin_shufflevector(x, x, 0, 0, 1, 3); };
  const unsigned better = Bits(one(best.signed_square) * other(best.squared_length) >
                               other(best.signed_square) * one(best.squared_length));
  // Two bits per outcome: edge 2 if it beats the better of 0 and 1, else the better one.
  return 0b10'10'10'00'01'10'01'00 >> (2 * better) & 3;
}

/** A BoxPair in registers. */
struct SeenPair {
  Four h_A;
  Four h_B;
  Four p_AB_A;
  Four p_AB_B;
  Four R_AB[3];
  Four R_BA[3];
};

/** Returns the relative geometry of two boxes. In the fourth lane both are infinite. */
HWY_INLINE SeenPair See(const Box& A, const Pose& X_WA, const Box& B, const Pose& X_WB) {
  const double* p_WA = X_WA.p_WB.data();
  const double* p_WB = X_WB.p_WB.data();
  const auto axes = [](const double* R, Four out[3]) HWY_ATTR {
    Four columns[3];
    LoadColumns(R, columns);
    Transpose(columns, out);
  };
  Four axes_A[3];  // Lane i of [k]: component k of axis i.
  Four axes_B[3];
  axes(X_WA.R_WB.data(), axes_A);
  axes(X_WB.R_WB.data(), axes_B);
  const Four d[3] = {Splat(p_WB[0] - p_WA[0]), Splat(p_WB[1] - p_WA[1]),
                     Splat(p_WB[2] - p_WA[2])};
  SeenPair seen;
  seen.h_A = Load3(A.half_extents.data(), kInfinity);
  seen.h_B = Load3(B.half_extents.data(), kInfinity);
  seen.p_AB_A = axes_A[0] * d[0] + axes_A[1] * d[1] + axes_A[2] * d[2];
  seen.p_AB_B = axes_B[0] * d[0] + axes_B[1] * d[1] + axes_B[2] * d[2];
#pragma GCC unroll 3
  for (int i = 0; i < 3; ++i) {
    const double* a_i = X_WA.R_WB.col(i).data();
    seen.R_AB[i] =
        Splat(a_i[0]) * axes_B[0] + Splat(a_i[1]) * axes_B[1] + Splat(a_i[2]) * axes_B[2];
  }
  Transpose(seen.R_AB, seen.R_BA);
  return seen;
}

HWY_INLINE void Store(const SeenPair& seen, BoxPair& pair) {
  const auto sum = [](Four x) HWY_ATTR { return x[0] + x[1] + x[2]; };
  pair.size = sum(Abs(seen.p_AB_A)) + (sum(seen.h_A) + sum(seen.h_B));
  Store(seen.h_A, pair.h[0].data());
  Store(seen.h_B, pair.h[1].data());
  Store(seen.p_AB_A, pair.p_AB[0].data());
  Store(seen.p_AB_B, pair.p_AB[1].data());
#pragma GCC unroll 3
  for (std::size_t k = 0; k < 3; ++k) {
    Store(seen.R_AB[k], pair.R[0][k].data());
    Store(seen.R_BA[k], pair.R[1][k].data());
  }
}

/** The implementation of FindLeastOverlap(). With Search::kFirstGap it may return any
 axis of positive gap, and `pair` may then be incomplete. */
template <Search search>
HWY_INLINE AxisGap Find(const Box& A, const Pose& X_WA, const Box& B, const Pose& X_WB,
                        BoxPair& pair) {
  const SeenPair seen = See(A, X_WA, B, X_WB);
  const auto& [h_A, h_B, p_AB_A, p_AB_B, R, R_BA] = seen;
  Four abs_R[3];
#pragma GCC unroll 3
  for (int i = 0; i < 3; ++i) abs_R[i] = Abs(R[i]);
  const Four gap_A =
      Abs(p_AB_A) - (h_A + (Splat(h_B[0]) * Abs(R_BA[0]) + Splat(h_B[1]) * Abs(R_BA[1]) +
                            Splat(h_B[2]) * Abs(R_BA[2])));
  const Four gap_B =
      Abs(p_AB_B) - (h_B + (Splat(h_A[0]) * abs_R[0] + Splat(h_A[1]) * abs_R[1] +
                            Splat(h_A[2]) * abs_R[2]));
  Candidates found;
  Store(gap_A, found.separation[0].data());
  Store(gap_B, found.separation[1].data());
  Store(p_AB_A, found.offset[0].data());
  Store(p_AB_B, found.offset[1].data());
  const std::size_t i = FirstGreatest(gap_A);
  const std::size_t j = FirstGreatest(gap_B);
  const double face_A = found.separation[0][i];
  const double face_B = found.separation[1][j];
  // The greater of those two, but known sooner: the branch below waits for it.
  const double best_face = Greatest(Max(gap_A, gap_B));
  if (search == Search::kFirstGap && best_face > 0) {
    const std::size_t kind = face_B > face_A;
    const std::size_t lane = kind == 0 ? i : j;
    return {static_cast<AxisKind>(kind),
            static_cast<int>(i),
            static_cast<int>(j),
            found.separation[kind][lane],
            1,
            found.offset[kind][lane]};
  }

  Store(seen, pair);
  const std::size_t edge = FindEdges(h_A, h_B, p_AB_A, R, abs_R, found);
  const double separation = found.separation[2][edge];
  const auto edge_i = static_cast<std::size_t>(found.i[edge]);
  if (search == Search::kFirstGap && separation > 0) [[unlikely]] {
    return {AxisKind::kEdges, static_cast<int>(edge_i), static_cast<int>(edge),
            separation,       found.per_sine[edge],     found.offset[2][edge]};
  }

  // No preference for faces if an axis separates: the verdict must not depend on it.
  const std::array<double, 2> tolerances = {0, kTie * pair.size};
  const double tolerance =
      tolerances[search == Search::kFirstGap || std::max(best_face, separation) <= 0];
  // A face of A loses to any axis that is better by more than `tolerance`, then a face of
  // B does. The winner is thus never worse than the best by more than one `tolerance`.
  const std::size_t is_edges = separation > best_face + tolerance;
  const std::size_t is_B = std::max(best_face, separation) > face_A + tolerance;
  const std::size_t kind = Either(is_edges, 2, is_B);
  const std::size_t lane = Either(is_edges, edge, Either(is_B, j, i));
  const std::array<double, 2> per_sines = {1, found.per_sine[edge]};
  return {static_cast<AxisKind>(kind),
          static_cast<int>(Either(is_edges, edge_i, i)),
          static_cast<int>(Either(is_edges, edge, j)),
          found.separation[kind][lane],
          per_sines[is_edges],
          found.offset[kind][lane]};
}

}  // namespace HWY_NAMESPACE
}  // namespace cookbook
HWY_AFTER_NAMESPACE();

#endif
