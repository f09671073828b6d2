#include "reports/measures/overlap_along.h"

#include <cmath>
#include <utility>

#include <gtest/gtest.h>

#include "tests/reports/specimens.h"

namespace touchstone {
namespace {

constexpr double kDepth = 2e-3;        // [m]
constexpr double kRounding = 0x1p-46;  // [m], 64 roundings of a scene below 2 m

TEST(OverlapAlong, CostsAnUlpForANormalOffAHalfSpaceByAnUlp) {
  const Specimen s = SphereInHalfSpace(kDepth);
  Eigen::Vector3d n = *s.right.n_AB_W;
  n.x() = std::nextafter(n.x(), 1);
  const Enclosure overlap = OverlapAlong(s.query, n);
  EXPECT_NEAR(overlap.lo, kDepth, kRounding);
  EXPECT_NEAR(overlap.hi, kDepth, kRounding);
}

TEST(OverlapAlong, CostsTheSceneForANormalFlippedOnAHalfSpace) {
  const Specimen s = SphereInHalfSpace(kDepth);
  EXPECT_NEAR(OverlapAlong(s.query, -*s.right.n_AB_W).lo, kDepth + 2 * SceneSize(s.query),
              kRounding);
}

TEST(OverlapAlong, SeesTheHalfSpaceAsB) {
  Specimen s = SphereInHalfSpace(kDepth);
  std::swap(s.query.A, s.query.B);
  EXPECT_NEAR(OverlapAlong(s.query, -*s.right.n_AB_W).lo, kDepth, kRounding);
}

}  // namespace
}  // namespace touchstone
