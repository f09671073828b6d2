#include "engine/box_contacts.h"
#include "engine/collide.h"
#include "engine/separating_axis.h"

namespace cookbook {
namespace {

/** Returns a_i × b_j / |a_i × b_j| in A's frame, turned from A to B. */
Eigen::Vector3d EdgeNormal(const BoxPair& pair, const AxisGap& axis) {
  const auto i1 = static_cast<std::size_t>(Next(axis.i));
  const auto i2 = static_cast<std::size_t>(AfterNext(axis.i));
  const auto j = static_cast<std::size_t>(axis.j);
  const double r1 = pair.R_AB[i1][j];
  const double r2 = pair.R_AB[i2][j];
  const double along = pair.p_AB_A[i2] * r1 - pair.p_AB_A[i1] * r2;
  const double scale = along < 0 ? -1 / axis.sine : 1 / axis.sine;
  Eigen::Vector3d n_AB_A = Eigen::Vector3d::Zero();
  n_AB_A[Next(axis.i)] = -r2 * scale;
  n_AB_A[AfterNext(axis.i)] = r1 * scale;
  return n_AB_A;
}

}  // namespace

Manifold Collide(const Box& A, const Pose& X_WA, const Box& B, const Pose& X_WB) {
  BoxPair pair;
  const AxisGap axis = FindLeastOverlap<Search::kFirstGap>(A, X_WA, B, X_WB, pair);

  Manifold manifold;
  manifold.separation = axis.separation;
  manifold.touching = axis.separation <= 0;
  if (axis.kind == AxisKind::kEdges) {
    const Eigen::Vector3d n_AB_A = EdgeNormal(pair, axis);
    manifold.n_AB_W = X_WA.R_WB * n_AB_A;
    if (manifold.touching) FillEdgeContact(pair, axis, n_AB_A, X_WA, manifold);
    return manifold;
  }
  if (axis.kind == AxisKind::kFaceOfA) {
    manifold.n_AB_W = X_WA.R_WB.col(axis.i);
    if (pair.p_AB_A[static_cast<std::size_t>(axis.i)] < 0) manifold.n_AB_W *= -1;
  } else {
    manifold.n_AB_W = X_WB.R_WB.col(axis.j);
    if (pair.p_AB_B[static_cast<std::size_t>(axis.j)] < 0) manifold.n_AB_W *= -1;
  }
  if (manifold.touching) FillFaceContacts(pair, axis, X_WA, X_WB, manifold);
  return manifold;
}

}  // namespace cookbook
