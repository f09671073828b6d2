#pragma once

#include <Eigen/Geometry>

namespace touchstone {

// Vector arithmetic with explicit order of summation. Eigen's order depends on the
// machine's vector width, and so does the last bit of its result.

/** Returns v · w. */
double Dot(const Eigen::Vector3d& v, const Eigen::Vector3d& w);

/** Returns |v|. */
double Norm(const Eigen::Vector3d& v);

/** Returns v / |v|. @pre v is not zero. */
Eigen::Vector3d Unit(const Eigen::Vector3d& v);

/** Returns q / |q|. @pre q is not zero. */
Eigen::Quaterniond Unit(const Eigen::Quaterniond& q);

/** Returns v × w. */
Eigen::Vector3d Cross(const Eigen::Vector3d& v, const Eigen::Vector3d& w);

/** Returns R v. */
Eigen::Vector3d Apply(const Eigen::Matrix3d& R, const Eigen::Vector3d& v);

/** Returns Rᵀ v. */
Eigen::Vector3d ApplyInverse(const Eigen::Matrix3d& R, const Eigen::Vector3d& v);

/** Returns R S. */
Eigen::Matrix3d Product(const Eigen::Matrix3d& R, const Eigen::Matrix3d& S);

/** Returns the unit quaternion of the rotation `first` followed by `second`. */
Eigen::Quaterniond Product(const Eigen::Quaterniond& second,
                           const Eigen::Quaterniond& first);

/** Returns the rotation by 2 atan(t) about the unit vector `axis`; t is the tangent of
 half the angle. The quaternion needs no trigonometry. */
Eigen::Quaterniond RotationByHalfTangent(const Eigen::Vector3d& axis, double t);

/** Returns the smallest rotation that maps the unit vector `from` to the unit vector
 `to`. Its error grows as 1 / (1 + from · to).
 @pre They are not opposite. */
Eigen::Quaterniond LeastRotation(const Eigen::Vector3d& from, const Eigen::Vector3d& to);

}  // namespace touchstone
