#pragma once

#include <Eigen/Core>

namespace touchstone::referee {

/** A vector over any scalar: double, Precise, or either with an error bound. */
template <typename T>
struct Vector {
  T x{}, y{}, z{};

  friend Vector operator+(const Vector& a, const Vector& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
  }
  friend Vector operator-(const Vector& a, const Vector& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
  }
  friend Vector operator-(const Vector& a) { return {-a.x, -a.y, -a.z}; }
  friend Vector operator*(const T& s, const Vector& a) {
    return {s * a.x, s * a.y, s * a.z};
  }
};

template <typename T>
T Dot(const Vector<T>& a, const Vector<T>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <typename T>
Vector<T> Cross(const Vector<T>& a, const Vector<T>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/** Returns the vector over `To` whose coordinates are exactly those of `a`. */
template <typename To, typename From>
Vector<To> Exactly(const Vector<From>& a) {
  return {To(a.x), To(a.y), To(a.z)};
}

template <typename To>
Vector<To> Exactly(const Eigen::Vector3d& a) {
  return {To(a.x()), To(a.y()), To(a.z())};
}

inline Eigen::Vector3d ToEigen(const Vector<double>& a) {
  return {a.x, a.y, a.z};
}

}  // namespace touchstone::referee
