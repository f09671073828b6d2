#include "scenarios/generators/hull_facets.h"

#include "scenarios/generators/portable_math.h"

namespace touchstone {
namespace {

/** Returns +1 if all other vertices are below the plane of i, j, k, −1 if all are above,
 0 if the plane cuts the hull. */
int SideOfOthers(const std::vector<Eigen::Vector3d>& v, std::size_t i, std::size_t j,
                 std::size_t k, const Eigen::Vector3d& n) {
  bool above = false, below = false;
  for (std::size_t other = 0; other < v.size(); ++other) {
    if (other == i || other == j || other == k) continue;
    (Dot(n, v[other] - v[i]) > 0 ? above : below) = true;
  }
  if (above && below) return 0;
  return above ? -1 : 1;
}

}  // namespace

std::vector<Facet> FacetsOf(const ConvexHull& hull) {
  const std::vector<Eigen::Vector3d>& v = hull.vertices;
  std::vector<Facet> facets;
  for (std::size_t i = 0; i < v.size(); ++i) {
    for (std::size_t j = i + 1; j < v.size(); ++j) {
      for (std::size_t k = j + 1; k < v.size(); ++k) {
        const Eigen::Vector3d n = Cross(v[j] - v[i], v[k] - v[i]);
        const int side = SideOfOthers(v, i, j, k, n);
        if (side != 0) facets.push_back({{i, j, k}, side * Unit(n)});
      }
    }
  }
  return facets;
}

}  // namespace touchstone
