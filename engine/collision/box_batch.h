#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "engine/collision/shape.h"

namespace cookbook {

/** How far apart two boxes are along the best of the 15 axes, or how deep. */
struct BoxGap {
  /** Signed gap along n_AB_W: minus the depth where touching, else a lower bound of the
   distance, the greatest that a face normal or a pair of edges gives. [m] */
  double separation;
  Eigen::Vector3d n_AB_W;  ///< Unit, out of A into B, world frame.
};

/** Returns the gap of one pair of boxes: Collide() without contacts and without the early
 end for boxes apart. Where the boxes touch, both give the same bits. */
BoxGap FindGap(const Box& A, const Pose& X_WA, const Box& B, const Pose& X_WB);

/** Many pairs of boxes, asked at once with the widest vectors that the processor has.

 Every processor gives the same bits, and the same as FindGap(): multiplications and
 additions are never fused, and each lane runs the very operations of the one-pair code.
 */
class BoxBatch {
 public:
  /** Makes room for `size` pairs; all must be set before FindGaps(). */
  explicit BoxBatch(std::size_t size);

  std::size_t size() const { return size_; }

  void Set(std::size_t index, const Box& A, const Pose& X_WA, const Box& B,
           const Pose& X_WB);

  /** Finds the gap of every pair. */
  void FindGaps();

  /** Returns, after FindGaps(), the separations of all pairs. [m] */
  std::span<const double> separations() const {
    return std::span(separations_).first(size_);
  }

  /** Returns, after FindGaps(), the gap of one pair. */
  BoxGap gap(std::size_t index) const;

 private:
  std::size_t size_;
  std::size_t blocks_;
  /** Blocks of eight pairs; in a block, each of 30 numbers of a pair has its row of
   * eight. */
  std::unique_ptr<double[]> storage_;
  double* rows_;  ///< The first block, aligned to a cache line.
  // What was found, in whole blocks; the normal is made of it when asked for.
  std::vector<double> axes_;
  std::vector<double> separations_;
  std::vector<double> sines_;
  std::vector<double> offsets_;
};

}  // namespace cookbook
