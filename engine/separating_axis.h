#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/rounding.h"
#include "engine/shape.h"

namespace cookbook {

/** The axes that follow `axis` in cyclic order. */
constexpr int Next(int axis) {
  return axis == 2 ? 0 : axis + 1;
}
constexpr int AfterNext(int axis) {
  return axis == 0 ? 2 : axis - 1;
}

/** Two boxes as they see each other. */
struct BoxPair {
  std::array<double, 3> h_A;     ///< [m]
  std::array<double, 3> h_B;     ///< [m]
  std::array<double, 3> p_AB_A;  ///< Centre of B from that of A, A's frame. [m]
  std::array<double, 3> p_AB_B;  ///< The same vector in B's frame. [m]
  std::array<std::array<double, 3>, 3> R_AB;  ///< R_AB[i][j] = a_i · b_j.

  /** The size that rounding errors are multiples of (engine/rounding.h). [m] */
  double Size() const {
    return std::abs(p_AB_A[0]) + std::abs(p_AB_A[1]) + std::abs(p_AB_A[2]) +
           ((h_A[0] + h_A[1] + h_A[2]) + (h_B[0] + h_B[1] + h_B[2]));
  }
};

/** The direction that an axis of the test has: a face normal of A, one of B, or a_i ×
 * b_j. */
enum class AxisKind { kFaceOfA, kFaceOfB, kEdges };

/** One axis and the gap along it. */
struct AxisGap {
  AxisKind kind;
  int i;              ///< Axis of A; unused for a face of B.
  int j;              ///< Axis of B; unused for a face of A.
  double separation;  ///< Signed gap along the unit axis: < 0 overlapping. [m]
  double sine;        ///< |a_i × b_j|; 1 for a face.
  /** Centre of B from that of A along the axis before it is turned from A to B, times
   `sine`: negative where it has to be turned. [m] */
  double offset;
};

/** Whether the search ends at the first axis that separates, or tries all to find the one
 of greatest gap. */
enum class Search { kFirstGap, kGreatestGap };

/** Returns the axis of least overlap among the 15 of boxes A and B, and fills `pair`.

 With Search::kFirstGap it may return any axis of positive gap, and `pair` is then
 incomplete. Ties to within rounding go to A's faces, then to B's. Engine-internal: call
 Collide(). */
template <Search search>
inline AxisGap FindLeastOverlap(const Box& A, const Pose& X_WA, const Box& B,
                                const Pose& X_WB, BoxPair& pair) {
  const double* a = X_WA.R_WB.data();  // a[3 i + k] is component k of axis i.
  const double* b = X_WB.R_WB.data();
  const double d[3] = {X_WB.p_WB[0] - X_WA.p_WB[0], X_WB.p_WB[1] - X_WA.p_WB[1],
                       X_WB.p_WB[2] - X_WA.p_WB[2]};
  // Unrolled throughout, so that every index is a constant: a tenth of the whole query.
#pragma GCC unroll 3
  for (std::size_t k = 0; k < 3; ++k) {
    pair.h_A[k] = A.half_extents[static_cast<Eigen::Index>(k)];
    pair.h_B[k] = B.half_extents[static_cast<Eigen::Index>(k)];
  }
  const auto& h_A = pair.h_A;
  const auto& h_B = pair.h_B;
  auto& R = pair.R_AB;
  std::array<std::array<double, 3>, 3> abs_R;

  AxisGap face_A{AxisKind::kFaceOfA, 0, 0, 0, 1, 0};
#pragma GCC unroll 3
  for (std::size_t i = 0; i < 3; ++i) {
    const double* a_i = a + 3 * i;
#pragma GCC unroll 3
    for (std::size_t j = 0; j < 3; ++j) {
      const double* b_j = b + 3 * j;
      R[i][j] = a_i[0] * b_j[0] + a_i[1] * b_j[1] + a_i[2] * b_j[2];
      abs_R[i][j] = std::abs(R[i][j]);
    }
    pair.p_AB_A[i] = a_i[0] * d[0] + a_i[1] * d[1] + a_i[2] * d[2];
    const double reach =
        h_A[i] + (h_B[0] * abs_R[i][0] + h_B[1] * abs_R[i][1] + h_B[2] * abs_R[i][2]);
    const double gap = std::abs(pair.p_AB_A[i]) - reach;
    if (i == 0 || gap > face_A.separation) {
      face_A.i = static_cast<int>(i);
      face_A.separation = gap;
      face_A.offset = pair.p_AB_A[i];
    }
    if (search == Search::kFirstGap && gap > 0) return face_A;
  }

  AxisGap face_B{AxisKind::kFaceOfB, 0, 0, 0, 1, 0};
#pragma GCC unroll 3
  for (std::size_t j = 0; j < 3; ++j) {
    const double* b_j = b + 3 * j;
    pair.p_AB_B[j] = b_j[0] * d[0] + b_j[1] * d[1] + b_j[2] * d[2];
    const double reach =
        h_B[j] + (h_A[0] * abs_R[0][j] + h_A[1] * abs_R[1][j] + h_A[2] * abs_R[2][j]);
    const double gap = std::abs(pair.p_AB_B[j]) - reach;
    if (j == 0 || gap > face_B.separation) {
      face_B.j = static_cast<int>(j);
      face_B.separation = gap;
      face_B.offset = pair.p_AB_B[j];
    }
    if (search == Search::kFirstGap && gap > 0) return face_B;
  }

  // Gaps along a_i × b_j are compared as gap |gap| against squared lengths, which orders
  // like gap / length and leaves one root and one quotient for the winner.
  AxisGap edges{AxisKind::kEdges, -1, 0, 0, 1, 0};
  double best_signed_square = 0;
  double best_squared_length = 1;
  const auto& t = pair.p_AB_A;
#pragma GCC unroll 3
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t i1 = (i + 1) % 3;
    const std::size_t i2 = (i + 2) % 3;
    double abs_minor[3];  // |b_k · (a_i × b_j)|, not |R|: see kOverlapRounding.
#pragma GCC unroll 3
    for (std::size_t j = 0; j < 3; ++j) {
      const std::size_t j1 = (j + 1) % 3;
      const std::size_t j2 = (j + 2) % 3;
      abs_minor[j] = std::abs(R[i1][j1] * R[i2][j2] - R[i2][j1] * R[i1][j2]);
    }
#pragma GCC unroll 3
    for (std::size_t j = 0; j < 3; ++j) {
      const std::size_t j1 = (j + 1) % 3;
      const std::size_t j2 = (j + 2) % 3;
      const double squared_length = R[i1][j] * R[i1][j] + R[i2][j] * R[i2][j];
      const double reach = (h_A[i1] * abs_R[i2][j] + h_A[i2] * abs_R[i1][j]) +
                           (h_B[j1] * abs_minor[j2] + h_B[j2] * abs_minor[j1]);
      const double offset = t[i2] * R[i1][j] - t[i1] * R[i2][j];
      const double gap = std::abs(offset) - reach;
      if (squared_length <= kParallelSquared) continue;
      const double signed_square = gap * std::abs(gap);
      if (edges.i < 0 ||
          signed_square * best_squared_length > best_signed_square * squared_length) {
        edges.i = static_cast<int>(i);
        edges.j = static_cast<int>(j);
        edges.separation = gap;
        edges.offset = offset;
        best_signed_square = signed_square;
        best_squared_length = squared_length;
      }
    }
    if (search == Search::kFirstGap && edges.separation > 0) break;
  }

  edges.sine = std::sqrt(best_squared_length);
  edges.separation /= edges.sine;
  // Against the better face, not the preferred one: where the boxes share an axis, edge
  // axes are face normals to rounding, and their edges meet nowhere.
  const double best_face = std::max(face_A.separation, face_B.separation);
  // No preference outweighs a gap: the verdict must not depend on it.
  const bool apart = std::max(best_face, edges.separation) > 0;
  const double slack = apart ? 0 : kOverlapRounding * pair.Size();
  if (edges.i >= 0 && edges.separation > best_face + slack) return edges;
  return face_B.separation > face_A.separation + slack ? face_B : face_A;
}

/** Returns a_i × b_j / |a_i × b_j| in A's frame, turned from A to B. `r1` and `r2` are
 the entries of R_AB in column j, in the two rows after i. */
inline Eigen::Vector3d EdgeNormal(const AxisGap& axis, double r1, double r2) {
  const double scale = axis.offset < 0 ? -1 / axis.sine : 1 / axis.sine;
  Eigen::Vector3d n_AB_A;
  n_AB_A[axis.i] = 0;
  n_AB_A[Next(axis.i)] = -r2 * scale;
  n_AB_A[AfterNext(axis.i)] = r1 * scale;
  return n_AB_A;
}

/** Returns the normal of the face of `axis` in the world, turned from A to B. */
inline Eigen::Vector3d FaceNormal(const AxisGap& axis, const Eigen::Matrix3d& R_WA,
                                  const Eigen::Matrix3d& R_WB) {
  const double sign = axis.offset < 0 ? -1 : 1;
  return sign * (axis.kind == AxisKind::kFaceOfA ? R_WA.col(axis.i) : R_WB.col(axis.j));
}

}  // namespace cookbook
