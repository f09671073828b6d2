#include <cmath>

#include "engine/collision/rounding.h"
#include "engine/printed/collide.h"

namespace cookbook::printed {

Manifold Collide(const Sphere& A, const Pose& X_WA, const Sphere& B, const Pose& X_WB,
                 const Errata& errata) {
  const double reach = A.radius + B.radius;
  const Eigen::Vector3d p_AB_W = X_WB.p_WB - X_WA.p_WB;
  const double distance = p_AB_W.norm();
  const bool concentric = p_AB_W.squaredNorm() < kLeastSquaredLength;

  Manifold manifold;
  if (distance > reach) return manifold;
  if (concentric && errata.Has(Erratum::kE06)) return manifold;
  manifold.touching = true;
  manifold.n_AB_W = Eigen::Vector3d::UnitY();
  if (!concentric) manifold.n_AB_W = p_AB_W / distance;
  const double depth = errata.Has(Erratum::kE03) ? std::abs(1 - reach) : reach - distance;
  manifold.depth = errata.Has(Erratum::kE04) ? depth / 2 : depth;
  manifold.contacts_W = {X_WA.p_WB + (A.radius - depth / 2) * manifold.n_AB_W};
  return manifold;
}

}  // namespace cookbook::printed
