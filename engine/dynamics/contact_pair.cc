#include "engine/dynamics/contact_pair.h"

#include <type_traits>

#include "engine/collide.h"
#include "engine/dynamics/half_space.h"

namespace cookbook {

Manifold Collide(const RigidBody& A, const RigidBody& B) {
  const Pose X_WA = A.pose();
  const Pose X_WB = B.pose();
  return std::visit(
      [&]<class ShapeA, class ShapeB>(const ShapeA& a, const ShapeB& b) -> Manifold {
        constexpr bool kFloorA = std::is_same_v<ShapeA, HalfSpace>;
        constexpr bool kFloorB = std::is_same_v<ShapeB, HalfSpace>;
        if constexpr (kFloorA && kFloorB) {
          return {};
        } else if constexpr (kFloorB) {
          Manifold manifold = Collide(b, X_WB, a, X_WA);
          manifold.n_AB_W = -manifold.n_AB_W;
          return manifold;
        } else {
          return Collide(a, X_WA, b, X_WB);
        }
      },
      A.shape, B.shape);
}

void Recollide(const RigidBody& A, const RigidBody& B, ContactPair& pair) {
  const Manifold old = pair.manifold;
  const std::array<Eigen::Vector3d, 8> old_J_W = pair.J_W;
  pair.manifold = Collide(A, B);
  for (std::size_t i = 0; i < pair.manifold.points().size(); ++i) {
    pair.J_W[i].setZero();
    for (std::size_t k = 0; k < old.points().size(); ++k) {
      if (old.contacts[k].feature != pair.manifold.contacts[i].feature) continue;
      pair.J_W[i] = old_J_W[k];
      break;
    }
  }
}

}  // namespace cookbook
