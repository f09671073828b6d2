#include "engine/dynamics/contacts/collide_bodies.h"

#include <array>
#include <cstddef>
#include <type_traits>

#include "engine/collision/collide.h"
#include "engine/dynamics/contacts/half_space.h"

namespace cookbook {
namespace {

/** Fills the one contact of two edges, given the normal and the separation. */
void CollideEdges(const RigidBody& A, const RigidBody& B, Manifold& manifold) {
  // Collide() needs overlap, so B is moved towards A by twice the separation.
  const double shift = manifold.touching ? 0 : 2 * manifold.separation;
  Pose moved = B.pose();
  moved.p_WB -= shift * manifold.n_AB_W;
  const Manifold edges =
      Collide(std::get<Box>(A.shape), A.pose(), std::get<Box>(B.shape), moved);
  manifold.count = edges.count;
  for (std::size_t i = 0; i < edges.points().size(); ++i) {
    manifold.contacts[i] = edges.contacts[i];
    manifold.contacts[i].separation += shift;
    manifold.contacts[i].p_WC += 0.5 * shift * manifold.n_AB_W;
  }
}

/** Moves contact points from midway to the surface of the dynamic body if the other one
 is static. */
void MoveToDynamicBody(const RigidBody& A, const RigidBody& B, Manifold& manifold) {
  const double fraction =
      0.5 * (static_cast<int>(A.is_static()) - static_cast<int>(B.is_static()));
  if (fraction == 0) return;
  for (int i = 0; i < manifold.count; ++i) {
    ContactPoint& contact = manifold.contacts[static_cast<std::size_t>(i)];
    contact.p_WC += fraction * contact.separation * manifold.n_AB_W;
  }
}

/** Fills the manifolds of at most kPairsPerBatch pairs of boxes. */
void CollideBoxes(std::span<const CollisionPair> boxes) {
  const unsigned edge_contacts = CollideBoxesSimd(boxes);
  for (std::size_t k = 0; k < boxes.size(); ++k) {
    const auto& [A, B, margin, n_guess_W, manifold] = boxes[k];
    if ((edge_contacts >> k & 1) != 0) CollideEdges(*A, *B, *manifold);
    MoveToDynamicBody(*A, *B, *manifold);
  }
}

/** Fills the one contact of a sphere, on its own surface. `out_W` is the unit vector from
 the sphere into the other body. */
void SetSphereContact(double margin, const Sphere& sphere, const Eigen::Vector3d& p_WS,
                      const Eigen::Vector3d& out_W, Manifold& manifold) {
  if (manifold.separation > margin && !manifold.touching) {
    manifold.count = 0;
    return;
  }
  // The feature is always the same: a sphere that rolls off a face keeps its impulse.
  manifold.count = 1;
  manifold.contacts[0] = {p_WS + sphere.radius * out_W, manifold.separation, 0};
}

/** Returns the pose of a sphere without its orientation, which Collide() does not use. */
Pose PositionOf(const RigidBody& sphere) {
  return {Eigen::Matrix3d::Identity(), sphere.state.p_WB};
}

void CollideSpheres(double margin, const RigidBody& A, const RigidBody& B,
                    Manifold& manifold) {
  const Sphere a{A.radius};
  Collide(a, PositionOf(A), Sphere{B.radius}, PositionOf(B), manifold);
  SetSphereContact(margin, a, A.state.p_WB, manifold.n_AB_W, manifold);
  // Midway between two dynamic spheres, else on the dynamic one.
  const double fraction = A.is_static() ? 1 : B.is_static() ? 0 : 0.5;
  manifold.contacts[0].p_WC += fraction * manifold.separation * manifold.n_AB_W;
}

/** Fills the manifold of two bodies that are neither two boxes nor two spheres. */
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
          manifold.count = 0;  // A half-space B is swapped above.
        } else if constexpr (kSphereA != kSphereB) {
          Collide(a, X_WA, b, X_WB, manifold);
          if constexpr (kSphereB) {
            SetSphereContact(margin, b, X_WB.p_WB, -manifold.n_AB_W, manifold);
          } else {
            SetSphereContact(margin, a, X_WA.p_WB, manifold.n_AB_W, manifold);
          }
        } else if constexpr (kFloorA) {
          Collide(a, X_WA, b, X_WB, margin, manifold);
          MoveToDynamicBody(A, B, manifold);
        }
      },
      A.shape, B.shape);
}

}  // namespace

bool AreBoxes(const RigidBody& A, const RigidBody& B) {
  return std::holds_alternative<Box>(A.shape) && std::holds_alternative<Box>(B.shape);
}

void CollideSpeculative(std::span<const CollisionPair> pairs) {
  std::array<CollisionPair, kPairsPerBatch> boxes;
  std::size_t count = 0;
  for (const CollisionPair& pair : pairs) {
    if (pair.A->is_sphere && pair.B->is_sphere) {
      CollideSpheres(pair.margin, *pair.A, *pair.B, *pair.manifold);
      continue;
    }
    if (!AreBoxes(*pair.A, *pair.B)) {
      CollideOthers(pair.margin, *pair.A, *pair.B, *pair.manifold);
      continue;
    }
    boxes[count++] = pair;
    if (count < kPairsPerBatch) continue;
    CollideBoxes(boxes);
    count = 0;
  }
  if (count > 0) CollideBoxes(std::span(boxes).first(count));
}

void CollideSpeculative(double margin, const RigidBody& A, const RigidBody& B,
                        const Eigen::Vector3d& n_guess_W, Manifold& manifold) {
  const CollisionPair pair{&A, &B, margin, n_guess_W, &manifold};
  CollideSpeculative(std::span(&pair, 1));
}

}  // namespace cookbook
