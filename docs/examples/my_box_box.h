#pragma once

#include <cmath>
#include <limits>

#include <Eigen/Geometry>

/** What a box-box routine finds. */
struct Hit {
  bool touching;
  Eigen::Vector3d normal;  ///< Unit, from A to B.
  double depth;            ///< [m]; only where touching.
};

/** A rectangular solid somewhere. */
struct PlacedBox {
  Eigen::Vector3d half_extents;  ///< [m]
  Eigen::Matrix3d rotation;      ///< Body to world.
  Eigen::Vector3d centre;        ///< World, [m].
};

/** Returns ab − cd to a rounding or two, however much of it cancels (Kahan). */
inline double DifferenceOfProducts(double a, double b, double c, double d) {
  const double cd = c * d;
  return std::fma(a, b, -cd) + std::fma(-c, d, cd);
}

/** Returns u × v. Of nearly parallel unit vectors, the plain formula keeps as many digits
 of the direction as the sine of their angle has: README.md shows what that does. */
inline Eigen::Vector3d Cross(const Eigen::Vector3d& u, const Eigen::Vector3d& v) {
  return {DifferenceOfProducts(u.y(), v.z(), u.z(), v.y()),
          DifferenceOfProducts(u.z(), v.x(), u.x(), v.z()),
          DifferenceOfProducts(u.x(), v.y(), u.y(), v.x())};
}

/** Separating axes: the depth of two boxes is the least overlap along the three face
 normals of each and the nine cross products of their edges. */
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
