// Tests of the bounds that choose the faces worth more digits.

#include "reports/referee/zonotope.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "tests/reports/referee/random_scene.h"

namespace touchstone::referee {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/** Returns the edges of both boxes, without rounding. */
std::vector<Eigen::Vector3d> EdgesOf(const ContactQuery& query) {
  std::vector<Eigen::Vector3d> edges;
  for (const Body* body : {&query.A, &query.B}) {
    for (int i = 0; i < 3; ++i) edges.emplace_back(body->X_WB.R_WB.col(i));
  }
  return edges;
}

/** Returns the least overlap over all cross products of edges, each in 257 bits. */
Enclosure LeastOfAll(const MinkowskiDifference& M,
                     const std::vector<Eigen::Vector3d>& edges) {
  using Number = Bounded<Precise>;
  Enclosure least{kInfinity, kInfinity};
  for (std::size_t i = 0; i < edges.size(); ++i) {
    for (std::size_t j = i + 1; j < edges.size(); ++j) {
      const Vector<Number> n =
          Cross(Exactly<Number>(edges[i]), Exactly<Number>(edges[j]));
      if (n.x.value() == 0 && n.y.value() == 0 && n.z.value() == 0) continue;
      for (const Vector<Number>& outwards : {n, -n}) {
        const Enclosure overlap = M.OverlapAlong(outwards).enclosure();
        least.lo = std::min(least.lo, overlap.lo);
        least.hi = std::min(least.hi, overlap.hi);
      }
    }
  }
  return least;
}

/** Returns two boxes whose overlaps along several faces are equal to some roundings: like
 cubes, one moved along a diagonal of the other, and turned by `turn` [rad] at most. */
ContactQuery NearTie(RandomScene& random, double turn) {
  const double half = random.Power(-3, 3);
  const Eigen::Quaterniond q = random.Rotation();
  const Eigen::Vector3d moved = half * random.Uniform(0.1, 2.1) * Eigen::Vector3d::Ones();
  const Eigen::Quaterniond more(1, random.Uniform(-turn, turn) / 2,
                                random.Uniform(-turn, turn) / 2,
                                random.Uniform(-turn, turn) / 2);
  const Box cube{Eigen::Vector3d::Constant(half)};
  const Eigen::Vector3d p_WA = half * random.Point(1);
  return {{cube, Pose::FromQuaternion(p_WA, q)},
          {cube, Pose::FromQuaternion(p_WA + q * moved,
                                      turn > 0 ? (q * more).normalized() : q)}};
}

/** Expects the least overlap, and returns its enclosure. */
Enclosure ExpectLeastOfAll(const ContactQuery& query) {
  const MinkowskiDifference M(query.A, query.B);
  const ZonotopeFaces faces(M);
  const Enclosure least = LeastOfAll(M, EdgesOf(query));
  const auto found = faces.LeastOverlap<DoubleDouble>();
  EXPECT_TRUE(found.has_value());
  if (!found) return {};
  EXPECT_LE(found->depth.lo, least.lo);
  EXPECT_GE(found->depth.hi, least.hi);
  if (faces.ProveOutside()) {
    EXPECT_LT(least.hi, 0);
  }
  return found->depth;
}

TEST(ZonotopeFaces, FindTheLeastOverlapAmongTies) {
  RandomScene random(5);
  for (int i = 0; i < 400; ++i) {
    const Enclosure depth = ExpectLeastOfAll(NearTie(random, 0));
    EXPECT_LE(depth.hi - depth.lo, std::abs(depth.hi) * 0x1p-50);
  }
}

TEST(ZonotopeFaces, FindTheLeastOverlapOfEdgesThatAreAlmostParallel) {
  RandomScene random(6);
  for (int i = 0; i < 400; ++i) ExpectLeastOfAll(NearTie(random, random.Power(-16, -6)));
}

TEST(ZonotopeFaces, ProveMostPairsApartInDouble) {
  RandomScene random(7);
  int apart = 0;
  int proved = 0;
  for (int i = 0; i < 400; ++i) {
    const ContactQuery query{
        {random.SomeBox(1), Pose::FromQuaternion(random.Point(1.5), random.Rotation())},
        {random.SomeBox(1), Pose::FromQuaternion(random.Point(1.5), random.Rotation())}};
    const MinkowskiDifference M(query.A, query.B);
    const bool is_apart = LeastOfAll(M, EdgesOf(query)).hi < 0;
    const bool is_proved = ZonotopeFaces(M).ProveOutside();
    EXPECT_LE(is_proved, is_apart);
    apart += is_apart;
    proved += is_proved;
  }
  EXPECT_GT(apart, 100);
  EXPECT_EQ(proved, apart);
}

}  // namespace
}  // namespace touchstone::referee
