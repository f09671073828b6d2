#include "scenarios/cube_rotations.h"

#include <Eigen/LU>
#include <gtest/gtest.h>

namespace touchstone {
namespace {

TEST(CubeRotation, IsOneOfTwentyFourDistinctSignedPermutationsWithoutMirroring) {
  EXPECT_EQ(CubeRotation(0), Eigen::Matrix3d::Identity());
  for (int i = 0; i < kCubeRotations; ++i) {
    const Eigen::Matrix3d R = CubeRotation(i);
    EXPECT_EQ(R.transpose() * R, Eigen::Matrix3d::Identity()) << i;
    EXPECT_EQ(R.determinant(), 1) << i;
    EXPECT_EQ(R.cwiseAbs().sum(), 3) << i;
    for (int j = 0; j < i; ++j) EXPECT_NE(R, CubeRotation(j)) << i << ' ' << j;
  }
}

}  // namespace
}  // namespace touchstone
