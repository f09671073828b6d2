// Spheres against spheres and boxes: closed forms at awkward poses.

#include <bit>
#include <cmath>
#include <cstdint>

#include <gtest/gtest.h>

#include "engine/collision/collide.h"
#include "engine/collision/feature.h"
#include "engine/collision/rounding.h"
#include "tests/engine/on_target.h"
#include "tests/engine/random_boxes.h"

namespace cookbook::test {
namespace {

constexpr int kQuestions = 2000;

/** The error of 32 roundings of coordinates below 16 m. [m] */
constexpr double kRounding = 32 * 16 * kUnitRoundoff;

Pose AnyPose(Random& random) {
  return {random.Rotation(), 5 * random.Direction()};
}

TEST(SphereOnSphere, SeparationIsCentreDistanceLessBothRadii) {
  Random random(1);
  int touching = 0;
  for (int k = 0; k < kQuestions; ++k) {
    const Sphere A{random.Between(0.1, 2)};
    const Sphere B{random.Between(0.1, 2)};
    const Pose X_WA = AnyPose(random);
    Pose X_WB = AnyPose(random);
    const Eigen::Vector3d n_AB_W = random.Direction();
    const double separation = random.Between(-1, 1) * (A.radius + B.radius);
    X_WB.p_WB = X_WA.p_WB + (A.radius + B.radius + separation) * n_AB_W;

    const Manifold manifold = Collide(A, X_WA, B, X_WB);
    EXPECT_EQ(manifold.touching, separation <= 0);
    EXPECT_NEAR(manifold.separation, separation, kRounding);
    const double distance = A.radius + B.radius + separation;
    EXPECT_LT((manifold.n_AB_W - n_AB_W).norm(), kRounding / distance);
    ASSERT_EQ(manifold.count, manifold.touching ? 1 : 0);
    if (!manifold.touching) continue;
    ++touching;
    const ContactPoint& contact = manifold.contacts[0];
    EXPECT_EQ(contact.separation, manifold.separation);
    // On both surfaces, half the overlap to either side.
    const Eigen::Vector3d half = manifold.n_AB_W * contact.separation / 2;
    EXPECT_NEAR((contact.p_WC - half - X_WA.p_WB).norm(), A.radius, kRounding);
    EXPECT_NEAR((contact.p_WC + half - X_WB.p_WB).norm(), B.radius, kRounding);
  }
  EXPECT_GT(touching, kQuestions / 3);
}

TEST(SphereOnSphere, ConcentricSpheresAreSumOfRadiiDeep) {
  Random random(2);
  for (const double apart : {0.0, 1e-300, 1e-160, 1e-12}) {
    const Pose X_WA{random.Rotation(), Eigen::Vector3d::Zero()};
    const Pose X_WB{random.Rotation(), apart * random.Direction()};
    const Manifold manifold = Collide(Sphere{0.3}, X_WA, Sphere{0.7}, X_WB);
    EXPECT_TRUE(manifold.touching);
    EXPECT_NEAR(manifold.separation, -1.0 + apart, 4 * kUnitRoundoff);
    EXPECT_NEAR(manifold.n_AB_W.norm(), 1, 4 * kUnitRoundoff);
    EXPECT_EQ(manifold.count, 1);
  }
}

TEST(SphereOnSphere, ExactTouchCounts) {
  // 0.75 + 0.5 = 1.25, all exact in binary.
  const Pose X_WA;
  const Pose X_WB{Eigen::Matrix3d::Identity(), {0, 0, 1.25}};
  EXPECT_TRUE(Collide(Sphere{0.75}, X_WA, Sphere{0.5}, X_WB).touching);
}

TEST(SphereOnBox, NearestPointDecidesOutside) {
  Random random(3);
  int touching = 0;
  for (int k = 0; k < kQuestions; ++k) {
    const Box A{{random.Between(0.1, 2), random.Between(0.1, 2), random.Between(0.1, 2)}};
    const Sphere B{random.Between(0.1, 2)};
    const Pose X_WA = AnyPose(random);
    // Nearest to a face, an edge or a vertex: outward along one, two or three axes, from
    // a point that is on the box's surface along exactly these axes.
    const int region = 1 + random.Below(7);
    Eigen::Vector3d p_AQ;
    Eigen::Vector3d n_A = random.Direction();
    Eigen::Vector3i side(0, 0, 0);
    for (int axis = 0; axis < 3; ++axis) {
      const double h = A.half_extents[axis];
      const bool rim = (region >> axis & 1) != 0;
      p_AQ[axis] = rim ? std::copysign(h, n_A[axis]) : random.Between(-h, h);
      if (!rim) n_A[axis] = 0;
      if (rim) side[axis] = n_A[axis] < 0 ? -1 : 1;
    }
    n_A.normalize();
    const double distance = random.Between(1e-3, 2.5);
    const Pose X_WB{random.Rotation(), X_WA.p_WB + X_WA.R_WB * (p_AQ + distance * n_A)};

    const Manifold manifold = Collide(A, X_WA, B, X_WB);
    EXPECT_EQ(manifold.touching, distance <= B.radius);
    EXPECT_NEAR(manifold.separation, distance - B.radius, kRounding);
    EXPECT_LT((manifold.n_AB_W - X_WA.R_WB * n_A).norm(), kRounding / distance);
    ASSERT_EQ(manifold.count, manifold.touching ? 1 : 0);
    if (!manifold.touching) continue;
    ++touching;
    const ContactPoint& contact = manifold.contacts[0];
    const Eigen::Vector3d half = manifold.n_AB_W * contact.separation / 2;
    EXPECT_LT((contact.p_WC - half - (X_WA.p_WB + X_WA.R_WB * p_AQ)).norm(), kRounding);
    EXPECT_NEAR((contact.p_WC + half - X_WB.p_WB).norm(), B.radius, kRounding / distance);
    EXPECT_EQ(contact.feature, SphereContactId(side[0], side[1], side[2]));

    const Manifold swapped = Collide(B, X_WB, A, X_WA);
    EXPECT_EQ(swapped.n_AB_W, -manifold.n_AB_W);
    EXPECT_EQ(swapped.separation, manifold.separation);
    EXPECT_EQ(swapped.contacts[0].p_WC, contact.p_WC);
  }
  EXPECT_GT(touching, kQuestions / 4);
}

TEST(SphereOnBox, CentreInsideLeavesThroughTheNearestFace) {
  Random random(4);
  for (int k = 0; k < kQuestions; ++k) {
    const Box A{{random.Between(0.3, 2), random.Between(0.3, 2), random.Between(0.3, 2)}};
    const Sphere B{random.Between(0.01, 2)};
    const Pose X_WA = AnyPose(random);
    // At the distance `in` from the face on `axis`, further from every other face.
    const int axis = random.Below(3);
    const double in = random.Between(0, 0.2);
    Eigen::Vector3d p_AB_A;
    for (int other = 0; other < 3; ++other) {
      const double free = A.half_extents[other] - in - 0.05;
      p_AB_A[other] = random.Between(-free, free);
    }
    const double side = random.Below(2) == 0 ? -1 : 1;
    p_AB_A[axis] = side * (A.half_extents[axis] - in);
    const Pose X_WB{random.Rotation(), X_WA.p_WB + X_WA.R_WB * p_AB_A};

    const Manifold manifold = Collide(A, X_WA, B, X_WB);
    ASSERT_EQ(manifold.count, 1);
    EXPECT_NEAR(manifold.separation, -(B.radius + in), kRounding);
    EXPECT_LT((manifold.n_AB_W - side * X_WA.R_WB.col(axis)).norm(), kRounding);
    const int sign = side < 0 ? -1 : 1;
    EXPECT_EQ(manifold.contacts[0].feature,
              SphereContactId(axis == 0 ? sign : 0, axis == 1 ? sign : 0,
                              axis == 2 ? sign : 0));
  }
}

TEST(SphereOnBox, CentreOnTheSurfaceTouchesRadiusDeep) {
  const Box A{{0.5, 0.25, 0.75}};
  const Pose X_WA;
  for (const Eigen::Vector3d& p_AB :
       {Eigen::Vector3d(0.5, 0, 0), Eigen::Vector3d(0.5, 0.25, 0),
        Eigen::Vector3d(0.5, -0.25, 0.75), Eigen::Vector3d(0.5, 0.25, 1e-200)}) {
    const Manifold manifold =
        Collide(A, X_WA, Sphere{0.1}, {Eigen::Matrix3d::Identity(), p_AB});
    EXPECT_EQ(manifold.separation, -0.1);
    EXPECT_EQ(manifold.n_AB_W.norm(), 1);
  }
}

using SphereOnBoxOnTarget = OnTarget;

TEST_P(SphereOnBoxOnTarget, ReturnsTheBitsOfTheWidestVectors) {
  Random random(5);
  const auto expect_same_bits = [](double a, double b) {
    EXPECT_EQ(std::bit_cast<std::uint64_t>(a), std::bit_cast<std::uint64_t>(b));
  };
  int touching = 0;
  for (int k = 0; k < 300 && !HasFailure(); ++k) {
    const Box A{{random.Between(0.1, 2), random.Between(0.1, 2), random.Between(0.1, 2)}};
    const Sphere B{random.Between(0.1, 2)};
    const Pose X_WA = AnyPose(random);
    const Pose X_WB{random.Rotation(), X_WA.p_WB + random.Within(4)};
    Choose(GetParam());
    const Manifold narrow = Collide(A, X_WA, B, X_WB);
    Choose(kAll);
    const Manifold wide = Collide(A, X_WA, B, X_WB);
    ASSERT_EQ(narrow.count, wide.count);
    expect_same_bits(narrow.separation, wide.separation);
    for (int n = 0; n < 3; ++n) expect_same_bits(narrow.n_AB_W[n], wide.n_AB_W[n]);
    if (!wide.touching) continue;
    ++touching;
    const ContactPoint& a = narrow.contacts[0];
    const ContactPoint& b = wide.contacts[0];
    EXPECT_EQ(a.feature, b.feature);
    expect_same_bits(a.separation, b.separation);
    for (int n = 0; n < 3; ++n) expect_same_bits(a.p_WC[n], b.p_WC[n]);
  }
  EXPECT_GT(touching, 100);
}

INSTANTIATE_TEST_SUITE_P(Targets, SphereOnBoxOnTarget, testing::ValuesIn(Targets()),
                         NameOfTarget);

}  // namespace
}  // namespace cookbook::test
