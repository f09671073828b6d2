#include "engine/box_contacts.h"
#include "engine/collide.h"
#include "engine/separating_axis.h"

namespace cookbook {

Manifold Collide(const Box& A, const Pose& X_WA, const Box& B, const Pose& X_WB) {
  BoxPair pair;
  const AxisGap axis = FindLeastOverlap(A, X_WA, B, X_WB, Search::kFirstGap, pair);

  Manifold manifold;
  manifold.separation = axis.separation;
  manifold.touching = axis.separation <= 0;
  if (axis.kind == AxisKind::kEdges) {
    const auto j = static_cast<std::size_t>(axis.j);
    const Eigen::Vector3d n_AB_A =
        EdgeNormal(axis, pair.R_AB[static_cast<std::size_t>(Next(axis.i))][j],
                   pair.R_AB[static_cast<std::size_t>(AfterNext(axis.i))][j]);
    manifold.n_AB_W = X_WA.R_WB * n_AB_A;
    if (manifold.touching) FillEdgeContact(pair, axis, n_AB_A, X_WA, manifold);
  } else {
    manifold.n_AB_W = FaceNormal(axis, X_WA.R_WB, X_WB.R_WB);
    if (manifold.touching) FillFaceContacts(pair, axis, X_WA, X_WB, manifold);
  }
  return manifold;
}

}  // namespace cookbook
