#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "engine/collision/shape.h"

namespace cookbook {

/** How far apart two spheres are, or how deep in each other. */
struct SphereGap {
  double separation;       ///< Signed distance. [m]
  Eigen::Vector3d n_AB_W;  ///< Unit, out of A into B, world frame.
};

/** Returns the gap of one pair of spheres: Collide() without the contact, same bits. */
SphereGap FindGap(const Sphere& A, const Pose& X_WA, const Sphere& B, const Pose& X_WB);

/** Eight pairs of spheres, number by number: a row for each, a lane for each pair. */
struct alignas(64) SphereBlock {
  using Lanes = std::array<double, 8>;
  std::array<Lanes, 3> p_WA;  ///< [m]
  std::array<Lanes, 3> p_WB;  ///< [m]
  Lanes radius_A;             ///< [m]
  Lanes radius_B;             ///< [m]
};

/** Many pairs of spheres, asked at once with the widest vectors that the processor has.
 Every processor gives the same bits, and the same as FindGap(). */
class SphereBatch {
 public:
  /** Makes room for `size` pairs; all must be set before FindGaps(). */
  explicit SphereBatch(std::size_t size);

  std::size_t size() const { return size_; }

  void Set(std::size_t index, const Sphere& A, const Pose& X_WA, const Sphere& B,
           const Pose& X_WB);

  /** Finds the separation of every pair. */
  void FindGaps();

  /** Returns, after FindGaps(), the separations of all pairs. [m] */
  std::span<const double> separations() const {
    return std::span(separations_).first(size_);
  }

 private:
  std::size_t size_;
  std::vector<SphereBlock> blocks_;
  std::vector<double> separations_;  ///< In whole blocks.
};

}  // namespace cookbook
