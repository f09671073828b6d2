#include <cmath>
#include <limits>

#include "engine/collision/rounding.h"
#include "engine/printed/collide.h"

namespace cookbook::printed {
namespace {

/** Returns the squared distance below which two points coincide. [m²] */
double LeastSquaredDistance(const Errata& errata) {
  // The published limit is 1.19e-7 m². Its root is 0.345 mm.
  if (errata.Has(Erratum::kE30)) return std::numeric_limits<float>::epsilon();
  return kLeastSquaredLength;
}

}  // namespace

Manifold Collide(const Box& A, const Pose& X_WA, const Sphere& B, const Pose& X_WB,
                 const Errata& errata) {
  const Eigen::Vector3d& h = A.half_extents;
  const Eigen::Vector3d p_AB_A = X_WA.R_WB.transpose() * (X_WB.p_WB - X_WA.p_WB);
  Eigen::Vector3d p_AQ_A = p_AB_A.cwiseMax(-h).cwiseMin(h);  // Nearest point of the box.
  const Eigen::Vector3d outward = p_AB_A - p_AQ_A;
  const double distance = outward.norm();

  Manifold manifold;
  if (distance > B.radius) return manifold;
  const double coincident = LeastSquaredDistance(errata);
  const bool concentric = p_AB_A.squaredNorm() < coincident;
  if (concentric && errata.Has(Erratum::kE06)) return manifold;
  manifold.touching = true;

  Eigen::Vector3d n_A;
  double depth = B.radius - distance;
  if (outward.squaredNorm() >= coincident) {
    n_A = outward / distance;
  } else if (errata.Has(Erratum::kE05)) {
    n_A = Eigen::Vector3d::UnitY();
    if (!concentric) n_A = p_AB_A.normalized();
  } else {
    Eigen::Index axis = 0;
    depth += (h - p_AB_A.cwiseAbs()).minCoeff(&axis);
    n_A = Eigen::Vector3d::Unit(axis) * (p_AB_A[axis] < 0 ? -1 : 1);
    p_AQ_A[axis] = n_A[axis] * h[axis];
  }

  manifold.n_AB_W = X_WA.R_WB * n_A;
  manifold.depth = errata.Has(Erratum::kE04) ? depth / 2 : depth;
  // Midway between the nearest point and the sphere's deepest point.
  manifold.contacts_W = {X_WA.p_WB +
                         X_WA.R_WB * (0.5 * (p_AQ_A + (p_AB_A - B.radius * n_A)))};
  return manifold;
}

Manifold Collide(const Sphere& A, const Pose& X_WA, const Box& B, const Pose& X_WB,
                 const Errata& errata) {
  Manifold manifold = Collide(B, X_WB, A, X_WA, errata);
  manifold.n_AB_W = -manifold.n_AB_W;
  return manifold;
}

}  // namespace cookbook::printed
