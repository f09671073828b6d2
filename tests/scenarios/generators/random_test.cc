#include "scenarios/generators/random.h"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "scenarios/generators/portable_math.h"

namespace touchstone {
namespace {

TEST(Random, IsAFunctionOfItsKey) {
  Random one({1, 2}), same({1, 2}), swapped({2, 1}), longer({1, 2, 0});
  const std::uint64_t bits = one.Bits();
  EXPECT_EQ(bits, same.Bits());
  EXPECT_NE(bits, swapped.Bits());
  EXPECT_NE(bits, longer.Bits());
}

TEST(Random, IsUniform) {
  // The mean of n uniform numbers has the standard deviation 1 / √(12 n): 0.003 at n =
  // 10⁴. The bound is four of these.
  Random random({7});
  double sum = 0;
  std::array<int, 10> tenths{};
  for (int i = 0; i < 10000; ++i) {
    const double u = random.Uniform();
    ASSERT_GE(u, 0);
    ASSERT_LT(u, 1);
    sum += u;
    ++tenths[static_cast<std::size_t>(10 * u)];
  }
  EXPECT_NEAR(sum / 10000, 0.5, 0.012);
  // A count with mean 1000 has a standard deviation of 30.
  for (const int count : tenths) EXPECT_NEAR(count, 1000, 120);
}

TEST(Random, DrawsEveryIntegerBelowABound) {
  Random random({8});
  std::array<int, 3> counts{};
  for (int i = 0; i < 3000; ++i) ++counts.at(static_cast<std::size_t>(random.Below(3)));
  for (const int count : counts) EXPECT_NEAR(count, 1000, 110);
}

TEST(Random, DrawsAllDecadesEquallyOften) {
  Random random({9});
  std::array<int, 16> counts{};
  for (int i = 0; i < 16000; ++i) {
    const double value = random.Decades(-16, 0);
    ASSERT_GE(value, 1e-16);
    ASSERT_LE(value, 1);
    ++counts.at(static_cast<std::size_t>(std::floor(std::log10(value)) + 16));
  }
  for (const int count : counts) EXPECT_NEAR(count, 1000, 130);
}

TEST(Random, DrawsUniformUnitDirectionsAndRotations) {
  Random random({10});
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  Eigen::Vector4d squares = Eigen::Vector4d::Zero();
  for (int i = 0; i < 10000; ++i) {
    const Eigen::Vector3d n = random.Direction();
    ASSERT_NEAR(n.norm(), 1, 1e-15);
    ASSERT_NEAR(random.PlaneDirection().norm(), 1, 1e-15);
    const Eigen::Quaterniond q = random.Rotation();
    ASSERT_NEAR(q.norm(), 1, 1e-15);
    mean += n / 10000;
    squares += q.coeffs().cwiseAbs2() / 10000;
  }
  // A component of a direction has variance 1/3, so its mean has a standard deviation of
  // 0.006.
  EXPECT_LT(mean.cwiseAbs().maxCoeff(), 0.025);
  // The square of a component of a unit quaternion has mean 1/4 and variance 1/16.
  EXPECT_LT((squares.array() - 0.25).abs().maxCoeff(), 0.01);
}

TEST(PortableMath, AgreesWithEigen) {
  Random random({11});
  for (int i = 0; i < 100; ++i) {
    const Eigen::Quaterniond p = random.Rotation();
    const Eigen::Quaterniond q = random.Rotation();
    const Eigen::Vector3d v = random.Direction();
    const Eigen::Vector3d w = random.Direction();
    const Eigen::Matrix3d R = p.toRotationMatrix();
    EXPECT_NEAR(Dot(v, w), v.dot(w), 1e-15);
    EXPECT_TRUE(Cross(v, w).isApprox(v.cross(w), 1e-14));
    EXPECT_TRUE(Apply(R, v).isApprox(R * v, 1e-14));
    EXPECT_TRUE(ApplyInverse(R, v).isApprox(R.transpose() * v, 1e-14));
    EXPECT_TRUE(
        Product(R, q.toRotationMatrix()).isApprox(R * q.toRotationMatrix(), 1e-14));
    EXPECT_TRUE(Product(p, q).isApprox(p * q, 1e-14));
  }
}

TEST(PortableMath, RotatesByTwiceTheArcTangent) {
  const Eigen::Vector3d axis = Eigen::Vector3d(0.2, -0.7, 0.4).normalized();
  const Eigen::AngleAxisd turn(RotationByHalfTangent(axis, 0.3));
  EXPECT_NEAR(turn.angle(), 2 * std::atan(0.3), 1e-15);
  EXPECT_TRUE(turn.axis().isApprox(axis, 1e-14));
}

TEST(PortableMath, RotatesOneDirectionToAnotherByTheSmallestAngle) {
  const Eigen::Vector3d from = Eigen::Vector3d(0.2, -0.7, 0.4).normalized();
  const Eigen::Vector3d to = Eigen::Vector3d(-0.1, 0.3, 0.9).normalized();
  const Eigen::Quaterniond q = LeastRotation(from, to);
  EXPECT_TRUE((q * from).isApprox(to, 1e-14));
  EXPECT_NEAR(Eigen::AngleAxisd(q).angle(), std::acos(from.dot(to)), 1e-14);
}

}  // namespace
}  // namespace touchstone
