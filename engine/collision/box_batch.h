#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "engine/collision/shape.h"

namespace cookbook {

/** The signed gap of two boxes along the best of the 15 axes. */
struct BoxGap {
  /** Signed gap along n_AB_W. If touching, minus the depth. If apart, a lower bound of
   the distance: the greatest gap along any face normal or cross product of edges. [m] */
  double separation;
  Eigen::Vector3d n_AB_W;  ///< Unit normal out of A into B, world frame.
};

/** Returns the gap of one pair of boxes: Collide() without contacts and without the early
 exit for boxes apart. If the boxes touch, both return the same bits. */
BoxGap FindGap(const Box& A, const Pose& X_WA, const Box& B, const Pose& X_WB);

/** Many pairs of boxes, queried at once with the processor's widest vectors.

 Every processor returns the same bits, and the same as FindGap(): multiplications and
 additions are never fused, and each lane runs exactly the operations of the one-pair
 code. */
class BoxBatch {
 public:
  /** Allocates `size` pairs; all must be set before FindGaps(). */
  explicit BoxBatch(std::size_t size);

  std::size_t size() const { return size_; }

  void Set(std::size_t index, const Box& A, const Pose& X_WA, const Box& B,
           const Pose& X_WB);

  /** Finds the gap of every pair. */
  void FindGaps();

  /** Returns the separations of all pairs, found by FindGaps(). [m] */
  std::span<const double> separations() const {
    return std::span(separations_).first(size_);
  }

  /** Returns the gap of one pair, found by FindGaps(). */
  BoxGap gap(std::size_t index) const;

 private:
  std::size_t size_;
  std::size_t blocks_;
  /** Blocks of eight pairs. In a block, each of a pair's 30 numbers has a row of eight
   lanes. */
  std::unique_ptr<double[]> storage_;
  double* rows_;  ///< The first block, aligned to a cache line.
  // Results, padded to whole blocks. gap() derives the normal from them.
  std::vector<double> axes_;
  std::vector<double> separations_;
  std::vector<double> sines_;
  std::vector<double> offsets_;
};

}  // namespace cookbook
