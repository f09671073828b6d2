#pragma once

#include <cstdint>

#include <Eigen/Core>

namespace cookbook {

/** A box along the world's axes. */
struct Aabb {
  Eigen::Vector3d low;   ///< [m]
  Eigen::Vector3d high;  ///< [m]

  bool Overlaps(const Aabb& other) const {
    // Without branches: which of the six comparisons fails cannot be foretold.
    int apart = 0;
    for (int k = 0; k < 3; ++k) {
      apart |= low[k] > other.high[k];
      apart |= other.low[k] > high[k];
    }
    return apart == 0;
  }
};

/** The same in single precision, rounded outwards: enough to tell who may be near, in
 half the room. The fourth number of a corner is no part of it. */
struct LooseBox {
  /** Four floats at once: a plain compiler vector, which every processor takes. */
  using Corner = float __attribute__((vector_size(16)));

  Corner low;   ///< [m]
  Corner high;  ///< [m]

  static LooseBox Around(const Aabb& box);
  /** Returns a box that overlaps no other. */
  static LooseBox Nothing();

  bool Overlaps(const LooseBox& other) const {
    return AreTrue((low <= other.high) & (other.low <= high));
  }

  bool Contains(const Aabb& other) const {
    int outside = 0;
    for (int k = 0; k < 3; ++k) {
      outside |= double{low[k]} > other.low[k];
      outside |= other.high[k] > double{high[k]};
    }
    return outside == 0;
  }

  bool operator==(const LooseBox& other) const {
    return AreTrue((low == other.low) & (high == other.high));
  }

  /** Half the surface. [m²] */
  float Surface() const {
    const Corner size = high - low;
    return size[0] * size[1] + size[1] * size[2] + size[2] * size[0];
  }

 private:
  /** What comparing two corners gives: all bits set where true. */
  using Truths = std::int32_t __attribute__((vector_size(16)));

  static bool AreTrue(Truths truths) {
    using Halves = std::int64_t __attribute__((vector_size(16)));
    const auto halves = reinterpret_cast<Halves>(truths | Truths{0, 0, 0, -1});
    return (halves[0] & halves[1]) == -1;
  }
};

inline LooseBox Union(const LooseBox& a, const LooseBox& b) {
  return {a.low < b.low ? a.low : b.low, a.high > b.high ? a.high : b.high};
}

}  // namespace cookbook
