// The filter in double against the dot products in high precision.

#include "reports/referee/farthest_vertices.h"

#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "reports/referee/vector.h"
#include "tests/reports/referee/random_scene.h"

namespace touchstone {
namespace {

using referee::Exactly;
using referee::ForEachFarthest;
using referee::Precise;

/** Returns the indices of the vertices that are visited. */
std::vector<std::size_t> VisitedOf(const std::vector<Eigen::Vector3d>& vertices,
                                   const Eigen::Vector3d& n,
                                   const Eigen::Vector3d& error) {
  std::vector<std::size_t> visited;
  ForEachFarthest(vertices, n, error, [&](const Eigen::Vector3d& v) {
    visited.push_back(static_cast<std::size_t>(&v - vertices.data()));
  });
  return visited;
}

std::size_t FarthestOf(const std::vector<Eigen::Vector3d>& vertices,
                       const Eigen::Vector3d& n) {
  std::size_t farthest = 0;
  const auto along = [&](std::size_t i) {
    return Dot(Exactly<Precise>(n), Exactly<Precise>(vertices[i]));
  };
  for (std::size_t i = 1; i < vertices.size(); ++i) {
    if (along(i) > along(farthest)) farthest = i;
  }
  return farthest;
}

/** Directions known to all digits or to some, vertices that are all about equally far in
 half of the hulls, and lengths of every magnitude. */
TEST(ForEachFarthest, NeverLeavesOutTheFarthestVertex) {
  RandomScene random(43);
  std::size_t visited = 0;
  for (int i = 0; i < 4000; ++i) {
    const double size = random.Power(-160, 100);
    const Eigen::Vector3d n = random.Power(-160, 100) * random.Point(1);
    std::vector<Eigen::Vector3d> vertices = random.SomeHull(size, 40).vertices;
    if (i % 2 == 0) {
      const double off = random.Power(-18, -10);
      for (Eigen::Vector3d& v : vertices)
        v = size * (n.unitOrthogonal() * random.Uniform(-1, 1) + off * random.Point(1));
    }
    const double unsure = i % 3 == 0 ? 0 : random.Power(-18, -6);
    const Eigen::Vector3d error = unsure * n.cwiseAbs();
    const Eigen::Vector3d actual = n + error.cwiseProduct(random.Point(1));
    const std::vector<std::size_t> found = VisitedOf(vertices, n, error);
    visited += found.size();
    EXPECT_TRUE(std::ranges::count(found, FarthestOf(vertices, actual)) == 1) << i;
    if (unsure == 0 && i % 2 == 1) {
      EXPECT_EQ(found.size(), 1U) << i;
    }
  }
  EXPECT_GT(visited, 4000U * 5);
}

// Precise has directions that doubles round to nothing.
TEST(ForEachFarthest, VisitsAllWhereTheDirectionUnderflows) {
  const double least = std::numeric_limits<double>::denorm_min();
  const std::vector<Eigen::Vector3d> vertices = {{0, 1e100, 0}, {0, 0, 1.2e100}};
  EXPECT_EQ(VisitedOf(vertices, {0, least, least}, {0, 0, 0}).size(), 2U);
}

TEST(ForEachFarthest, VisitsAllWhereNumbersOverflow) {
  const std::vector<Eigen::Vector3d> vertices(3, Eigen::Vector3d(1e300, -1e300, 0));
  EXPECT_EQ(VisitedOf(vertices, {1e300, 1e300, 0}, {0, 0, 0}).size(), 3U);
}

}  // namespace
}  // namespace touchstone
