#include "reports/contacts/checks/consistency_error.h"

#include <gtest/gtest.h>

#include "tests/reports/specimens.h"

namespace touchstone {
namespace {

constexpr double kDepth = 2e-3;        // [m]
constexpr double kRounding = 0x1p-46;  // [m], 64 roundings of a scene below 2 m

TEST(ConsistencyError, IsNoneForARightAnswer) {
  for (const Specimen& s :
       {SphereInBoxFace(kDepth), BoxOnBoxFace(kDepth), SphereInHalfSpace(kDepth)}) {
    EXPECT_LE(ConsistencyError(s.query, *s.right.n_AB_W, *s.right.separation), kRounding);
  }
}

TEST(ConsistencyError, OfAHalvedDepthIsTheOtherHalf) {
  const Specimen s = SphereInBoxFace(kDepth);
  EXPECT_NEAR(ConsistencyError(s.query, *s.right.n_AB_W, -kDepth / 2), kDepth / 2,
              kRounding);
}

TEST(ConsistencyError, OfASwappedSignIsTwiceTheDepth) {
  const Specimen s = SphereInBoxFace(kDepth);
  EXPECT_NEAR(ConsistencyError(s.query, *s.right.n_AB_W, kDepth), 2 * kDepth, kRounding);
}

TEST(ConsistencyError, OfAFlippedNormalIsTheDistanceThroughBothBodies) {
  // Moved against n, B leaves through A's far face: o(-n) = 2 h + 2 r - d.
  const Specimen s = SphereInBoxFace(kDepth);
  EXPECT_NEAR(ConsistencyError(s.query, -*s.right.n_AB_W, -kDepth),
              0.2 + 2.0 / 3 - 2 * kDepth, kRounding);
}

TEST(ConsistencyError, HoldsForABadDirectionThatKnowsItsOwnDepth) {
  // Along A's x, o = 0.3 + r - 0.07: the answer is consistent, though far from the least
  // overlap.
  const Specimen s = SphereInBoxFace(kDepth);
  EXPECT_LE(
      ConsistencyError(s.query, s.query.A.X_WB.R_WB.col(0), -(0.3 + 1.0 / 3 - 0.07)),
      kRounding);
}

}  // namespace
}  // namespace touchstone
