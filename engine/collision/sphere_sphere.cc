#include <cmath>

#include "engine/collision/collide.h"
#include "engine/collision/rounding.h"
#include "engine/collision/sphere_batch.h"

namespace cookbook {

void Collide(const Sphere& A, const Pose& X_WA, const Sphere& B, const Pose& X_WB,
             Manifold& manifold) {
  // Three scalars: a vector that is written one number at a time and read two at a time
  // stalls on memory for as long as all the rest takes.
  double x = X_WB.p_WB[0] - X_WA.p_WB[0];
  double y = X_WB.p_WB[1] - X_WA.p_WB[1];
  double z = X_WB.p_WB[2] - X_WA.p_WB[2];
  const double squared_distance = x * x + y * y + z * z;
  double distance = 0;
  if (squared_distance < kLeastSquaredLength) [[unlikely]] {
    x = 0;  // Any direction is right.
    y = 1;
    z = 0;
  } else {
    distance = std::sqrt(squared_distance);
    const double scale = 1 / distance;
    x *= scale;
    y *= scale;
    z *= scale;
  }
  const double separation = distance - (A.radius + B.radius);
  const double to_middle = A.radius + separation / 2;
  manifold.touching = separation <= 0;
  manifold.count = manifold.touching;
  manifold.n_AB_W = {x, y, z};
  manifold.separation = separation;
  // Filled even if apart: an unpredictable branch costs more than the contact.
  ContactPoint& contact = manifold.contacts[0];
  contact.p_WC = {X_WA.p_WB[0] + to_middle * x, X_WA.p_WB[1] + to_middle * y,
                  X_WA.p_WB[2] + to_middle * z};
  contact.separation = separation;
  contact.feature = 0;
}

SphereGap FindGap(const Sphere& A, const Pose& X_WA, const Sphere& B, const Pose& X_WB) {
  const Manifold manifold = Collide(A, X_WA, B, X_WB);
  return {manifold.separation, manifold.n_AB_W};
}

}  // namespace cookbook
