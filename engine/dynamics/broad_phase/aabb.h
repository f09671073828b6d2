#pragma once

#include <limits>

#include <Eigen/Core>

namespace cookbook {

/** An axis-aligned bounding box in the world frame. */
struct Aabb {
  Eigen::Vector3d low;   ///< [m]
  Eigen::Vector3d high;  ///< [m]

  /** Returns the empty box, which overlaps no finite box. It is the neutral element of
   Union(). */
  static Aabb Empty() {
    const Eigen::Vector3d far =
        Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());
    return {far, -far};
  }

  bool Overlaps(const Aabb& other) const {
    // Branch-free: which of the six comparisons fails is unpredictable.
    int separated = 0;
    for (int k = 0; k < 3; ++k) {
      separated |= low[k] > other.high[k];
      separated |= other.low[k] > high[k];
    }
    return separated == 0;
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

  /** Returns half the surface area. [m²] */
  double HalfArea() const {
    const Eigen::Vector3d size = high - low;
    return size[0] * size[1] + size[1] * size[2] + size[2] * size[0];
  }
};

/** Returns the smallest box that contains both. */
inline Aabb Union(const Aabb& a, const Aabb& b) {
  return {a.low.cwiseMin(b.low), a.high.cwiseMax(b.high)};
}

}  // namespace cookbook
