#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "engine/collision/rounding.h"
#include "engine/collision/shape.h"

namespace cookbook {

/** Next() returns the axis after `axis` in cyclic order, AfterNext() the one after that.
 Both read a table of two bits per axis: compilers would make a branch of a comparison,
 and the axis is unpredictable. */
constexpr int Next(int axis) {
  return (0b00'10'01 >> (2 * axis)) & 3;
}
constexpr int AfterNext(int axis) {
  return (0b01'00'10 >> (2 * axis)) & 3;
}

/** Returns `yes` if `which` is 1 and `no` if it is 0, without a branch: the winning axis
 is unpredictable. */
constexpr std::size_t Either(std::size_t which, std::size_t yes, std::size_t no) {
  return no ^ ((yes ^ no) & (0 - which));
}

/** Three numbers in the lanes of a vector; the value of the fourth is unspecified. */
using Row = std::array<double, 4>;

/** The relative geometry of two boxes. Index 0 of each array is for A, index 1 for B. */
struct alignas(32) BoxPair {
  std::array<Row, 2> h;  ///< Half extents. [m]
  /** Centre of B relative to that of A, in the frame of the indexed box. [m] */
  std::array<Row, 2> p_AB;
  /** Row k: axis k of the indexed box, in the frame of the other. R[0][i][j] = a_i ·
   b_j. */
  std::array<std::array<Row, 3>, 2> R;
  /** |p_AB_A|₁ + |h_A|₁ + |h_B|₁, the unit of the rounding bounds (rounding.h). [m] */
  double size;
};

/** The kind of an axis of the test: a face normal of A, one of B, or a_i × b_j. */
enum class AxisKind { kFaceOfA = 0, kFaceOfB = 1, kEdges };

/** One axis and the gap along it. */
struct AxisGap {
  AxisKind kind;
  int i;              ///< Axis of A; unused for a face of B.
  int j;              ///< Axis of B; unused for a face of A.
  double separation;  ///< Signed gap along the unit axis: < 0 overlapping. [m]
  double per_sine;    ///< 1 / |a_i × b_j|; 1 for a face.
  /** Centre of B relative to that of A along a_i × b_j or along the face's axis, before
   the axis is oriented from A to B: negative if it has to be flipped. [m] */
  double offset;
};

/** Whether the search ends at the first separating axis, or tries all axes and finds the
 one of greatest gap. */
enum class Search { kFirstGap, kGreatestGap };

/** Returns the axis of least overlap among the 15 of boxes A and B, or of greatest gap if
 they are apart, and fills `pair`.

 Ties to within rounding go to A's faces, then to B's. Every processor returns the same
 bits, and the same as BoxBatch. Engine-internal: call Collide(). */
AxisGap FindLeastOverlap(const Box& A, const Pose& X_WA, const Box& B, const Pose& X_WB,
                         BoxPair& pair);

/** Returns the face normal of `gap` in the world frame, pointing from A to B. */
inline Eigen::Vector3d FaceNormal(const AxisGap& gap, const Eigen::Matrix3d& R_WA,
                                  const Eigen::Matrix3d& R_WB) {
  // A look-up: a branch on the face or the sign would be mispredicted half the time.
  const std::array<const double*, 2> columns = {R_WA.col(gap.i).data(),
                                                R_WB.col(gap.j).data()};
  const double* n = columns[gap.kind == AxisKind::kFaceOfB];
  const double sign = 1 - 2 * (gap.offset < 0);
  return {sign * n[0], sign * n[1], sign * n[2]};
}

/** A normal as a combination of two axes of one box: the axis that it is closest to,
 which is the normal of a face, and the axis in that face towards which it leans. A face's
 own normal does not lean: n_lean = 0. */
struct Facing {
  bool is_B;      ///< Whether the axes are B's; for two edges they are A's.
  int axis;       ///< Axis of the face.
  int lean;       ///< Axis in the face.
  double n_axis;  ///< Component of n_AB along `axis`; |n_axis| >= |n_lean|.
  double n_lean;  ///< Component of n_AB along `lean`.
};

/** Returns the normal of `gap`, pointing from A to B. `r1` and `r2` are the entries of
 R_AB in column j, in the two rows after i. They matter for edges only: a_i × b_j has the
 components −r2 and r1 along the two axes of A after i. */
inline Facing FacingOf(const AxisGap& gap, double r1, double r2) {
  const std::size_t is_edges = gap.kind == AxisKind::kEdges;
  const std::size_t is_B = gap.kind == AxisKind::kFaceOfB;
  const double sign = 1 - 2 * (gap.offset < 0);
  const double scale = sign * gap.per_sine;
  const double along_1 = -r2 * scale;
  const double along_2 = r1 * scale;
  const std::size_t steeper = std::abs(along_2) > std::abs(along_1);
  // A look-up: a branch on the kind or the sign would be mispredicted half the time.
  const std::array<double, 4> components = {along_1, along_2, sign, 0};
  const auto next = static_cast<std::size_t>(Next(gap.i));
  const auto after_next = static_cast<std::size_t>(AfterNext(gap.i));
  const std::size_t face =
      Either(is_B, static_cast<std::size_t>(gap.j), static_cast<std::size_t>(gap.i));
  const std::size_t axis = Either(is_edges, Either(steeper, after_next, next), face);
  return {
      is_B != 0, static_cast<int>(axis),
      static_cast<int>(Either(is_edges, next ^ after_next ^ axis,
                              static_cast<std::size_t>(Next(static_cast<int>(face))))),
      components[Either(is_edges, steeper, 2)],
      components[Either(is_edges, 1 - steeper, 3)]};
}

/** Returns the normal in the world frame. */
inline Eigen::Vector3d NormalInWorld(const Facing& facing, const Eigen::Matrix3d& R_WA,
                                     const Eigen::Matrix3d& R_WB) {
  const std::array<const double*, 2> both_R = {R_WA.data(), R_WB.data()};
  const double* R = both_R[facing.is_B];
  const double* a = R + 3 * std::ptrdiff_t{facing.axis};
  const double* b = R + 3 * std::ptrdiff_t{facing.lean};
  return {facing.n_axis * a[0] + facing.n_lean * b[0],
          facing.n_axis * a[1] + facing.n_lean * b[1],
          facing.n_axis * a[2] + facing.n_lean * b[2]};
}

}  // namespace cookbook
