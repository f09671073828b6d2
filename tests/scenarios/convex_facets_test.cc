#include "scenarios/convex_facets.h"

#include <cstddef>
#include <random>
#include <set>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace touchstone {
namespace {

using Eigen::Vector3d;

const Eigen::Matrix3d kTurn =
    Eigen::Quaterniond(0.3, -0.7, 0.41, 0.9).normalized().toRotationMatrix();

ConvexHull Turned(std::vector<Vector3d> vertices) {
  for (Vector3d& vertex : vertices) vertex = kTurn * vertex + Vector3d(0.37, -1.9, 0.83);
  return {vertices};
}

std::vector<Vector3d> CuboidCorners(const Vector3d& half_extents) {
  std::vector<Vector3d> corners;
  for (int i = 0; i < 8; ++i) {
    const Vector3d signs((i & 1) != 0 ? 1 : -1, (i & 2) != 0 ? 1 : -1,
                         (i & 4) != 0 ? 1 : -1);
    corners.push_back(signs.cwiseProduct(half_extents));
  }
  return corners;
}

std::vector<Vector3d> Prism(int sides) {
  std::vector<Vector3d> corners;
  for (int i = 0; i < sides; ++i) {
    const double angle = 2 * M_PI * i / sides;
    for (const double z : {-0.7, 0.7}) {
      corners.emplace_back(1.3 * std::cos(angle), 1.3 * std::sin(angle), z);
    }
  }
  return corners;
}

// Expects a closed, oriented, convex boundary that satisfies Euler's V − E + F = 2.
void ExpectIsTheBoundaryOf(const ConvexHull& hull, const ConvexFacets& boundary) {
  std::set<std::pair<int, int>> edges;
  std::size_t edge_uses = 0;
  for (const ConvexFacet& facet : boundary.facets) {
    ASSERT_GE(facet.corners.size(), 3u);
    EXPECT_NEAR(facet.n_B.norm(), 1, 4 * 0x1p-53);
    for (std::size_t i = 0; i < facet.corners.size(); ++i) {
      edges.emplace(facet.corners[i], facet.corners[(i + 1) % facet.corners.size()]);
      ++edge_uses;
    }
    // Coordinates are below 4 m. The plane of a polygon is fitted to points that are flat
    // to kFlatness of that, and a thin facet tilts it by as much again.
    constexpr double kRounding = 4 * 4 * kFlatness;
    for (const Vector3d& vertex : hull.vertices) {
      EXPECT_LE(facet.n_B.dot(vertex), facet.offset + kRounding);
    }
    for (const int corner : facet.corners) {
      const Vector3d& x = boundary.corners[static_cast<std::size_t>(corner)];
      EXPECT_NEAR(facet.n_B.dot(x), facet.offset, kRounding);
    }
    EXPECT_LT(facet.n_B.dot(boundary.centre), facet.offset);
  }
  EXPECT_EQ(edges.size(), edge_uses) << "an edge is used twice in one direction";
  for (const auto& [from, to] : edges) EXPECT_TRUE(edges.contains({to, from}));
  EXPECT_EQ(boundary.corners.size() + boundary.facets.size(), edges.size() / 2 + 2);
}

TEST(ConvexFacets, OfARotatedCuboidAreSixQuadrilaterals) {
  const ConvexHull hull = Turned(CuboidCorners({0.31, 1.7, 0.052}));
  const auto boundary = BoundaryOf(hull);
  ASSERT_TRUE(boundary);
  EXPECT_EQ(boundary->corners.size(), 8u);
  ASSERT_EQ(boundary->facets.size(), 6u);
  for (const ConvexFacet& facet : boundary->facets) EXPECT_EQ(facet.corners.size(), 4u);
  ExpectIsTheBoundaryOf(hull, *boundary);
}

TEST(ConvexFacets, LeaveOutPointsInsideOnFacesAndOnEdges) {
  std::vector<Vector3d> vertices = {
      {0, 0, 0}, {0.1, 0.2, 0.5}, {0.25, 0.5, 0.1}, {0.25, 0.5, 0.5}};
  for (const Vector3d& corner : CuboidCorners({0.25, 0.5, 0.5}))
    vertices.push_back(corner);
  const auto boundary = BoundaryOf({vertices});
  ASSERT_TRUE(boundary);
  EXPECT_EQ(boundary->corners.size(), 8u);
  EXPECT_EQ(boundary->facets.size(), 6u);
  ExpectIsTheBoundaryOf({vertices}, *boundary);
}

TEST(ConvexFacets, OfAPrismAreItsSidesAndTwoPolygons) {
  for (const int sides : {3, 5, 8, 38}) {
    const ConvexHull hull = Turned(Prism(sides));
    const auto boundary = BoundaryOf(hull);
    ASSERT_TRUE(boundary);
    EXPECT_EQ(boundary->corners.size(), hull.vertices.size());
    EXPECT_EQ(boundary->facets.size(), static_cast<std::size_t>(sides) + 2);
    ExpectIsTheBoundaryOf(hull, *boundary);
  }
}

TEST(ConvexFacets, OfPointsOnASphereHaveEveryPointAsACorner) {
  std::mt19937_64 random(20240607);
  std::normal_distribution<double> normal;
  std::vector<Vector3d> vertices;
  for (int i = 0; i < 120; ++i) {
    vertices.push_back(
        Vector3d(normal(random), normal(random), normal(random)).normalized());
  }
  const ConvexHull hull = Turned(vertices);
  const auto boundary = BoundaryOf(hull);
  ASSERT_TRUE(boundary);
  EXPECT_EQ(boundary->corners, hull.vertices);
  ExpectIsTheBoundaryOf(hull, *boundary);
}

TEST(ConvexFacets, AreNotBridgedByASliverAtAnEdge) {
  std::vector<Vector3d> vertices = CuboidCorners({0.5, 0.5, 0.5});
  vertices.emplace_back(0.1, 0.5 + 0x1p-53, 0.5 + 0x1p-53);  // One ulp outside an edge.
  const auto boundary = BoundaryOf({vertices});
  ASSERT_TRUE(boundary);
  EXPECT_EQ(boundary->facets.size(), 6u);
  ExpectIsTheBoundaryOf({vertices}, *boundary);
}

TEST(ConvexFacets, OfAFlatHullDoNotExist) {
  EXPECT_FALSE(BoundaryOf({{{1, 2, 3}}}));
  EXPECT_FALSE(BoundaryOf({{{1, 2, 3}, {1, 2, 3}}}));
  EXPECT_FALSE(BoundaryOf(Turned({{0, 0, 0}, {1, 0, 0}, {0.3, 0, 0}})));
  EXPECT_FALSE(BoundaryOf(Turned({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1.7, 1.3, 0}})));
}

}  // namespace
}  // namespace touchstone
