#include "reports/contacts/exact_scene.h"

#include <gtest/gtest.h>

namespace touchstone {
namespace {

constexpr double kDouble = 0x1p-53;
constexpr double kFloat = 0x1p-24;

ContactQuery Cubes(const Eigen::Vector3d& p_WB, double half = 0.5) {
  const Box cube{Eigen::Vector3d::Constant(half)};
  return {{cube, Pose{}}, {cube, Pose::FromMatrix(p_WB, Eigen::Matrix3d::Identity())}};
}

TEST(ExactScene, HasShortNumbers) {
  EXPECT_TRUE(IsExactScene(Cubes({0, 0, 1}), kDouble));
  EXPECT_TRUE(IsExactScene(Cubes({0, 0, 1}), kFloat));
  EXPECT_TRUE(IsExactScene(Cubes({0.25, -3.5, 1e3}), kDouble));
  // 0.1 has 52 bits, and so has no exact square.
  EXPECT_FALSE(IsExactScene(Cubes({0, 0, 0.1}), kDouble));
  EXPECT_FALSE(IsExactScene(Cubes({0, 0, 1}, 0.3), kDouble));
}

TEST(ExactScene, DependsOnThePrecision) {
  // 1 and 2^-12 have 13 bits together, their squares 26.
  EXPECT_TRUE(IsExactScene(Cubes({0, 0x1p-12, 1}), kDouble));
  EXPECT_FALSE(IsExactScene(Cubes({0, 0x1p-12, 1}), kFloat));
}

TEST(ExactScene, IsAligned) {
  ContactQuery query = Cubes({0, 0, 1});
  Eigen::Matrix3d quarter;
  quarter << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  query.B.X_WB = Pose::FromMatrix({0, 0, 1}, quarter);
  EXPECT_TRUE(IsExactScene(query, kDouble));
  const Eigen::Matrix3d turned(Eigen::AngleAxisd(0.1, Eigen::Vector3d::UnitZ()));
  query.B.X_WB = Pose::FromMatrix({0, 0, 1}, turned);
  EXPECT_FALSE(IsExactScene(query, kDouble));
}

}  // namespace
}  // namespace touchstone
