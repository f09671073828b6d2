#include "scenarios/generators/portable_math.h"

#include <cmath>

namespace touchstone {

double Dot(const Eigen::Vector3d& v, const Eigen::Vector3d& w) {
  return v.x() * w.x() + v.y() * w.y() + v.z() * w.z();
}

double Norm(const Eigen::Vector3d& v) {
  return std::sqrt(Dot(v, v));
}

Eigen::Vector3d Unit(const Eigen::Vector3d& v) {
  return v / Norm(v);
}

Eigen::Quaterniond Unit(const Eigen::Quaterniond& q) {
  const double norm =
      std::sqrt(q.w() * q.w() + q.x() * q.x() + q.y() * q.y() + q.z() * q.z());
  return {q.w() / norm, q.x() / norm, q.y() / norm, q.z() / norm};
}

Eigen::Vector3d Cross(const Eigen::Vector3d& v, const Eigen::Vector3d& w) {
  return {v.y() * w.z() - v.z() * w.y(), v.z() * w.x() - v.x() * w.z(),
          v.x() * w.y() - v.y() * w.x()};
}

Eigen::Vector3d Apply(const Eigen::Matrix3d& R, const Eigen::Vector3d& v) {
  return {Dot(R.row(0), v), Dot(R.row(1), v), Dot(R.row(2), v)};
}

Eigen::Vector3d ApplyInverse(const Eigen::Matrix3d& R, const Eigen::Vector3d& v) {
  return {Dot(R.col(0), v), Dot(R.col(1), v), Dot(R.col(2), v)};
}

Eigen::Matrix3d Product(const Eigen::Matrix3d& R, const Eigen::Matrix3d& S) {
  Eigen::Matrix3d product;
  for (int i = 0; i < 3; ++i) product.col(i) = Apply(R, S.col(i));
  return product;
}

Eigen::Quaterniond Product(const Eigen::Quaterniond& second,
                           const Eigen::Quaterniond& first) {
  const Eigen::Quaterniond& a = second;
  const Eigen::Quaterniond& b = first;
  return Unit(
      Eigen::Quaterniond(a.w() * b.w() - a.x() * b.x() - a.y() * b.y() - a.z() * b.z(),
                         a.w() * b.x() + a.x() * b.w() + a.y() * b.z() - a.z() * b.y(),
                         a.w() * b.y() - a.x() * b.z() + a.y() * b.w() + a.z() * b.x(),
                         a.w() * b.z() + a.x() * b.y() - a.y() * b.x() + a.z() * b.w()));
}

Eigen::Quaterniond RotationByHalfTangent(const Eigen::Vector3d& axis, double t) {
  return Unit(Eigen::Quaterniond(1, axis.x() * t, axis.y() * t, axis.z() * t));
}

Eigen::Quaterniond LeastRotation(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  const Eigen::Vector3d axis = Cross(from, to);
  return Unit(Eigen::Quaterniond(1 + Dot(from, to), axis.x(), axis.y(), axis.z()));
}

}  // namespace touchstone
