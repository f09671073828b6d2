#include "reports/measures/convex_polygon.h"

#include <gtest/gtest.h>

namespace touchstone {
namespace {

TEST(ConvexHullOf, DropsInnerAndCollinearPoints) {
  const std::vector<Eigen::Vector2d> points = {{0, 0}, {1, 0}, {2, 0},   {2, 2},
                                               {1, 1}, {0, 2}, {0.5, 1}, {0, 0}};
  EXPECT_EQ(ConvexHullOf(points).size(), 4U);
}

TEST(ConvexHullOf, OfASegmentIsItsEnds) {
  const std::vector<Eigen::Vector2d> points = {{1, 1}, {0, 0}, {3, 3}, {2, 2}};
  const std::vector<Eigen::Vector2d> hull = ConvexHullOf(points);
  ASSERT_EQ(hull.size(), 2U);
  EXPECT_EQ(hull[0], Eigen::Vector2d(0, 0));
  EXPECT_EQ(hull[1], Eigen::Vector2d(3, 3));
}

TEST(DistanceFrom, IsZeroInsideAndToTheNearestSideOutside) {
  const std::vector<Eigen::Vector2d> square =
      ConvexHullOf(std::vector<Eigen::Vector2d>{{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  EXPECT_EQ(DistanceFrom(square, {0.3, 0.9}), 0);
  EXPECT_DOUBLE_EQ(DistanceFrom(square, {0.3, 1.25}), 0.25);
  EXPECT_DOUBLE_EQ(DistanceFrom(square, {4, 5}), 5);
}

TEST(OffsetFrom, PointsFromTheNearestPointAndIsZeroInside) {
  const std::vector<Eigen::Vector2d> square =
      ConvexHullOf(std::vector<Eigen::Vector2d>{{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  EXPECT_EQ(OffsetFrom(square, {0.3, 0.9}), Eigen::Vector2d(0, 0));
  EXPECT_EQ(OffsetFrom(square, {0.5, 1.25}), Eigen::Vector2d(0, 0.25));
  EXPECT_EQ(OffsetFrom(square, {4, 5}), Eigen::Vector2d(3, 4));
}

TEST(LiftedAcross, UndoesTheProjection) {
  const Eigen::Vector3d n = Eigen::Vector3d(1, 2, 2) / 3;
  const Eigen::Vector3d across = Eigen::Vector3d(2, 1, -2) / 3;
  const std::vector<Eigen::Vector2d> projected = ProjectedAlong(n, std::span(&across, 1));
  EXPECT_LT((LiftedAcross(n, projected.front()) - across).norm(), 1e-15);
}

TEST(DistanceFrom, WorksForASegmentAndAPoint) {
  const std::vector<Eigen::Vector2d> segment = {{0, 0}, {2, 0}};
  EXPECT_DOUBLE_EQ(DistanceFrom(segment, {1, -3}), 3);
  const std::vector<Eigen::Vector2d> point = {{1, 1}};
  EXPECT_DOUBLE_EQ(DistanceFrom(point, {4, 5}), 5);
}

}  // namespace
}  // namespace touchstone
