#pragma once

#include "engine/dynamics/broad_phase/aabb.h"

namespace cookbook {

/** All that is no farther than `rounding` from a box along the world's axes: holds a
 body, and a sphere exactly. */
struct RoundedBox {
  Aabb core;
  double rounding;  ///< [m]

  Aabb bounds() const {
    return {core.low.array() - rounding, core.high.array() + rounding};
  }
};

/** Returns how far two of them are from each other; where they overlap, 0 or less. [m] */
inline double GapOf(const RoundedBox& a, const RoundedBox& b) {
  const Eigen::Vector3d way = (b.core.low - a.core.high)
                                  .cwiseMax(a.core.low - b.core.high)
                                  .cwiseMax(Eigen::Vector3d::Zero());
  return way.norm() - a.rounding - b.rounding;
}

}  // namespace cookbook
