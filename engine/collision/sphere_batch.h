#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "engine/collision/shape.h"

namespace cookbook {

/** The signed gap of two spheres: < 0 if they overlap. */
struct SphereGap {
  double separation;       ///< Signed distance. [m]
  Eigen::Vector3d n_AB_W;  ///< Unit normal out of A into B, world frame.
};

/** Returns the gap of one pair of spheres. Same bits as Collide(), without the
 contact. */
SphereGap FindGap(const Sphere& A, const Pose& X_WA, const Sphere& B, const Pose& X_WB);

/** Eight pairs of spheres as a structure of arrays, with one lane per pair. */
struct alignas(64) SphereBlock {
  using Lanes = std::array<double, 8>;
  std::array<Lanes, 3> p_WA;  ///< [m]
  std::array<Lanes, 3> p_WB;  ///< [m]
  Lanes radius_A;             ///< [m]
  Lanes radius_B;             ///< [m]
};

/** Many pairs of spheres, queried at once with the processor's widest vectors. Every
 processor returns the same bits, and the same as FindGap(). */
class SphereBatch {
 public:
  /** Allocates `size` pairs; all must be set before FindGaps(). */
  explicit SphereBatch(std::size_t size);

  std::size_t size() const { return size_; }

  void Set(std::size_t index, const Sphere& A, const Pose& X_WA, const Sphere& B,
           const Pose& X_WB);

  /** Finds the separation of every pair. */
  void FindGaps();

  /** Returns the separations of all pairs, found by FindGaps(). [m] */
  std::span<const double> separations() const {
    return std::span(separations_).first(size_);
  }

 private:
  std::size_t size_;
  std::vector<SphereBlock> blocks_;
  std::vector<double> separations_;  ///< Padded to whole blocks.
};

}  // namespace cookbook
