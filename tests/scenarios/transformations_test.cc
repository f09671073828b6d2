#include "scenarios/transformations.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>

#include <gtest/gtest.h>

#include "reports/referee/referee.h"
#include "scenarios/cube_rotations.h"
#include "scenarios/generators/generate.h"
#include "scenarios/validate.h"
#include "tests/scenarios/same_bits.h"

namespace touchstone {
namespace {

// A rotation about no coordinate axis, and a translation comparable to the scenes.
Pose AwkwardMotion() {
  return Pose::FromQuaternion({3.1, -0.7, 1.3},
                              Eigen::Quaterniond(0.3, -0.52, 0.71, 0.29).normalized());
}

/** Calls `check` with 20 queries of each family for the pairs whose truth has a tight
 enclosure at every pose. */
void ForManyQuestions(const std::function<void(const ContactQuery&)>& check) {
  constexpr ShapeKind kKinds[] = {ShapeKind::kSphere, ShapeKind::kBox,
                                  ShapeKind::kCapsule, ShapeKind::kHalfSpace};
  for (const Family family : AllFamilies()) {
    for (const ShapeKind a : kKinds) {
      for (const ShapeKind b : kKinds) {
        if (a == ShapeKind::kHalfSpace && b == ShapeKind::kHalfSpace) continue;
        for (std::uint64_t i = 0; i < 20; ++i) check(Generate(family, a, b, 5, i));
      }
    }
  }
}

/** Checks that some value in `after`, with an error of at most `slack`, is `factor` times
 some value in `before`. */
void ExpectSame(const Enclosure& before, double factor, const Enclosure& after,
                double slack) {
  EXPECT_LE(after.lo - slack, factor * before.hi);
  EXPECT_GE(after.hi + slack, factor * before.lo);
}

TEST(Swapped, KeepsTheSeparation) {
  ForManyQuestions([](const ContactQuery& query) {
    const TransformedQuery swapped = Swapped(query);
    ASSERT_TRUE(FaultsOf(swapped.query).empty());
    EXPECT_EQ(swapped.rounding, 0);
    ExpectSame(ComputeContactTruth(query).separation, 1,
               ComputeContactTruth(swapped.query).separation, 0);
    EXPECT_TRUE(SameBits(Swapped(swapped.query).query, query));
  });
}

TEST(MovedRigidly, KeepsTheSeparationToItsRounding) {
  ForManyQuestions([](const ContactQuery& query) {
    const TransformedQuery moved = MovedRigidly(query, AwkwardMotion());
    ASSERT_TRUE(FaultsOf(moved.query).empty());
    ExpectSame(ComputeContactTruth(query).separation, 1,
               ComputeContactTruth(moved.query).separation, moved.rounding);
  });
}

TEST(MovedRigidly, StatesARoundingOfAtMostAHundredUnitRoundoffsOfTheScene) {
  // 64 u (L + |t|) + 3 δ L, with δ at most 8 u for a matrix from a normalised quaternion.
  ForManyQuestions([](const ContactQuery& query) {
    const double size = std::sqrt(3.0) * SceneSize(query) + AwkwardMotion().p_WB.norm();
    EXPECT_LE(MovedRigidly(query, AwkwardMotion()).rounding, 100 * 0x1p-53 * size);
  });
}

TEST(MovedRigidly, BreaksTheLawIfItIsWrong) {
  // This tests the test: a motion that omits B's rotation breaks the law by more than the
  // rounding.
  int broken = 0;
  ForManyQuestions([&](const ContactQuery& query) {
    TransformedQuery moved = MovedRigidly(query, AwkwardMotion());
    moved.query.B.X_WB.R_WB = query.B.X_WB.R_WB;
    const Enclosure before = ComputeContactTruth(query).separation;
    const Enclosure after = ComputeContactTruth(moved.query).separation;
    if (after.lo - moved.rounding > before.hi || after.hi + moved.rounding < before.lo) {
      ++broken;
    }
  });
  // Rotating a sphere changes nothing, nor does rotating B about the centre of a sphere
  // A. That leaves the 11 of 15 pairs in which B is not a sphere, minus a few concentric
  // queries.
  EXPECT_GT(broken, 0.95 * 9 * 11 * 20);
}

TEST(Scaled, ByAPowerOfTwoScalesTheSeparationExactly) {
  ForManyQuestions([](const ContactQuery& query) {
    const TransformedQuery scaled = Scaled(query, 0x1p-7);
    ASSERT_TRUE(FaultsOf(scaled.query).empty());
    EXPECT_EQ(scaled.rounding, 0);
    ExpectSame(ComputeContactTruth(query).separation, 0x1p-7,
               ComputeContactTruth(scaled.query).separation, 0);
    EXPECT_TRUE(SameBits(Scaled(scaled.query, 0x1p7).query, query));
  });
}

TEST(Scaled, ByAnyFactorScalesTheSeparationToItsRounding) {
  ForManyQuestions([](const ContactQuery& query) {
    const TransformedQuery scaled = Scaled(query, 1.0 / 3);
    EXPECT_GT(scaled.rounding, 0);
    ExpectSame(ComputeContactTruth(query).separation, 1.0 / 3,
               ComputeContactTruth(scaled.query).separation, scaled.rounding);
  });
}

TEST(Relabelled, IsTheSameSolidForEverySymmetryOfABox) {
  const Body box{Box{{0.3, 0.7, 1.1}}, AwkwardMotion()};
  for (int symmetry = 0; symmetry < kCubeRotations; ++symmetry) {
    const Body relabelled = Relabelled(box, symmetry);
    // The unordered half axes in the world frame are the same six vectors bit for bit.
    const Eigen::Matrix3d axes =
        box.X_WB.R_WB * std::get<Box>(box.shape).half_extents.asDiagonal();
    const Eigen::Matrix3d relabelled_axes =
        relabelled.X_WB.R_WB * std::get<Box>(relabelled.shape).half_extents.asDiagonal();
    for (int i = 0; i < 3; ++i) {
      int matches = 0;
      for (int j = 0; j < 3; ++j) {
        if (axes.col(i) == relabelled_axes.col(j) ||
            axes.col(i) == -relabelled_axes.col(j)) {
          ++matches;
        }
      }
      EXPECT_EQ(matches, 1) << symmetry;
    }
    EXPECT_TRUE(FaultsOf(relabelled).empty());
  }
}

TEST(Relabelled, KeepsTheSeparation) {
  int symmetry = 0;
  ForManyQuestions([&](const ContactQuery& query) {
    symmetry = (symmetry + 1) % kCubeRotations;
    const TransformedQuery relabelled = Relabelled(query, symmetry, 23 - symmetry);
    EXPECT_EQ(relabelled.rounding, 0);
    ExpectSame(ComputeContactTruth(query).separation, 1,
               ComputeContactTruth(relabelled.query).separation, 0);
  });
}

TEST(Perturbed, ChangesTheSeparationByNoMoreThanTheOffset) {
  const Eigen::Vector3d offset(3e-7, -1e-7, 2e-7);
  int changed = 0;
  ForManyQuestions([&](const ContactQuery& query) {
    const TransformedQuery perturbed = Perturbed(query, offset);
    const Enclosure before = ComputeContactTruth(query).separation;
    const Enclosure after = ComputeContactTruth(perturbed.query).separation;
    ExpectSame(before, 1, after, offset.norm() + perturbed.rounding);
    if (after.lo > before.hi || after.hi < before.lo) ++changed;
  });
  EXPECT_GT(changed, 9 * 15 * 20 / 2);
}

}  // namespace
}  // namespace touchstone
