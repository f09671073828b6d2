#include "engine/dynamics/near_contact.h"

#include <algorithm>
#include <type_traits>

#include "engine/box_batch.h"
#include "engine/collide.h"
#include "engine/dynamics/face_patch.h"
#include "engine/dynamics/half_space.h"

namespace cookbook {
namespace {

/** Cosine of the angle between the normal of two edges and that of a face up to which
 the faces are taken to meet. Nearly parallel faces meet in a patch whose corners have
 depths of their own; the one contact of two edges would let the boxes rock on it. */
constexpr double kNearlyFace = 0.98;

/** Returns the gap along the normal of a face of A, on the side of `n_W`. [m] */
double GapAlongFace(const FaceOfBox& face, const Box& A, const Pose& X_WA, const Box& B,
                    const Pose& X_WB) {
  const Eigen::Vector3d n_W = face.side * X_WA.R_WB.col(face.axis);
  const Eigen::Vector3d reach =
      (X_WB.R_WB.transpose() * n_W).cwiseProduct(B.half_extents);
  return n_W.dot(X_WB.p_WB - X_WA.p_WB) - A.half_extents[face.axis] -
         reach.cwiseAbs().sum();
}

Manifold CollideBoxes(double margin, const Box& A, const Pose& X_WA, const Box& B,
                      const Pose& X_WB, const Eigen::Vector3d& n_guess_W) {
  const BoxGap gap = FindGap(A, X_WA, B, X_WB);
  Manifold manifold;
  manifold.n_AB_W = gap.n_AB_W;
  manifold.separation = gap.separation;
  manifold.touching = gap.separation <= 0;
  if (gap.separation > margin) return manifold;

  const FaceOfBox face_A = FaceTowards(gap.n_AB_W, X_WA.R_WB);
  const FaceOfBox face_B = FaceTowards(-gap.n_AB_W, X_WB.R_WB);
  const Eigen::Vector3d n_A = face_A.side * X_WA.R_WB.col(face_A.axis);
  const Eigen::Vector3d n_B = -face_B.side * X_WB.R_WB.col(face_B.axis);
  const double gap_A = GapAlongFace(face_A, A, X_WA, B, X_WB);
  const double gap_B = GapAlongFace(face_B, B, X_WB, A, X_WA);
  const double cosine = std::max(gap.n_AB_W.dot(n_A), gap.n_AB_W.dot(n_B));
  if (cosine < kNearlyFace && gap.separation > std::max(gap_A, gap_B) + margin) {
    // Edge on edge: pulled together by the gap there is, the boxes just touch.
    const double pull = manifold.touching ? 0 : 2 * gap.separation;
    Pose pulled = X_WB;
    pulled.p_WB -= pull * gap.n_AB_W;
    const Manifold edges = Collide(A, X_WA, B, pulled);
    manifold.count = edges.count;
    for (std::size_t i = 0; i < edges.points().size(); ++i) {
      manifold.contacts[i] = edges.contacts[i];
      manifold.contacts[i].separation += pull;
      manifold.contacts[i].p_WC += 0.5 * pull * gap.n_AB_W;
    }
    return manifold;
  }
  // The face with the greater gap is the reference, but not by rounding: the one that was
  // it in the last step stays it within the margin, and A's where there is none.
  const bool was_B = n_guess_W.dot(n_B) > n_guess_W.dot(n_A);
  const bool reference_is_B =
      was_B ? gap_B + 0.5 * margin > gap_A : gap_B > gap_A + 0.5 * margin;
  double share;  // From the surface of the incident box to midway.
  if (reference_is_B) {
    manifold.n_AB_W = n_B;
    manifold.separation = gap_B;
    FillFacePatch(margin, face_B, B, X_WB, A, X_WA, true, manifold);
    share = 0.5;
  } else {
    manifold.n_AB_W = n_A;
    manifold.separation = gap_A;
    FillFacePatch(margin, face_A, A, X_WA, B, X_WB, false, manifold);
    share = -0.5;
  }
  for (int i = 0; i < manifold.count; ++i) {
    ContactPoint& contact = manifold.contacts[static_cast<std::size_t>(i)];
    contact.p_WC += share * contact.separation * manifold.n_AB_W;
  }
  return manifold;
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

Manifold CollideWithin(double margin, const RigidBody& A, const RigidBody& B,
                       const Eigen::Vector3d& n_guess_W) {
  if (std::holds_alternative<HalfSpace>(B.shape)) {
    Manifold swapped = CollideWithin(margin, B, A, -n_guess_W);
    swapped.n_AB_W = -swapped.n_AB_W;
    return swapped;
  }
  const Pose X_WA = A.pose();
  const Pose X_WB = B.pose();
  Manifold manifold = std::visit(
      [&]<class ShapeA, class ShapeB>(const ShapeA& a, const ShapeB& b) -> Manifold {
        constexpr bool kFloorA = std::is_same_v<ShapeA, HalfSpace>;
        constexpr bool kSphereA = std::is_same_v<ShapeA, Sphere>;
        constexpr bool kSphereB = std::is_same_v<ShapeB, Sphere>;
        constexpr bool kPoint =
            std::is_same_v<ShapeA, Point> || std::is_same_v<ShapeB, Point>;
        if constexpr (kPoint || std::is_same_v<ShapeB, HalfSpace>) {
          return {};  // The latter are dealt with above.
        } else if constexpr (kSphereA || kSphereB) {
          Manifold sphere = Collide(a, X_WA, b, X_WB);
          if constexpr (kSphereA && kSphereB) {
            // Midway between two balls that move; on the moving one of two.
            const double share = A.is_static() ? 1 : B.is_static() ? 0 : 0.5;
            PutOnSphere(margin, a, X_WA.p_WB, sphere.n_AB_W, sphere);
            sphere.contacts[0].p_WC += share * sphere.separation * sphere.n_AB_W;
          } else if constexpr (kSphereB) {
            PutOnSphere(margin, b, X_WB.p_WB, -sphere.n_AB_W, sphere);
          } else {
            PutOnSphere(margin, a, X_WA.p_WB, sphere.n_AB_W, sphere);
          }
          return sphere;
        } else if constexpr (kFloorA) {
          return Collide(a, X_WA, b, X_WB, margin);
        } else {
          return CollideBoxes(margin, a, X_WA, b, X_WB, n_guess_W);
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
  return manifold;
}

}  // namespace cookbook
