#pragma once

#include "engine/dynamics/broad_phase/aabb.h"

namespace cookbook {

/** The set of points no farther than `rounding` from an axis-aligned box. It bounds a
 body; for a sphere it is exact. */
struct RoundedBox {
  Aabb core;
  double rounding;  ///< [m]

  Aabb bounds() const {
    return {core.low.array() - rounding, core.high.array() + rounding};
  }
};

/** Returns the distance between two rounded boxes; 0 or less if they overlap. [m] */
inline double Distance(const RoundedBox& a, const RoundedBox& b) {
  const Eigen::Vector3d gap = (b.core.low - a.core.high)
                                  .cwiseMax(a.core.low - b.core.high)
                                  .cwiseMax(Eigen::Vector3d::Zero());
  return gap.norm() - a.rounding - b.rounding;
}

}  // namespace cookbook
