#include "engine/dynamics/contacts/collide_bodies.h"

#include <array>
#include <cstddef>
#include <type_traits>

#include "engine/collision/collide.h"
#include "engine/dynamics/contacts/half_space.h"

namespace cookbook {
namespace {

/** Fills the one contact of two edges that meet, given the normal and the gap. */
void CollideEdges(const RigidBody& A, const RigidBody& B, Manifold& manifold) {
  // Pulled together by the gap there is, the boxes just touch.
  const double load = manifold.touching ? 0 : 2 * manifold.separation;
  Pose pulled = B.pose();
  pulled.p_WB -= load * manifold.n_AB_W;
  const Manifold edges =
      Collide(std::get<Box>(A.shape), A.pose(), std::get<Box>(B.shape), pulled);
  manifold.count = edges.count;
  for (std::size_t i = 0; i < edges.points().size(); ++i) {
    manifold.contacts[i] = edges.contacts[i];
    manifold.contacts[i].separation += load;
    manifold.contacts[i].p_WC += 0.5 * load * manifold.n_AB_W;
  }
}

/** Moves contacts from midway to the surface of the body that moves, where one does not.
 */
void PutOnMoving(const RigidBody& A, const RigidBody& B, Manifold& manifold) {
  const double share =
      0.5 * (static_cast<int>(A.is_static()) - static_cast<int>(B.is_static()));
  if (share == 0) return;
  for (int i = 0; i < manifold.count; ++i) {
    ContactPoint& contact = manifold.contacts[static_cast<std::size_t>(i)];
    contact.p_WC += share * contact.separation * manifold.n_AB_W;
  }
}

/** Fills the manifolds of at most kNeighbours pairs of boxes. */
void CollideBoxes(std::span<const Neighbours> boxes) {
  const unsigned edges_meet = CollideBoxesSimd(boxes);
  for (std::size_t k = 0; k < boxes.size(); ++k) {
    const auto& [A, B, margin, n_guess_W, manifold] = boxes[k];
    if ((edges_meet >> k & 1) != 0) CollideEdges(*A, *B, *manifold);
    PutOnMoving(*A, *B, *manifold);
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

/** Returns where a ball is; what it is turned by is of no concern. */
Pose PlaceOf(const RigidBody& ball) {
  return {Eigen::Matrix3d::Identity(), ball.state.p_WB};
}

void CollideBalls(double margin, const RigidBody& A, const RigidBody& B,
                  Manifold& manifold) {
  const Sphere a{A.radius};
  Collide(a, PlaceOf(A), Sphere{B.radius}, PlaceOf(B), manifold);
  PutOnSphere(margin, a, A.state.p_WB, manifold.n_AB_W, manifold);
  // Midway between two balls that move; on the moving one of two.
  const double share = A.is_static() ? 1 : B.is_static() ? 0 : 0.5;
  manifold.contacts[0].p_WC += share * manifold.separation * manifold.n_AB_W;
}

/** Fills the manifold of two bodies that are neither both boxes nor both balls. */
void CollideOthers(double margin, const RigidBody& A, const RigidBody& B,
                   Manifold& manifold) {
  if (std::holds_alternative<HalfSpace>(B.shape)) {
    CollideOthers(margin, B, A, manifold);
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
        if constexpr (std::is_same_v<ShapeA, Point> || std::is_same_v<ShapeB, Point> ||
                      std::is_same_v<ShapeB, HalfSpace>) {
          manifold.count = 0;  // The last are dealt with above.
        } else if constexpr (kSphereA != kSphereB) {
          Collide(a, X_WA, b, X_WB, manifold);
          if constexpr (kSphereB) {
            PutOnSphere(margin, b, X_WB.p_WB, -manifold.n_AB_W, manifold);
          } else {
            PutOnSphere(margin, a, X_WA.p_WB, manifold.n_AB_W, manifold);
          }
        } else if constexpr (kFloorA) {
          Collide(a, X_WA, b, X_WB, margin, manifold);
          PutOnMoving(A, B, manifold);
        }
      },
      A.shape, B.shape);
}

}  // namespace

bool AreBoxes(const RigidBody& A, const RigidBody& B) {
  return std::holds_alternative<Box>(A.shape) && std::holds_alternative<Box>(B.shape);
}

void CollideSpeculative(std::span<const Neighbours> pairs) {
  std::array<Neighbours, kNeighbours> boxes;
  std::size_t count = 0;
  for (const Neighbours& pair : pairs) {
    if (pair.A->is_sphere && pair.B->is_sphere) {
      CollideBalls(pair.margin, *pair.A, *pair.B, *pair.manifold);
      continue;
    }
    if (!AreBoxes(*pair.A, *pair.B)) {
      CollideOthers(pair.margin, *pair.A, *pair.B, *pair.manifold);
      continue;
    }
    boxes[count++] = pair;
    if (count < kNeighbours) continue;
    CollideBoxes(boxes);
    count = 0;
  }
  if (count > 0) CollideBoxes(std::span(boxes).first(count));
}

void CollideSpeculative(double margin, const RigidBody& A, const RigidBody& B,
                        const Eigen::Vector3d& n_guess_W, Manifold& manifold) {
  const Neighbours pair{&A, &B, margin, n_guess_W, &manifold};
  CollideSpeculative(std::span(&pair, 1));
}

}  // namespace cookbook
