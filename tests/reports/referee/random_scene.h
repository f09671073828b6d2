#pragma once

#include <cstdint>
#include <random>

#include <Eigen/Geometry>

#include "scenarios/contact_query.h"

namespace touchstone {

/** A generator of random shapes and poses that uses only the bits of mt19937_64, so that
 they are the same on every machine. */
class RandomScene {
 public:
  explicit RandomScene(std::uint64_t seed) : bits_(seed) {}

  /** Returns a random number in [lo, hi). */
  double Uniform(double lo, double hi) {
    return lo + (hi - lo) * (static_cast<double>(bits_() >> 11) * 0x1p-53);
  }
  /** Returns 10 to the power of a random number in [lo, hi). */
  double Power(double lo, double hi) { return std::pow(10, Uniform(lo, hi)); }

  /** Returns a random point in the cube of half-width `size`. [m] */
  Eigen::Vector3d Point(double size) {
    const double x = Uniform(-size, size);
    const double y = Uniform(-size, size);
    return {x, y, Uniform(-size, size)};
  }
  Eigen::Quaterniond Rotation() {
    for (;;) {
      const Eigen::Vector3d v = Point(1);
      const Eigen::Quaterniond q(Uniform(-1, 1), v.x(), v.y(), v.z());
      if (q.norm() > 0.1 && q.norm() < 1) return q.normalized();
    }
  }
  Box SomeBox(double size) {
    const double x = Uniform(0.1, 1) * size;
    const double y = Uniform(0.1, 1) * size;
    return {{x, y, Uniform(0.1, 1) * size}};
  }
  ConvexHull SomeHull(double size, int vertices) {
    ConvexHull hull;
    for (int i = 0; i < vertices; ++i) hull.vertices.push_back(Point(size));
    return hull;
  }

 private:
  std::mt19937_64 bits_;
};

}  // namespace touchstone
