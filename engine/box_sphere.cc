#include <cmath>

#include "engine/collide.h"
#include "engine/feature.h"
#include "engine/rounding.h"

namespace cookbook {
namespace {

/** The boundary point of a box nearest to a point, in the box's frame. */
struct NearestPoint {
  Eigen::Vector3d p_BQ;  ///< [m]
  Eigen::Vector3d n_B;   ///< Unit, outward, from the boundary.
  double distance;       ///< From the boundary; negative inside. [m]
  FeatureId feature;
};

int SideOf(double value, double bound) {
  return value > bound ? 1 : value < -bound ? -1 : 0;
}

NearestPoint NearestOnFaces(const Box& box, const Eigen::Vector3d& p_B) {
  const Eigen::Vector3d inside = box.half_extents - p_B.cwiseAbs();
  int axis = 0;
  if (inside[1] < inside[axis]) axis = 1;
  if (inside[2] < inside[axis]) axis = 2;
  const int side = p_B[axis] < 0 ? -1 : 1;

  NearestPoint nearest{p_B, Eigen::Vector3d::Zero(), -inside[axis], 0};
  nearest.p_BQ[axis] = side * box.half_extents[axis];
  nearest.n_B[axis] = side;
  nearest.feature =
      SphereContactId(axis == 0 ? side : 0, axis == 1 ? side : 0, axis == 2 ? side : 0);
  return nearest;
}

NearestPoint NearestOnBoundary(const Box& box, const Eigen::Vector3d& p_B) {
  const Eigen::Vector3d& h = box.half_extents;
  const Eigen::Vector3d p_BQ = p_B.cwiseMax(-h).cwiseMin(h);
  const Eigen::Vector3d outward = p_B - p_BQ;
  const double squared_distance = outward.squaredNorm();
  if (squared_distance < kLeastSquaredLength) return NearestOnFaces(box, p_B);
  const double distance = std::sqrt(squared_distance);
  return {
      p_BQ, outward * (1 / distance), distance,
      SphereContactId(SideOf(p_B[0], h[0]), SideOf(p_B[1], h[1]), SideOf(p_B[2], h[2]))};
}

}  // namespace

Manifold Collide(const Box& A, const Pose& X_WA, const Sphere& B, const Pose& X_WB) {
  const Eigen::Vector3d p_AB_A = X_WA.R_WB.transpose() * (X_WB.p_WB - X_WA.p_WB);
  const NearestPoint nearest = NearestOnBoundary(A, p_AB_A);

  Manifold manifold;
  manifold.n_AB_W = X_WA.R_WB * nearest.n_B;
  manifold.separation = nearest.distance - B.radius;
  manifold.touching = manifold.separation <= 0;
  if (manifold.touching) {
    manifold.count = 1;
    ContactPoint& contact = manifold.contacts[0];
    contact.p_WC =
        X_WA.p_WB + X_WA.R_WB * (nearest.p_BQ + (manifold.separation / 2) * nearest.n_B);
    contact.separation = manifold.separation;
    contact.feature = nearest.feature;
  }
  return manifold;
}

Manifold Collide(const Sphere& A, const Pose& X_WA, const Box& B, const Pose& X_WB) {
  Manifold manifold = Collide(B, X_WB, A, X_WA);
  manifold.n_AB_W = -manifold.n_AB_W;
  return manifold;
}

}  // namespace cookbook
