#include "engine/dynamics/near_contact.h"

#include <algorithm>
#include <type_traits>

#include "engine/collide.h"
#include "engine/dynamics/half_space.h"
#include "engine/dynamics/near_boxes.h"

namespace cookbook {
namespace {

void CollideBoxes(double margin, const Box& A, const Pose& X_WA, const Box& B,
                  const Pose& X_WB, const Eigen::Vector3d& n_guess_W,
                  Manifold& manifold) {
  if (CollideNearFaces(margin, A, X_WA, B, X_WB, n_guess_W, manifold)) return;
  // Edge on edge: pulled together by the gap there is, the boxes just touch.
  const double pull = manifold.touching ? 0 : 2 * manifold.separation;
  Pose pulled = X_WB;
  pulled.p_WB -= pull * manifold.n_AB_W;
  const Manifold edges = Collide(A, X_WA, B, pulled);
  manifold.count = edges.count;
  for (std::size_t i = 0; i < edges.points().size(); ++i) {
    manifold.contacts[i] = edges.contacts[i];
    manifold.contacts[i].separation += pull;
    manifold.contacts[i].p_WC += 0.5 * pull * manifold.n_AB_W;
  }
}

/** Fills the one contact of a sphere, given the unit vector out of it into the other
 body, on its own surface. */
void PutOnSphere(double margin, const Sphere& sphere, const Eigen::Vector3d& p_WS,
                 const Eigen::Vector3d& out_W, Manifold& manifold) {
  if (manifold.separation > margin && !manifold.touching) {
    manifold.count = 0;
    return;
  }
  // One contact is always the same contact: a ball that rolls off a face keeps its
  // impulse.
  manifold.count = 1;
  manifold.contacts[0] = {p_WS + sphere.radius * out_W, manifold.separation, 0};
}

}  // namespace

void CollideWithin(double margin, const RigidBody& A, const RigidBody& B,
                   const Eigen::Vector3d& n_guess_W, Manifold& manifold) {
  if (std::holds_alternative<HalfSpace>(B.shape)) {
    CollideWithin(margin, B, A, -n_guess_W, manifold);
    manifold.n_AB_W = -manifold.n_AB_W;
    return;
  }
  const Pose X_WA = A.pose();
  const Pose X_WB = B.pose();
  std::visit(
      [&]<class ShapeA, class ShapeB>(const ShapeA& a, const ShapeB& b) {
        constexpr bool kFloorA = std::is_same_v<ShapeA, HalfSpace>;
        constexpr bool kSphereA = std::is_same_v<ShapeA, Sphere>;
        constexpr bool kSphereB = std::is_same_v<ShapeB, Sphere>;
        constexpr bool kPoint =
            std::is_same_v<ShapeA, Point> || std::is_same_v<ShapeB, Point>;
        if constexpr (kPoint || std::is_same_v<ShapeB, HalfSpace>) {
          manifold.count = 0;  // The latter are dealt with above.
        } else if constexpr (kSphereA || kSphereB) {
          manifold = Collide(a, X_WA, b, X_WB);
          if constexpr (kSphereA && kSphereB) {
            // Midway between two balls that move; on the moving one of two.
            const double share = A.is_static() ? 1 : B.is_static() ? 0 : 0.5;
            PutOnSphere(margin, a, X_WA.p_WB, manifold.n_AB_W, manifold);
            manifold.contacts[0].p_WC += share * manifold.separation * manifold.n_AB_W;
          } else if constexpr (kSphereB) {
            PutOnSphere(margin, b, X_WB.p_WB, -manifold.n_AB_W, manifold);
          } else {
            PutOnSphere(margin, a, X_WA.p_WB, manifold.n_AB_W, manifold);
          }
        } else if constexpr (kFloorA) {
          manifold = Collide(a, X_WA, b, X_WB, margin);
        } else {
          CollideBoxes(margin, a, X_WA, b, X_WB, n_guess_W, manifold);
        }
      },
      A.shape, B.shape);
  const bool boxes = !std::holds_alternative<Sphere>(A.shape) &&
                     !std::holds_alternative<Sphere>(B.shape);
  const double share =
      boxes ? 0.5 * (static_cast<int>(A.is_static()) - static_cast<int>(B.is_static()))
            : 0;
  if (share != 0) {
    for (int i = 0; i < manifold.count; ++i) {
      ContactPoint& contact = manifold.contacts[static_cast<std::size_t>(i)];
      contact.p_WC += share * contact.separation * manifold.n_AB_W;
    }
  }
}

}  // namespace cookbook
