#include <cmath>

#include "engine/collide.h"
#include "engine/rounding.h"
#include "engine/sphere_batch.h"

namespace cookbook {

SphereGap FindGap(const Sphere& A, const Pose& X_WA, const Sphere& B, const Pose& X_WB) {
  const double x = X_WB.p_WB[0] - X_WA.p_WB[0];
  const double y = X_WB.p_WB[1] - X_WA.p_WB[1];
  const double z = X_WB.p_WB[2] - X_WA.p_WB[2];
  const double squared_distance = x * x + y * y + z * z;
  if (squared_distance < kLeastSquaredLength) {
    return {-(A.radius + B.radius), {0, 1, 0}};  // Any direction is right.
  }
  const double distance = std::sqrt(squared_distance);
  const double scale = 1 / distance;
  return {distance - (A.radius + B.radius), {x * scale, y * scale, z * scale}};
}

Manifold Collide(const Sphere& A, const Pose& X_WA, const Sphere& B, const Pose& X_WB) {
  const SphereGap gap = FindGap(A, X_WA, B, X_WB);
  Manifold manifold;
  manifold.n_AB_W = gap.n_AB_W;
  manifold.separation = gap.separation;
  manifold.touching = gap.separation <= 0;
  manifold.count = manifold.touching;
  // Filled in any case: a branch that cannot be foretold costs more than the contact.
  ContactPoint& contact = manifold.contacts[0];
  const double to_middle = A.radius + gap.separation / 2;
  for (int k = 0; k < 3; ++k) {
    contact.p_WC[k] = X_WA.p_WB[k] + to_middle * gap.n_AB_W[k];
  }
  contact.separation = gap.separation;
  contact.feature = 0;
  return manifold;
}

}  // namespace cookbook
