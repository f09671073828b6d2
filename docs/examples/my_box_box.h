#pragma once

#include <cmath>
#include <limits>

#include <Eigen/Geometry>

/** Result of a box-box routine. */
struct Hit {
  bool touching;
  Eigen::Vector3d normal;  ///< Unit vector from A to B, world frame.
  double depth;            ///< Penetration depth, valid only if touching. [m]
};

/** A box at a pose. */
struct PlacedBox {
  Eigen::Vector3d half_extents;  ///< Half lengths of the edges. [m]
  Eigen::Matrix3d rotation;      ///< Rotation from the body frame to the world frame.
  Eigen::Vector3d centre;        ///< Centre, world frame. [m]
};

/** Returns ab − cd within a rounding or two, even if most digits cancel (Kahan). */
inline double DifferenceOfProducts(double a, double b, double c, double d) {
  const double cd = c * d;
  return std::fma(a, b, -cd) + std::fma(-c, d, cd);
}

/** Returns u × v. For nearly parallel unit vectors, the plain formula loses about as many
 digits of the direction as the sine of their angle has leading zeros. README.md shows the
 effect. */
inline Eigen::Vector3d Cross(const Eigen::Vector3d& u, const Eigen::Vector3d& v) {
  return {DifferenceOfProducts(u.y(), v.z(), u.z(), v.y()),
          DifferenceOfProducts(u.z(), v.x(), u.x(), v.z()),
          DifferenceOfProducts(u.x(), v.y(), u.y(), v.x())};
}

/** The separating-axis test. The depth of two boxes is the least overlap along the three
 face normals of each and the nine cross products of their edges. */
inline Hit CollideBoxes(const PlacedBox& A, const PlacedBox& B) {
  const Eigen::Vector3d p_AB = B.centre - A.centre;
  Hit least{true, Eigen::Vector3d::Zero(), std::numeric_limits<double>::infinity()};
  const auto consider = [&](const Eigen::Vector3d& axis) {
    const double length = axis.norm();
    if (length == 0) return;  // Parallel edges: the face normals cover them.
    Eigen::Vector3d n = axis / length;
    if (n.dot(p_AB) < 0) n = -n;
    const double reach_A = (A.rotation.transpose() * n).cwiseAbs().dot(A.half_extents);
    const double reach_B = (B.rotation.transpose() * n).cwiseAbs().dot(B.half_extents);
    const double overlap = reach_A + reach_B - n.dot(p_AB);
    if (overlap < least.depth) least = {overlap >= 0, n, overlap};
  };
  for (int i = 0; i < 3; ++i) {
    consider(A.rotation.col(i));
    consider(B.rotation.col(i));
    for (int j = 0; j < 3; ++j) consider(Cross(A.rotation.col(i), B.rotation.col(j)));
  }
  return least;
}
