#include "scenarios/convex_facets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include <Eigen/Geometry>

namespace touchstone {
namespace {

using Eigen::Vector3d;
using Vertices = std::vector<Vector3d>;
using Triangle = std::array<int, 3>;  // Counterclockwise seen from outside.
using Edge = std::pair<int, int>;

// An exact sum of doubles, stored as non-overlapping numbers other than zero, smallest
// first: Shewchuk, "Adaptive Precision Floating-Point Arithmetic" (1997), GROW-EXPANSION
// with zero elimination, theorem 10.
class ExactSum {
 public:
  void Add(double x) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      const double part = parts_[i];
      const double sum = x + part;
      const double rounded = sum - x;
      const double error = (x - (sum - rounded)) + (part - rounded);
      if (error != 0) parts_[kept++] = error;
      x = sum;
    }
    parts_.resize(kept);
    if (x != 0) parts_.push_back(x);
  }

  void AddProduct(double x, double y, double z) {
    const double xy = x * y;
    const double xy_error = std::fma(x, y, -xy);
    for (const double factor : {xy_error, xy}) {
      Add(std::fma(factor, z, -(factor * z)));
      Add(factor * z);
    }
  }

  int sign() const {
    if (parts_.empty()) return 0;
    return parts_.back() > 0 ? 1 : -1;
  }

 private:
  std::vector<double> parts_;
};

// The exact sign of (b − a) × (c − a) · (d − a): positive if d is above the triangle abc.
// It is written as a sum of four triple products of the coordinates themselves, since
// differences such as b − a would be rounded.
int ExactSide(const Vector3d& a, const Vector3d& b, const Vector3d& c,
              const Vector3d& d) {
  ExactSum sum;
  const auto add_triple_product = [&](double sign, const Vector3d& p, const Vector3d& q,
                                      const Vector3d& r) {
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3;
      const int k = (i + 2) % 3;
      sum.AddProduct(sign * p[i], q[j], r[k]);
      sum.AddProduct(-sign * p[i], q[k], r[j]);
    }
  };
  add_triple_product(1, b, c, d);
  add_triple_product(-1, a, c, d);
  add_triple_product(1, a, b, d);
  add_triple_product(-1, a, b, c);
  return sum.sign();
}

int Side(const Vector3d& a, const Vector3d& b, const Vector3d& c, const Vector3d& d) {
  const Vector3d u = b - a;
  const Vector3d v = c - a;
  const Vector3d w = d - a;
  const double det = u.cross(v).dot(w);
  const double permanent =
      (std::abs(u.y() * v.z()) + std::abs(u.z() * v.y())) * std::abs(w.x()) +
      (std::abs(u.z() * v.x()) + std::abs(u.x() * v.z())) * std::abs(w.y()) +
      (std::abs(u.x() * v.y()) + std::abs(u.y() * v.x())) * std::abs(w.z());
  // Shewchuk, "Adaptive Precision Floating-Point Arithmetic" (1997), section 4.3:
  // (7 + 56 eps) eps permanent, eps = 2^-53. The second condition excludes underflow.
  constexpr double kErrorBound = 8 * 0x1p-53;
  constexpr double kNoUnderflow = 1e-280;
  if (std::abs(det) > kErrorBound * permanent && permanent > kNoUnderflow) {
    return det > 0 ? 1 : -1;
  }
  return ExactSide(a, b, c, d);
}

const Vector3d& At(const Vertices& vertices, int i) {
  return vertices[static_cast<std::size_t>(i)];
}

Vector3d AreaNormal(const Vertices& vertices, const Triangle& t) {
  return (At(vertices, t[1]) - At(vertices, t[0]))
      .cross(At(vertices, t[2]) - At(vertices, t[0]));
}

// Returns the index of the vertex whose `measure` is largest.
template <typename Measure>
int Farthest(const Vertices& vertices, const Measure& measure) {
  int best = 0;
  for (int i = 1; i < static_cast<int>(vertices.size()); ++i) {
    if (measure(At(vertices, i)) > measure(At(vertices, best))) best = i;
  }
  return best;
}

// A tetrahedron of vertices as triangles; empty if all vertices are within `flatness` of
// a plane.
std::vector<Triangle> FirstTetrahedron(const Vertices& vertices, double flatness) {
  const Vector3d& p0 = vertices[0];
  const int i1 = Farthest(vertices, [&](const Vector3d& x) { return (x - p0).norm(); });
  const Vector3d along = At(vertices, i1) - p0;
  if (along.norm() <= flatness) return {};
  const int i2 = Farthest(vertices, [&](const Vector3d& x) {
    return along.normalized().cross(x - p0).norm();
  });
  const Vector3d n = along.normalized().cross(At(vertices, i2) - p0);
  if (n.norm() <= flatness) return {};
  const int i3 = Farthest(
      vertices, [&](const Vector3d& x) { return std::abs(n.normalized().dot(x - p0)); });
  if (std::abs(n.normalized().dot(At(vertices, i3) - p0)) <= flatness) return {};
  const int side = Side(p0, At(vertices, i1), At(vertices, i2), At(vertices, i3));
  if (side == 0) return {};
  const int b = side < 0 ? i1 : i2;
  const int c = side < 0 ? i2 : i1;
  return {{0, b, c}, {0, c, i3}, {c, b, i3}, {b, 0, i3}};
}

// The boundary of the hull as triangles. Signs are exact, so it stays closed and convex.
std::vector<Triangle> Triangulate(const Vertices& vertices, double flatness) {
  std::vector<Triangle> triangles = FirstTetrahedron(vertices, flatness);
  if (triangles.empty()) return {};
  for (int i = 0; i < static_cast<int>(vertices.size()); ++i) {
    std::set<Edge> seen_edges;
    std::vector<Triangle> kept;
    for (const Triangle& t : triangles) {
      const bool is_corner = std::ranges::find(t, i) != t.end();
      if (!is_corner && Side(At(vertices, t[0]), At(vertices, t[1]), At(vertices, t[2]),
                             At(vertices, i)) > 0) {
        seen_edges.insert({{t[0], t[1]}, {t[1], t[2]}, {t[2], t[0]}});
      } else {
        kept.push_back(t);
      }
    }
    for (const Edge& edge : seen_edges) {
      const bool on_horizon = !seen_edges.contains({edge.second, edge.first});
      if (on_horizon) kept.push_back({edge.first, edge.second, i});
    }
    triangles = std::move(kept);
  }
  return triangles;
}

// The boundary of a connected set of triangles; empty if it is not one simple polygon.
std::vector<int> BoundaryOf(const std::vector<Triangle>& patch) {
  std::set<Edge> edges;
  for (const Triangle& t : patch) {
    edges.insert({{t[0], t[1]}, {t[1], t[2]}, {t[2], t[0]}});
  }
  std::map<int, int> next;
  for (const Edge& edge : edges) {
    if (edges.contains({edge.second, edge.first})) continue;
    if (!next.emplace(edge).second) return {};
  }
  std::vector<int> loop;
  int at = next.begin()->first;
  do {
    loop.push_back(at);
    at = next.at(at);
  } while (at != loop.front() && loop.size() <= next.size());
  if (loop.size() != next.size()) return {};
  return loop;
}

// Merges triangles into polygons. Each polygon grows from the largest remaining triangle,
// whose plane is the most accurate: so a sliver at an edge cannot bridge two real faces.
std::vector<std::vector<int>> MergeCoplanar(const Vertices& vertices,
                                            std::vector<Triangle> triangles,
                                            double flatness) {
  std::ranges::stable_sort(triangles, std::greater<>(), [&](const Triangle& t) {
    return AreaNormal(vertices, t).squaredNorm();
  });
  std::map<Edge, std::size_t> owner;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const Triangle& t = triangles[i];
    for (std::size_t k = 0; k < 3; ++k) owner[{t[k], t[(k + 1) % 3]}] = i;
  }
  std::vector<bool> taken(triangles.size(), false);
  std::vector<std::vector<int>> polygons;
  for (std::size_t seed = 0; seed < triangles.size(); ++seed) {
    if (taken[seed]) continue;
    const Vector3d n = AreaNormal(vertices, triangles[seed]).normalized();
    const double offset = n.dot(At(vertices, triangles[seed][0]));
    std::vector<std::size_t> members = {seed};
    taken[seed] = true;
    for (std::size_t next = 0; next < members.size(); ++next) {
      const Triangle t = triangles[members[next]];
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t neighbour = owner.at({t[(k + 1) % 3], t[k]});
        const bool coplanar = std::ranges::all_of(triangles[neighbour], [&](int corner) {
          return std::abs(n.dot(At(vertices, corner)) - offset) <= flatness;
        });
        if (taken[neighbour] || !coplanar) continue;
        taken[neighbour] = true;
        members.push_back(neighbour);
      }
    }
    std::vector<Triangle> patch;
    patch.reserve(members.size());
    for (const std::size_t member : members) patch.push_back(triangles[member]);
    std::vector<int> loop = BoundaryOf(patch);
    if (!loop.empty()) {
      polygons.push_back(std::move(loop));
    } else {
      for (const Triangle& t : patch) polygons.push_back({t[0], t[1], t[2]});
    }
  }
  return polygons;
}

// Removes vertices that belong to only two polygons: they lie on an edge and are no
// corners.
void DropEdgePoints(std::vector<std::vector<int>>& polygons) {
  std::map<int, int> polygons_at;
  for (const auto& polygon : polygons) {
    for (const int corner : polygon) ++polygons_at[corner];
  }
  for (auto& polygon : polygons) {
    std::erase_if(polygon, [&](int corner) { return polygons_at.at(corner) < 3; });
  }
  std::erase_if(polygons, [](const auto& polygon) { return polygon.size() < 3; });
}

// Newell's normal, a least-squares fit for polygons that are flat only to rounding.
Vector3d PolygonNormal(const Vertices& vertices, const std::vector<int>& polygon) {
  Vector3d sum = Vector3d::Zero();
  const Vector3d& origin = At(vertices, polygon[0]);
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    sum +=
        (At(vertices, polygon[i]) - origin).cross(At(vertices, polygon[i + 1]) - origin);
  }
  return sum.normalized();
}

}  // namespace

std::optional<ConvexFacets> BoundaryOf(const ConvexHull& hull) {
  double size = 0;
  for (const Vector3d& vertex : hull.vertices) {
    size = std::max(size, vertex.lpNorm<Eigen::Infinity>());
  }
  const double flatness = kFlatness * size;
  std::vector<Triangle> triangles = Triangulate(hull.vertices, flatness);
  if (triangles.empty()) return std::nullopt;
  std::vector<std::vector<int>> polygons =
      MergeCoplanar(hull.vertices, std::move(triangles), flatness);
  DropEdgePoints(polygons);

  // Corners keep the order of the vertices, which decides ties in the engines' support
  // functions.
  ConvexFacets result;
  std::map<int, int> corner_of;
  for (const auto& polygon : polygons) {
    for (const int vertex : polygon) corner_of[vertex] = 0;
  }
  for (auto& [vertex, corner] : corner_of) {
    corner = static_cast<int>(result.corners.size());
    result.corners.push_back(At(hull.vertices, vertex));
  }
  for (const auto& polygon : polygons) {
    ConvexFacet facet;
    facet.n_B = PolygonNormal(hull.vertices, polygon);
    for (const int vertex : polygon) facet.corners.push_back(corner_of.at(vertex));
    result.facets.push_back(std::move(facet));
  }
  result.centre = Vector3d::Zero();
  for (const Vector3d& corner : result.corners) result.centre += corner;
  result.centre /= static_cast<double>(result.corners.size());
  for (ConvexFacet& facet : result.facets) {
    facet.offset = -std::numeric_limits<double>::infinity();
    for (const Vector3d& corner : result.corners) {
      facet.offset = std::max(facet.offset, facet.n_B.dot(corner));
    }
  }
  return result;
}

}  // namespace touchstone
