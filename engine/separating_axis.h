#pragma once

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

/** Three numbers in the lanes of a vector; what the fourth holds is of no concern. */
using Row = std::array<double, 4>;

/** Two boxes as they see each other. */
struct alignas(32) BoxPair {
  Row h_A;                  ///< [m]
  Row h_B;                  ///< [m]
  Row p_AB_A;               ///< Centre of B from that of A, A's frame. [m]
  Row p_AB_B;               ///< The same vector in B's frame. [m]
  std::array<Row, 3> R_AB;  ///< R_AB[i][j] = a_i · b_j.
  std::array<Row, 3> R_BA;  ///< The transpose of R_AB.

  /** The size that rounding errors are multiples of (engine/rounding.h). [m] */
  double Size() const {
    return std::abs(p_AB_A[0]) + std::abs(p_AB_A[1]) + std::abs(p_AB_A[2]) +
           ((h_A[0] + h_A[1] + h_A[2]) + (h_B[0] + h_B[1] + h_B[2]));
  }
};

/** The direction that an axis of the test has: a face normal of A, one of B, or a_i ×
 * b_j. */
enum class AxisKind { kFaceOfA = 0, kFaceOfB = 1, kEdges };

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
 incomplete. Ties to within rounding go to A's faces, then to B's. Every processor gives
 the same bits, those of BoxBatch. Engine-internal: call Collide(). */
AxisGap FindLeastOverlap(const Box& A, const Pose& X_WA, const Box& B, const Pose& X_WB,
                         Search search, BoxPair& pair);

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
  // Looked up: a branch for the face or the sign would be guessed wrong half the time.
  const double* const columns[] = {R_WA.data() + 3 * axis.i, R_WB.data() + 3 * axis.j};
  const double* n = columns[axis.kind == AxisKind::kFaceOfB];
  const double sign = 1 - 2 * (axis.offset < 0);
  return {sign * n[0], sign * n[1], sign * n[2]};
}

}  // namespace cookbook
