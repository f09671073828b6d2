#pragma once

#include <array>
#include <cmath>

#include "engine/rounding.h"
#include "engine/shape.h"

namespace cookbook {

/** The axes that follow `axis` in cyclic order. Looked up in two bits each: which axis it
 is cannot be foretold, and of a comparison compilers make a branch. */
constexpr int Next(int axis) {
  return (0b00'10'01 >> (2 * axis)) & 3;
}
constexpr int AfterNext(int axis) {
  return (0b01'00'10 >> (2 * axis)) & 3;
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

/** Returns the axis of least overlap among the 15 of boxes A and B, or of greatest gap,
 and fills `pair`.

 Ties to within rounding go to A's faces, then to B's. Every processor gives the same
 bits, those of BoxBatch. Engine-internal: call Collide(). */
AxisGap FindLeastOverlap(const Box& A, const Pose& X_WA, const Box& B, const Pose& X_WB,
                         BoxPair& pair);

/** Returns the normal of the face of `gap` in the world, turned from A to B. */
inline Eigen::Vector3d FaceNormal(const AxisGap& gap, const Eigen::Matrix3d& R_WA,
                                  const Eigen::Matrix3d& R_WB) {
  // Looked up: a branch for the face or the sign would be guessed wrong half the time.
  const std::array<const double*, 2> columns = {R_WA.data() + 3 * gap.i,
                                                R_WB.data() + 3 * gap.j};
  const double* n = columns[gap.kind == AxisKind::kFaceOfB];
  const double sign = 1 - 2 * (gap.offset < 0);
  return {sign * n[0], sign * n[1], sign * n[2]};
}

/** The normal as a combination of two axes of one box: the normal of the face that it
 leaves most steeply, and the axis in that face towards which it leans. A face's own
 normal leans nowhere. */
struct Facing {
  bool is_B;  ///< Whose axes; A's where the normal is that of two edges.
  int axis;   ///< Of the face.
  int lean;
  double n_axis;  ///< Components of n_AB along the two, |n_axis| >= |n_lean|.
  double n_lean;
};

/** Returns the normal of `gap`, turned from A to B. `r1` and `r2` are the entries of R_AB
 in column j, in the two rows after i, and matter for edges only: a_i × b_j has the
 components −r2 and r1 along the two axes of A after i. */
inline Facing FacingOf(const AxisGap& gap, double r1, double r2) {
  // Looked up: a branch for the kind or the sign would be guessed wrong half the time.
  const bool is_edges = gap.kind == AxisKind::kEdges;
  const bool is_B = gap.kind == AxisKind::kFaceOfB;
  const double sign = 1 - 2 * (gap.offset < 0);
  const double scale = sign / gap.sine;
  const std::array<double, 2> along = {-r2 * scale, r1 * scale};
  const std::array<int, 2> after_i = {Next(gap.i), AfterNext(gap.i)};
  const std::size_t steeper = std::abs(along[1]) > std::abs(along[0]);
  const std::array<int, 2> faces = {gap.i, gap.j};
  const std::array<int, 2> axes = {faces[is_B], after_i[steeper]};
  const std::array<int, 2> leans = {Next(axes[0]), after_i[1 - steeper]};
  const std::array<double, 2> n_axes = {sign, along[steeper]};
  const std::array<double, 2> n_leans = {0, along[1 - steeper]};
  return {is_B, axes[is_edges], leans[is_edges], n_axes[is_edges], n_leans[is_edges]};
}

/** Returns the normal in the world. */
inline Eigen::Vector3d NormalInWorld(const Facing& facing, const Eigen::Matrix3d& R_WA,
                                     const Eigen::Matrix3d& R_WB) {
  const std::array<const double*, 2> both_R = {R_WA.data(), R_WB.data()};
  const double* R = both_R[facing.is_B];
  const double* a = R + 3 * facing.axis;
  const double* b = R + 3 * facing.lean;
  return {facing.n_axis * a[0] + facing.n_lean * b[0],
          facing.n_axis * a[1] + facing.n_lean * b[1],
          facing.n_axis * a[2] + facing.n_lean * b[2]};
}

}  // namespace cookbook
