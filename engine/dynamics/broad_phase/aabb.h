#pragma once

#include <limits>

#include <Eigen/Core>

namespace cookbook {

/** A box along the world's axes. */
struct Aabb {
  Eigen::Vector3d low;   ///< [m]
  Eigen::Vector3d high;  ///< [m]

  /** Returns a box that overlaps none that ends somewhere. */
  static Aabb Nothing() {
    const Eigen::Vector3d far =
        Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());
    return {far, -far};
  }

  bool Overlaps(const Aabb& other) const {
    // Without branches: which of the six comparisons fails cannot be foretold.
    int apart = 0;
    for (int k = 0; k < 3; ++k) {
      apart |= low[k] > other.high[k];
      apart |= other.low[k] > high[k];
    }
    return apart == 0;
  }

  bool Contains(const Aabb& other) const {
    int outside = 0;
    for (int k = 0; k < 3; ++k) {
      outside |= low[k] > other.low[k];
      outside |= other.high[k] > high[k];
    }
    return outside == 0;
  }

  bool operator==(const Aabb& other) const {
    return low == other.low && high == other.high;
  }

  /** Half the surface. [m²] */
  double Surface() const {
    const Eigen::Vector3d size = high - low;
    return size[0] * size[1] + size[1] * size[2] + size[2] * size[0];
  }
};

inline Aabb Union(const Aabb& a, const Aabb& b) {
  return {a.low.cwiseMin(b.low), a.high.cwiseMax(b.high)};
}

}  // namespace cookbook
