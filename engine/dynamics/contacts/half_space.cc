#include "engine/dynamics/contacts/half_space.h"

#include <algorithm>

#include "engine/collision/rounding.h"

namespace cookbook {

void Collide(const HalfSpace&, const Pose& X_WA, const Sphere& B, const Pose& X_WB,
             Manifold& manifold) {
  manifold.n_AB_W = X_WA.R_WB.col(2);
  manifold.separation = manifold.n_AB_W.dot(X_WB.p_WB - X_WA.p_WB) - B.radius;
  manifold.touching = manifold.separation <= 0;
  manifold.count = manifold.touching;
  manifold.contacts[0] = {
      X_WB.p_WB - (B.radius + manifold.separation / 2) * manifold.n_AB_W,
      manifold.separation, 1};
}

void Collide(const HalfSpace&, const Pose& X_WA, const Box& B, const Pose& X_WB,
             double margin, Manifold& manifold) {
  const Eigen::Vector3d n = X_WA.R_WB.col(2);
  const Eigen::Vector3d p_AB = X_WB.p_WB - X_WA.p_WB;
  const double height = n.dot(p_AB);
  const Eigen::Vector3d n_B = X_WB.R_WB.transpose() * n;
  const Eigen::Vector3d reach = n_B.cwiseProduct(B.half_extents);
  manifold.n_AB_W = n;
  manifold.separation = height - reach.cwiseAbs().sum();
  const double rounding =
      kOverlapRounding * (p_AB.lpNorm<1>() + B.half_extents.lpNorm<1>());
  manifold.touching = manifold.separation <= rounding;
  const double limit = std::max(rounding, margin);
  manifold.count = 0;
  if (manifold.separation > limit) return;
  // The lower face is the one that looks at A most directly; several, if they do equally
  // to rounding.
  const double least_cosine = n_B.cwiseAbs().maxCoeff() - kOverlapRounding;
  for (unsigned vertex = 0; vertex < 8; ++vertex) {
    const Eigen::Vector3d sides(vertex & 1 ? 1 : -1, vertex & 2 ? 1 : -1,
                                vertex & 4 ? 1 : -1);
    if (-sides.cwiseProduct(n_B).minCoeff() < least_cosine) continue;
    const double separation = height + sides.dot(reach);
    if (separation > limit) continue;
    const Eigen::Vector3d p_WV =
        X_WB.p_WB + X_WB.R_WB * sides.cwiseProduct(B.half_extents);
    manifold.contacts[static_cast<std::size_t>(manifold.count++)] = {
        p_WV - (separation / 2) * n, separation, vertex + 1};
  }
}

}  // namespace cookbook
