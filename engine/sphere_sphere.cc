#include <cmath>

#include "engine/collide.h"
#include "engine/rounding.h"

namespace cookbook {

Manifold Collide(const Sphere& A, const Pose& X_WA, const Sphere& B, const Pose& X_WB) {
  const Eigen::Vector3d p_AB_W = X_WB.p_WB - X_WA.p_WB;
  const double squared_distance = p_AB_W.squaredNorm();

  Manifold manifold;
  double distance = 0;
  if (squared_distance < kLeastSquaredLength) {
    manifold.n_AB_W = Eigen::Vector3d::UnitY();  // Any direction is right.
  } else {
    distance = std::sqrt(squared_distance);
    manifold.n_AB_W = p_AB_W * (1 / distance);
  }
  manifold.separation = distance - (A.radius + B.radius);
  manifold.touching = manifold.separation <= 0;
  if (manifold.touching) {
    manifold.count = 1;
    ContactPoint& contact = manifold.contacts[0];
    contact.p_WC = X_WA.p_WB + (A.radius + manifold.separation / 2) * manifold.n_AB_W;
    contact.separation = manifold.separation;
    contact.feature = 0;
  }
  return manifold;
}

}  // namespace cookbook
