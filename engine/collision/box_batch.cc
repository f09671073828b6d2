#include "engine/collision/box_batch.h"

#include <cstdint>

#include "engine/collision/box_batch_layout.h"
#include "engine/collision/separating_axis.h"

namespace cookbook {
namespace {

constexpr std::size_t kBlock = kRows * kLanes;

/** Returns the kernel's results for one pair as an AxisGap. */
AxisGap ToAxisGap(int axis, double separation, double sine, double offset) {
  AxisGap gap{AxisKind::kEdges, 0, 0, separation, 1 / sine, offset};
  if (axis < 3) {
    gap.kind = AxisKind::kFaceOfA;
    gap.i = axis;
  } else if (axis < 6) {
    gap.kind = AxisKind::kFaceOfB;
    gap.j = axis - 3;
  } else {
    gap.i = (axis - 6) / 3;
    gap.j = (axis - 6) % 3;
  }
  return gap;
}

/** Returns the normal of `gap` in the world frame. */
Eigen::Vector3d Normal(const AxisGap& gap, const Eigen::Matrix3d& R_WA,
                       const Eigen::Matrix3d& R_WB) {
  // The same operations as in FindLeastOverlap() for the entries of R_AB.
  const auto entry = [&](int i) {
    return R_WA(0, i) * R_WB(0, gap.j) + R_WA(1, i) * R_WB(1, gap.j) +
           R_WA(2, i) * R_WB(2, gap.j);
  };
  return NormalInWorld(FacingOf(gap, entry(Next(gap.i)), entry(AfterNext(gap.i))), R_WA,
                       R_WB);
}

/** Returns the rotation of one lane of a block, whose first entry is at `lane`. */
Eigen::Matrix3d Rotation(const double* lane) {
  Eigen::Matrix3d R;
  for (std::size_t k = 0; k < 9; ++k) R.data()[k] = lane[k * kLanes];
  return R;
}

}  // namespace

BoxGap FindGap(const Box& A, const Pose& X_WA, const Box& B, const Pose& X_WB) {
  BoxPair pair;
  const AxisGap gap = FindLeastOverlap(A, X_WA, B, X_WB, pair);
  return {gap.separation, Normal(gap, X_WA.R_WB, X_WB.R_WB)};
}

BoxBatch::BoxBatch(std::size_t size)
    : size_(size),
      blocks_((size + kLanes - 1) / kLanes),
      axes_(blocks_ * kLanes),
      separations_(blocks_ * kLanes),
      sines_(blocks_ * kLanes),
      offsets_(blocks_ * kLanes) {
  // Unused lanes of the last block hold zeros; their results are not read.
  constexpr std::size_t kLine = 64 / sizeof(double);
  storage_ = std::make_unique<double[]>(blocks_ * kBlock + kLine);
  const auto address = reinterpret_cast<std::uintptr_t>(storage_.get());
  rows_ = storage_.get() + (64 - address % 64) % 64 / sizeof(double);
}

void BoxBatch::Set(std::size_t index, const Box& A, const Pose& X_WA, const Box& B,
                   const Pose& X_WB) {
  double* lane = rows_ + index / kLanes * kBlock + index % kLanes;
  const auto put = [&](std::size_t first, const Box& box, const Pose& X_WO) {
    for (std::size_t k = 0; k < 9; ++k) {
      lane[(first + kRotationRow + k) * kLanes] = X_WO.R_WB.data()[k];
    }
    for (std::size_t k = 0; k < 3; ++k) {
      lane[(first + kPlaceRow + k) * kLanes] = X_WO.p_WB.data()[k];
      lane[(first + kHalfExtentsRow + k) * kLanes] = box.half_extents.data()[k];
    }
  };
  put(0, A, X_WA);
  put(kRowsOfB, B, X_WB);
}

void BoxBatch::FindGaps() {
  FindBlockGaps(rows_, blocks_,
                {axes_.data(), separations_.data(), sines_.data(), offsets_.data()});
}

BoxGap BoxBatch::gap(std::size_t index) const {
  const double* lane = rows_ + index / kLanes * kBlock + index % kLanes;
  const AxisGap gap = ToAxisGap(static_cast<int>(axes_[index]), separations_[index],
                                sines_[index], offsets_[index]);
  return {gap.separation, Normal(gap, Rotation(lane + kRotationRow * kLanes),
                                 Rotation(lane + (kRowsOfB + kRotationRow) * kLanes))};
}

}  // namespace cookbook
